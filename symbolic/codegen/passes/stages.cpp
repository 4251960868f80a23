#include <algorithm>

#include "codegen/lower.hpp"

namespace codegen {
Program in_stages(const Program& p) {
  Program r = p;
  for (Node& n : r.nodes)
    for (int o : n.of) {
      const Op op = r[o].op;
      const bool ends = op == Op::arc_tangent || op == Op::sine || op == Op::cosine;
      n.stage = std::min(3, std::max(n.stage, r[o].stage + (ends ? 1 : 0)));
    }
  return r;
}
}  // namespace codegen
