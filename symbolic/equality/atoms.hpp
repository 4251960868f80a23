// SPDX-License-Identifier: GPL-2.0-or-later
// The atoms of a normal form that stand for no symbol, and exponents.
#pragma once

#include "equality/normal_form.hpp"

namespace equality {
Expr circle();  ///< z, the point of the unit circle: z^u = cos(u) + i sin(u)
Expr euler();   ///< exp(1)
Expr absolute(Expr e);
Sum number(const cln::cl_RA& q);
Sum atom(Expr e, const Exponent& exponent = {{{}, 1}});
Sum imaginary();  ///< i = z^(pi/2)
Sum operator+(const Sum& a, const Sum& b);
Sum operator-(const Sum& a, const Sum& b);
Sum scaled(const Sum& a, const cln::cl_RA& q);
Exponent exponent(const cln::cl_RA& q);
Exponent times_pi(const cln::cl_RA& q);
Exponent exponent_in(const Product& product, Expr atom);  ///< 0 where it is absent
cln::cl_RA constant_part(const Exponent& e);
/// The exponent, if it is a number.
std::optional<cln::cl_RA> number_of(const Exponent& e);
std::optional<int> whole_number(const Exponent& e);
bool is_whole(const cln::cl_RA& q);
bool is_even(const cln::cl_RA& whole);
bool is_inverse_angle(Expr e);
void multiply(Product& into, Expr atom, const Exponent& exponent);
/// What cannot be computed is not proved.
template <class Question>
bool is_proved(const Question& question) {
  try {
    return question();
  } catch (const std::runtime_error&) {
    return false;
  }
}
}  // namespace equality
