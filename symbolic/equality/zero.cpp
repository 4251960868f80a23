// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a normal form is 0: quotients are cleared, sums multiplied out, and what is left is a sum
// of numbers times different functions, where each of the numbers must be 0.
#include <algorithm>

#include "equality/normal_form.hpp"

namespace equality {
using kernel::Op;
namespace {
constexpr int highest_power = 3000;
}

// The sum without its composite atoms, but for roots, to be multiplied by `divisor`.
Sum Forms::expanded(Sum sum, Product* divisor) {
  for (;;) {
    Expr newest;  // it holds older ones
    for (const auto& [product, q] : sum)
      for (const auto& [atom, e] : product)
        if (composites.contains(atom) && cln::floor1(constant_part(e)) != 0 &&
            (!newest || newest < atom))
          newest = atom;
    if (!newest) return sum;
    const auto whole = [&](const Product& product) {
      return cln::floor1(constant_part(exponent_in(product, newest)));
    };
    cln::cl_I least = whole(sum.begin()->first);
    for (const auto& [product, q] : sum) least = cln::min(least, whole(product));
    if (divisor) multiply(*divisor, newest, exponent(cln::cl_RA(least)));
    std::map<cln::cl_I, Sum> by_power;
    for (const auto& [product, q] : sum) {
      const cln::cl_I k = whole(product);
      Product rest = product;
      multiply(rest, newest, exponent(-cln::cl_RA(k)));
      by_power[k - least][rest] = q;
    }
    const Sum base = composites.at(newest);
    Sum out;  // Horner's scheme from the highest power
    cln::cl_I at = by_power.rbegin()->first;
    if (at > highest_power) throw TooLarge("a power above 3000 to be multiplied out");
    for (; at >= 0; at = at - 1) {
      out = times(out, base);
      if (const auto it = by_power.find(at); it != by_power.end()) out = out + it->second;
    }
    sum = out;
    if (sum.empty()) return sum;
  }
}
bool Forms::is_zero(const Sum& sum) {
  const kernel::Monomial pi{{kernel::pi(), 1}};
  const auto constant = [&](Expr atom, const Exponent& e) {
    if (atom == circle()) return e.contains(pi) ? times_pi(e.at(pi)) : Exponent();
    const bool is_number = number_of(e) && kernel::free_variables(atom).empty() &&
                           !is_complex(atom) && is_algebraic(atom);
    return is_number ? e : Exponent();
  };
  return std::ranges::all_of(coefficients(expanded(sum), constant),
                             [&](const auto& term) { return is_zero_number(term.second); });
}
bool Forms::is_zero_number(const Sum& coefficient) {
  if (coefficient.size() == 1) return false;
  const Sum other = conjugated(coefficient);
  for (const Sum& part : {coefficient + other, times(imaginary(), coefficient - other)}) {
    const std::optional<Expr> real = real_expression(part);
    if (!real || exact_sign(*real) != 0) return false;
  }
  return true;
}

bool is_zero_constant(Expr constant) {
  static int depth = 0;
  if (depth > 2) return false;
  ++depth;
  Forms forms({});
  const bool is_zero = is_proved([&] { return forms.is_zero(forms.of(constant)); });
  --depth;
  return is_zero;
}
}  // namespace equality
