// SPDX-License-Identifier: GPL-2.0-or-later
// From the kernel's terms to nodes.
#pragma once

#include <map>

#include "codegen/builder.hpp"
#include "codegen/quantity.hpp"

namespace codegen {
class Terms {
public:
  explicit Terms(Numbers numbers) : builder(numbers) {}
  Builder builder;
  std::map<kernel::Expr, int> nodes;  ///< of what is known: inputs, names, terms already built
  std::map<int, int> squares;         ///< nodes, for arctangents

  /// Refused: a name without a definition, an operation that there is none for.
  int build(kernel::Expr e);
  Interval range(kernel::Expr e) { return builder[build(e)].range; }

private:
  struct Fraction;
  static Fraction fraction(const kernel::Exprs& factors);
  int made(kernel::Expr e);
  int function(kernel::Expr e);
  int square_root(kernel::Expr x);
  int arc_tangent(kernel::Expr e);
  int product(const kernel::Exprs& factors);
  int plain_product(const Fraction& f);
  int ceiling(kernel::Expr x);
};
}  // namespace codegen
