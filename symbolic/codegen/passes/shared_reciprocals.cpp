// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/shared_reciprocals.hpp"

#include <algorithm>

namespace magicmass::codegen {

Program shared_reciprocals(const Program& program) {
  const std::vector<int> uses = use_counts(program);
  // A reciprocal that several use, or that is a value with a name of its own, stays.
  std::vector<bool> fused(program.nodes.size());
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    fused[i] =
        program.nodes[i].op == Op::reciprocal && uses[i] == 1 && program.nodes[i].name.empty();

  Program result;
  std::vector<int> renumbered(program.nodes.size());
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {  // arguments come first
    Node node = program.nodes[i];
    std::vector<int> divisors;
    if (node.op == Op::multiply)
      std::erase_if(node.args, [&](int argument) {
        if (!fused[static_cast<std::size_t>(argument)]) return false;
        const Node& reciprocal = program.nodes[static_cast<std::size_t>(argument)];
        divisors.push_back(renumbered[static_cast<std::size_t>(reciprocal.args[0])]);
        return true;
      });
    for (int& argument : node.args) argument = renumbered[static_cast<std::size_t>(argument)];
    if (divisors.empty()) {
      renumbered[i] = append(result, node);
      continue;
    }
    if (node.args.empty())
      node.args.push_back(append(result, {.op = Op::constant, .numerator = 1}));
    int quotient = node.args.size() == 1 ? node.args[0]
                                         : append(result, {.op = Op::multiply, .args = node.args});
    for (const int divisor : divisors)
      quotient = append(result, {.op = Op::divide, .args = {quotient, divisor}});
    result.nodes.back().name = node.name;
    result.nodes.back().origin = node.origin;
    renumbered[i] = quotient;
  }
  for (const Output& output : program.outputs)
    result.outputs.push_back(
        {output.name, renumbered[static_cast<std::size_t>(output.node)], output.theorem});
  return rebuilt(result, [](Program& kept, const Node& node) { return append(kept, node); });
}

}  // namespace magicmass::codegen
