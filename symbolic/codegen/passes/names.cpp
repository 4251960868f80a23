#include "codegen/lower.hpp"

namespace codegen {
Program named(const Program& p) {
  Program r = p;
  std::set<std::string> taken{"T", "N", "E", "Tier", "doubt", "columns", "row", "in", "tested"};
  for (const Result& out : p.results)
    if (out.kind == Result::real && p[out.node].name != out.name) taken.insert(out.name);
  for (const Node& n : p.nodes)
    if (!n.name.empty() && !taken.insert(n.name).second)
      throw Refused("two values are called " + n.name);
  const auto fresh = [&](const std::string& wanted, bool numbered) {
    for (int k = 1;; ++k) {
      const std::string name = wanted + (numbered || k > 1 ? std::to_string(k) : "");
      if (taken.insert(name).second) return name;
    }
  };
  for (const Result& out : p.results) {
    std::string& name = r[out.node].name;
    const bool is_open = name.empty() && out.kind != Result::whole;
    if (is_open) name = fresh((out.kind == Result::real ? "of_" : "") + out.name, false);
  }
  std::set<int> angles;
  for (const Node& n : r.nodes)
    if (n.op == Op::sine || n.op == Op::cosine) angles.insert(n.of[0]);
  for (int k = 0; k < r.size(); ++k) {
    Node& n = r[k];
    if (!n.name.empty() || n.op == Op::constant) continue;
    const bool is_negative = n.op == Op::scale && n.factor == -1 && !n.is_exact;
    n.name = is_negative && !angles.contains(k) ? "-" + r[n.of[0]].name : fresh("t", true);
  }
  return r;
}
}  // namespace codegen
