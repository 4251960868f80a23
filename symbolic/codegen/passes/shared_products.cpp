// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/shared_products.hpp"

#include <algorithm>

namespace magicmass::codegen {
namespace {

// The factors of `node` without those of `part`; empty if some are not there.
std::vector<int> without(const std::vector<int>& factors, const std::vector<int>& part) {
  std::vector<int> rest = factors;
  for (const int factor : part) {
    const auto found = std::find(rest.begin(), rest.end(), factor);
    if (found == rest.end()) return {};
    rest.erase(found);
  }
  return rest;
}

// Whether a node needs another, or is it.
bool follows(const Program& program, int number, std::size_t other) {
  if (static_cast<std::size_t>(number) == other) return true;
  const std::vector<int>& args = program.nodes[static_cast<std::size_t>(number)].args;
  return std::any_of(args.begin(), args.end(),
                     [&](int argument) { return follows(program, argument, other); });
}

}  // namespace

Program shared_products(const Program& program) {
  Program result = program;
  // larger products first, so that the most is shared; among equals in the program's order
  std::vector<std::size_t> products;
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    if (program.nodes[i].op == Op::multiply) products.push_back(i);
  std::stable_sort(products.begin(), products.end(), [&](std::size_t x, std::size_t y) {
    return program.nodes[x].args.size() > program.nodes[y].args.size();
  });
  for (const std::size_t inner : products)
    for (std::size_t outer = 0; outer < result.nodes.size(); ++outer) {
      Node& node = result.nodes[outer];
      if (node.op != Op::multiply || follows(result, static_cast<int>(inner), outer)) continue;
      const std::vector<int> rest = without(node.args, result.nodes[inner].args);
      if (rest.empty()) continue;
      node.args = rest;
      node.args.push_back(static_cast<int>(inner));
    }
  return rebuilt(result, [](Program& kept, const Node& node) { return append(kept, node); });
}

}  // namespace magicmass::codegen
