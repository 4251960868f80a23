// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/flat_products.hpp"

#include <numeric>

#include "codegen/exact_product.hpp"

namespace magicmass::codegen {
namespace {

// One step in: products of products whose inner one has no other use.
Program joined(const Program& program) {
  const std::vector<int> uses = use_counts(program);
  Program result = program;
  for (Node& node : result.nodes) {
    if (node.op != Op::multiply) continue;
    std::vector<int> flat;
    for (const int argument : node.args) {
      const Node& inner = result.nodes[static_cast<std::size_t>(argument)];
      if (inner.op == Op::multiply && uses[static_cast<std::size_t>(argument)] == 1)
        flat.insert(flat.end(), inner.args.begin(), inner.args.end());
      else
        flat.push_back(argument);
    }
    node.args = flat;
  }
  return rebuilt(result, [](Program& kept, const Node& node) { return append(kept, node); });
}

Program constants_folded(const Program& program) {
  return rebuilt(program, [](Program& result, const Node& node) {
    if (node.op != Op::multiply) return append(result, node);
    Node folded{.op = Op::constant};
    folded.numerator = 1;
    Node rest = node;
    rest.args.clear();
    for (const int argument : node.args) {
      const Node& part = result.nodes[static_cast<std::size_t>(argument)];
      if (part.op == Op::constant) {
        folded.numerator = exact_product(folded.numerator, part.numerator);
        folded.denominator = exact_product(folded.denominator, part.denominator);
      } else {
        rest.args.push_back(argument);
      }
    }
    const std::int64_t common = std::gcd(folded.numerator, folded.denominator);
    folded.numerator /= common;
    folded.denominator /= common;
    if (folded.numerator != 1 || folded.denominator != 1 || rest.args.empty())
      rest.args.insert(rest.args.begin(), append(result, folded));
    return rest.args.size() == 1 ? rest.args[0] : append(result, rest);
  });
}

}  // namespace

Program flat_products(const Program& program) { return constants_folded(joined(program)); }

}  // namespace magicmass::codegen
