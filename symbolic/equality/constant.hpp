// SPDX-License-Identifier: GPL-2.0-or-later
// Constants: enclosed by balls, and their exact signs.
#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "balls/ball.hpp"
#include "kernel/expr.hpp"

namespace equality {
using balls::Ball;
using balls::NotCertain;
using kernel::Expr;
using kernel::Exprs;

/// The term has no real value: "the square root of a negative number". One line.
struct NotDefined : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// The value of a term without variables, with so many bits behind the point. Throws NotDefined
/// where that is certain, balls::NotCertain where more bits may help.
Ball enclosure(Expr constant, int bits);
/// The same with the bits that balls have now, and values for symbols and for whole terms.
Ball enclosure(Expr term, const std::map<Expr, Ball>& values);
/// -1, 0 or 1, exactly; nothing where neither bits nor a bound of separation decide it. Algebraic
/// numbers (roots, cosines and sines of rational multiples of pi) of up to 60,000 bits are decided.
/// Throws NotDefined.
std::optional<int> exact_sign(Expr constant);
/// Whether it is built by +, *, quotients and roots from rationals and cosines and sines of
/// rational multiples of pi.
bool is_algebraic(Expr constant);
/// The rational q with e = q pi, if e is written so.
std::optional<cln::cl_RA> multiple_of_pi(Expr e);
/// The fraction of such a denominator that is within 10^-9 of the value.
std::optional<cln::cl_RA> near_fraction(const cln::cl_RA& value, int largest_denominator);
bool is_function(Expr e, const char* name);
}  // namespace equality
