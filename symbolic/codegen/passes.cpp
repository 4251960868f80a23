// SPDX-License-Identifier: GPL-2.0-or-later
// From program to program.
#include <algorithm>

#include "codegen/program.hpp"
#include "codegen/quantity.hpp"

namespace codegen {
Program without_dead_code(const Program& p) {
  std::vector<int> place(p.nodes.size(), -1);  // -1: not needed
  const auto at = [&](int k) -> int& { return place[std::size_t(k)]; };
  for (const Result& r : p.results) at(r.node) = 0;
  for (int k = p.size(); k-- > 0;) {
    if (p[k].op == Op::input) at(k) = 0;
    if (at(k) < 0) continue;
    for (int o : p[k].of) at(o) = 0;
  }
  Program r = p;
  r.nodes.clear();
  for (int k = 0; k < p.size(); ++k) {
    if (at(k) < 0) continue;
    at(k) = r.size();
    r.nodes.push_back(p[k]);
    for (int& o : r.nodes.back().of) o = at(o);
  }
  for (Result& result : r.results) result.node = at(result.node);
  for (SizeFact& f : r.facts) f = {at(f.small), at(f.large), f.is_of_computed};
  std::erase_if(r.facts, [](const SizeFact& f) { return f.small < 0 || f.large < 0; });
  return r;
}
Program in_stages(const Program& p) {
  Program r = p;
  for (Node& n : r.nodes) {
    for (int o : n.of) {
      const Op op = r[o].op;
      const bool ends = op == Op::arc_tangent || op == Op::sine || op == Op::cosine;
      n.stage = std::min(3, std::max(n.stage, r[o].stage + (ends ? 1 : 0)));
    }
  }
  return r;
}
std::string identifier(const std::string& name) {
  return name.ends_with("'") ? name.substr(0, name.size() - 1) + "_prime" : name;
}
std::string Input::name() const { return identifier(variable.name()); }

Program named(const Program& p) {
  Program r = p;
  std::set<std::string> taken{"T",     "N",       "R",   "E",  "Tier",
                              "doubt", "columns", "row", "in", "tested"};
  for (const Result& out : p.results)
    if (out.kind == Result::real && p[out.node].name != out.name) taken.insert(out.name);
  for (const Node& n : p.nodes) {
    if (n.name.empty()) continue;
    if (!taken.insert(n.name).second) throw Refused("two values are called " + n.name);
  }
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
