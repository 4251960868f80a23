// SPDX-License-Identifier: GPL-2.0-or-later
// The atoms of a normal form that stand for no symbol, and exponents.
#pragma once

#include "equality/normal_form.hpp"

namespace equality {
Expr circle();  ///< z, the point of the unit circle: z^u = cos(u) + i sin(u)
Expr euler();   ///< exp(1)
Expr absolute(Expr e);
Sum number(const cln::cl_RA& q);
Sum atom(Expr e);  ///< e^1
Sum operator+(const Sum& a, const Sum& b);
Sum operator-(const Sum& a, const Sum& b);
Sum scaled(const Sum& a, const cln::cl_RA& q);
Exponent exponent(const cln::cl_RA& q);
cln::cl_RA constant_part(const Exponent& e);
/// The exponent, if it is a number.
std::optional<cln::cl_RA> number_of(const Exponent& e);
bool is_whole(const cln::cl_RA& q);
bool is_even(const cln::cl_RA& whole);
void multiply(Product& into, Expr atom, const Exponent& exponent);
}  // namespace equality
