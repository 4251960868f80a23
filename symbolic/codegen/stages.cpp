// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/stages.hpp"

#include <algorithm>

namespace magicmass::codegen {

bool ends_a_stage(const Node& node) {
  return node.op == Op::reciprocal_square_root || node.op == Op::square_root ||
         node.op == Op::arctangent || node.op == Op::half_arcsecant || node.op == Op::sine ||
         node.op == Op::cosine || node.op == Op::secant_less_one;
}

Stages stages_of(const Program& program, bool cuts_turns) {
  Stages stages{std::vector<int>(program.nodes.size(), 0), 1};
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    for (const int argument : program.nodes[i].args) {
      const auto of = static_cast<std::size_t>(argument);
      const bool is_turn = program.nodes[i].op == Op::sine || program.nodes[i].op == Op::cosine;
      const bool is_cut = ends_a_stage(program.nodes[of]) || (cuts_turns && is_turn);
      const int after = stages.stage[of] + (is_cut ? 1 : 0);
      stages.stage[i] = std::max(stages.stage[i], after);
      stages.count = std::max(stages.count, after + 1);
    }
  return stages;
}

int degree_of(const Program& program, int number) {
  const Node& node = program.nodes[static_cast<std::size_t>(number)];
  if (ends_a_stage(node)) return 1;
  const bool is_product = node.op == Op::multiply || node.op == Op::divide;
  int degree = 0;
  for (const int argument : node.args) {
    const int of_argument = degree_of(program, argument);
    degree = is_product ? degree + of_argument : std::max(degree, of_argument);
  }
  return degree;
}

int depth_of(const Program& program, int number) {
  int depth = 0;
  for (const int argument : program.nodes[static_cast<std::size_t>(number)].args)
    depth = std::max(depth, depth_of(program, argument) + 1);
  return depth;
}

}  // namespace magicmass::codegen
