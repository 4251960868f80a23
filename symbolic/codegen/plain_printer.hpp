// SPDX-License-Identifier: GPL-2.0-or-later
// Terms as C++ of any number type, each with its range.
#pragma once

#include <map>
#include <set>
#include <string>

#include "codegen/interval.hpp"
#include "kernel/expr.hpp"

namespace codegen {
/// What a term is in C++, and where its values are.
struct Printed {
  std::string text;
  Interval range = {0, 0};
};
/// Numbers of doubles' precision and exponents, or better, do not over- or underflow up to there.
constexpr double plain_largest = 0x1p1000;
constexpr double plain_smallest = 0x1p-1000;

std::string without_brackets(const std::string& s);  ///< around the whole of it

class PlainPrinter {
public:
  bool is_exact = false;  ///< for any field: no ranges, no function of <cmath>
  std::map<kernel::Expr, Printed> names;
  std::set<std::string> functions;  ///< of <cmath>, that were printed

  /// Refused: a name without a definition; unless exact, what may over- or underflow, a divisor
  /// that may be 0, a root of what may be negative.
  Printed print(kernel::Expr e, bool in_product = false);
  static bool is_function(kernel::Expr e);

private:
  Printed number(const cln::cl_RA& q) const;
  Printed sum(kernel::Expr e, bool in_product);
  Printed product(kernel::Expr e);
  Printed power(kernel::Expr e);
  Printed call(kernel::Expr e);
  Printed checked(std::string text, kernel::Expr e, Interval range) const;
  template <class Operation>
  Interval ranged(const Operation& operation) const;
};
}  // namespace codegen
