// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/paired_sine_cosine.hpp"

namespace magicmass::codegen {

Program paired_sine_cosine(const Program& program) {
  Program result;
  std::vector<int> renumbered(program.nodes.size(), -1);
  const auto place = [&](std::size_t i) {
    if (renumbered[i] >= 0) return;
    Node node = program.nodes[i];
    for (int& argument : node.args) argument = renumbered[static_cast<std::size_t>(argument)];
    renumbered[i] = append(result, node);
  };
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    place(i);
    const Op op = program.nodes[i].op;
    if (op != Op::sine && op != Op::cosine) continue;
    const Op partner = op == Op::sine ? Op::cosine : Op::sine;
    for (std::size_t j = i + 1; j < program.nodes.size(); ++j)
      if (program.nodes[j].op == partner && program.nodes[j].args == program.nodes[i].args)
        place(j);
  }
  for (const Output& output : program.outputs)
    result.outputs.push_back(
        {output.name, renumbered[static_cast<std::size_t>(output.node)], output.theorem});
  return result;
}

}  // namespace magicmass::codegen
