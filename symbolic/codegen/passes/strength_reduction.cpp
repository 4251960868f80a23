// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/strength_reduction.hpp"

#include "codegen/exact_product.hpp"

namespace magicmass::codegen {
namespace {

// base^exponent by repeated squaring, exponent >= 1.
int integer_power(Program& result, int base, std::int64_t exponent) {
  if (exponent == 1) return base;
  if (exponent % 2 == 0) {
    const int half = integer_power(result, base, exponent / 2);
    return append(result, {.op = Op::multiply, .args = {half, half}});
  }
  const int rest = integer_power(result, base, exponent - 1);
  return append(result, {.op = Op::multiply, .args = {base, rest}});
}

int power(Program& result, const Node& node) {
  const int base = node.args[0];
  if (node.denominator == 1) return integer_power(result, base, node.numerator);
  const int root = append(result, {.op = Op::square_root, .args = {base}});
  if (node.numerator == 1) return root;
  const int whole = integer_power(result, base, (node.numerator - 1) / 2);
  return append(result, {.op = Op::multiply, .args = {whole, root}});
}

// 1 * x is x; 2 * (3 * x) keeps its shape: only constants side by side are folded.
int product(Program& result, const Node& node) {
  Node folded{.op = Op::constant, .numerator = 1};
  Node rest{.op = Op::multiply};
  for (const int argument : node.args) {
    const Node& part = result.nodes[static_cast<std::size_t>(argument)];
    if (part.op == Op::constant && part.name.empty()) {
      folded.numerator = exact_product(folded.numerator, part.numerator);
      folded.denominator = exact_product(folded.denominator, part.denominator);
    } else {
      rest.args.push_back(argument);
    }
  }
  if (folded.numerator != folded.denominator || rest.args.empty())
    rest.args.insert(rest.args.begin(), append(result, folded));
  return rest.args.size() == 1 ? rest.args[0] : append(result, rest);
}

}  // namespace

Program strength_reduction(const Program& program) {
  return rebuilt(program, [](Program& result, const Node& node) {
    if (node.op != Op::power && node.op != Op::multiply) return append(result, node);
    const int number = node.op == Op::power ? power(result, node) : product(result, node);
    Node& made = result.nodes[static_cast<std::size_t>(number)];
    if (!node.name.empty() && made.name.empty()) {
      made.name = node.name;
      made.origin = node.origin;
    }
    return number;
  });
}

}  // namespace magicmass::codegen
