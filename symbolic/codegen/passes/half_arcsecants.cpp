// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/half_arcsecants.hpp"

#include <algorithm>
#include <stdexcept>

namespace magicmass::codegen {

Program half_arcsecants(const Program& program) {
  int angles = 0;
  const Program result = rebuilt(program, [&angles](Program& made, const Node& node) {
    if (node.op != Op::arctangent) return append(made, node);
    if (made.nodes[static_cast<std::size_t>(node.args[0])].name != "tan_quarter")
      throw std::logic_error("an arctangent of something else than tan_quarter");
    ++angles;
    const int alpha = append(made, {.op = Op::input, .name = "alpha"});
    return append(made, {.op = Op::half_arcsecant, .args = {alpha, node.args[0]}});
  });
  if (angles != 1)
    throw std::logic_error("a program has " + std::to_string(angles) + " arctangents");
  return result;
}

}  // namespace magicmass::codegen
