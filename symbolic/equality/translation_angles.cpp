// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cstdlib>

#include <cln/integer.h>

#include "equality/angle.hpp"
#include "equality/point.hpp"
#include "equality/translation.hpp"

namespace magicmass::equality {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using proof::NotInClass;

ex Translation::angle_of_constant(const Tree& tree) {
  const LinearForm linear = linear_form(at({}, tree));
  ex total = numeric(linear.of_pi) * GiNaC::Pi;
  for (const auto& [factor, inverse] : linear.terms) {
    if (inverse->name == "log") throw NotInClass("a logarithm in an angle");
    total += numeric(factor) * translated(inverse);
  }
  for (const Tree& rest : linear.rest) {  // an identity for every such angle holds for this one
    const Tree folded = at({}, rest);
    total += is_number(folded) ? ex(numeric(folded->value)) * named("1 radian", number(1))
                               : translated(folded);
  }
  return total;
}

ex Translation::angle(const Tree& tree) {
  const auto sum_of_parts = [this](const auto& self, const Tree& part) -> ex {
    if (part->is_constant) return angle_of_constant(part);
    if (part->kind == Kind::sum) {
      ex total = 0;
      for (const Tree& summand : part->parts) total += self(self, summand);
      return total;
    }
    return translated(part);
  };
  return without_full_turns(sum_of_parts(sum_of_parts, tree).expand());
}

bool Translation::is_integer_valued(const ex& expanded) const {
  if (is_a<numeric>(expanded)) return ex_to<numeric>(expanded).is_integer();
  if (is_a<GiNaC::symbol>(expanded)) return integers_.contains(expanded);
  if (is_a<GiNaC::power>(expanded))
    return is_integer_valued(expanded.op(0)) && expanded.op(1).info(GiNaC::info_flags::posint);
  return (is_a<GiNaC::add>(expanded) || is_a<GiNaC::mul>(expanded)) &&
         std::all_of(expanded.begin(), expanded.end(),
                     [this](const ex& part) { return is_integer_valued(part); });
}

// Whole multiples of asin u, acos u and atan u in an angle: their cosines and sines are algebraic in u, whatever the
// sign of u is. cos asin u = sin acos u = sqrt(1 - u^2) and cos atan u = 1/sqrt(1 + u^2) are never negative.
std::pair<ex, ex> Translation::cosine_and_sine(const Tree& argument) {
  constexpr long largest = 8;
  const LinearForm linear = linear_form(argument);
  ex rest = numeric(linear.of_pi) * GiNaC::Pi;
  for (const Tree& part : linear.rest) rest += angle(part);
  std::vector<std::pair<long, Tree>> whole;
  for (const auto& [factor, inverse] : linear.terms) {
    if (!inverse->is_constant && inverse->name != "log" && is_integer(factor) &&
        cln::abs(factor) <= largest)
      whole.emplace_back(cln::cl_I_to_long(cln::numerator(factor)), inverse);
    else
      rest += angle(product({number(factor), inverse}));
  }
  if (whole.empty()) {
    const ex all = angle(argument);
    return {cos(all), sin(all)};
  }
  rest = without_full_turns(rest.expand());
  ex cosine = cos(rest);
  ex sine = sin(rest);
  for (const auto& [count, inverse] : whole) {
    const ex u = translated(inverse->parts[0]);
    ex c = 1 / sqrt(1 + u * u);
    ex s = u * c;
    if (inverse->name == "asin") {
      c = sqrt(1 - u * u);
      s = u;
    } else if (inverse->name == "acos") {
      c = u;
      s = sqrt(1 - u * u);
    }
    if (count < 0) s = -s;
    for (long i = 0; i < std::labs(count); ++i) {
      const ex next = cosine * c - sine * s;
      sine = sine * c + cosine * s;
      cosine = next;
    }
  }
  return {cosine, sine};
}

// cos and sin do not see 2 pi n m for integers n, m.
ex Translation::without_full_turns(const ex& angle) const {
  ex rest = 0;
  const auto keep = [&](const ex& monomial) {
    bool has_pi = false;
    bool has_integer = false;
    bool is_even = false;
    bool other = false;
    const auto inspect = [&](const ex& part) {
      if (part.is_equal(GiNaC::Pi)) {
        other = other || has_pi;
        has_pi = true;
      } else if (is_a<numeric>(part)) {
        is_even = ex_to<numeric>(part).is_even();
        other = other || !ex_to<numeric>(part).is_integer();
      } else if (integers_.contains(part)) {
        has_integer = true;
      } else if (is_a<GiNaC::power>(part) && integers_.contains(part.op(0)) &&
                 part.op(1).info(GiNaC::info_flags::posint)) {
        has_integer = true;
      } else {
        other = true;
      }
    };
    if (is_a<GiNaC::mul>(monomial))
      for (const ex& part : monomial) inspect(part);
    else
      inspect(monomial);
    if (!(has_pi && has_integer && is_even && !other)) rest += monomial;
  };
  if (is_a<GiNaC::add>(angle))
    for (const ex& monomial : angle) keep(monomial);
  else
    keep(angle);
  return rest;
}

}  // namespace magicmass::equality
