#include "codegen/lower.hpp"

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
}  // namespace codegen
