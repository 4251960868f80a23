// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/reciprocal_square_roots.hpp"

namespace magicmass::codegen {

Program reciprocal_square_roots(const Program& program) {
  const Program marked = rebuilt(program, [](Program& result, Node node) {
    if (node.op == Op::reciprocal) {
      const Node& of = result.nodes[static_cast<std::size_t>(node.args[0])];
      if (of.op == Op::square_root) {
        node.op = Op::reciprocal_square_root;
        node.args = of.args;
      }
    }
    return append(result, node);
  });
  // roots that nothing uses any more go
  return rebuilt(marked, [](Program& kept, const Node& node) { return append(kept, node); });
}

}  // namespace magicmass::codegen
