// SPDX-License-Identifier: GPL-2.0-or-later
#include <cln/rational.h>

#include "equality/point.hpp"
#include "equality/translation.hpp"
#include "proof/text.hpp"

namespace magicmass::equality {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using proof::NotInClass;

ex Translation::power(const Tree& tree) {
  const Tree& base = tree->parts[0];
  const Tree exponent = at({}, tree->parts[1]);
  if (is_number(exponent)) {
    const numeric n(exponent->value);
    ex below = translated(base);
    if (!n.is_integer()) below = root(below, n.denom().to_long(), tree);
    if (n.is_negative() && form_->is_zero(below))
      throw NotInClass("division by zero: " + to_text(tree));
    return GiNaC::pow(below, n.numer());
  }
  const ex above = translated(exponent).expand();
  if (is_number(base) && base->value < 0) {  // defined for whole exponents: (-r)^m = r^m cos(m pi)
    if (!is_integer_valued(above))
      throw NotInClass("a power of a negative number: " + to_text(tree));
    const ex sign = cos(without_full_turns((above * GiNaC::Pi).expand()));
    return sign * product_of_exponentials(numeric(-base->value), above);
  }
  const ex below = translated(base);
  if (!form_->is_positive(below)) throw NotInClass("a power of an unknown sign: " + to_text(tree));
  return product_of_exponentials(below, above);
}

// (u v/w)^x = u^x v^x/w^x for positive factors; what is left in one piece is one factor.
ex Translation::product_of_exponentials(const ex& base, const ex& exponent) {
  const ex fraction = form_->simplified(base).numer_denom();
  ex total = 1;
  ex rest = 1;
  const auto split = [&](const ex& whole, int direction) {
    const ex factored = GiNaC::factor(whole);
    const auto add = [&](const ex& part) {
      const bool is_power = is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::integer);
      const ex root_of_part = is_power ? part.op(0) : part;
      const ex count = direction * (is_power ? part.op(1) : ex(1));
      if (is_a<numeric>(root_of_part) && ex_to<numeric>(root_of_part).is_pos_integer()) {
        numeric left = ex_to<numeric>(root_of_part);
        for (long prime = 2; prime < 100 && prime * prime <= left; ++prime)
          while (GiNaC::irem(left, prime).is_zero()) {
            total *= exponential(std::to_string(prime), prime, count * exponent);
            left = GiNaC::iquo(left, prime);
          }
        if (!left.is_equal(1)) total *= exponential(proof::to_text(left), left, count * exponent);
      } else if (form_->is_positive(root_of_part)) {
        total *= exponential(proof::to_text(root_of_part), root_of_part, count * exponent);
      } else {
        rest *= GiNaC::pow(root_of_part, count);
      }
    };
    if (is_a<GiNaC::mul>(factored))
      for (const ex& part : factored) add(part);
    else
      add(factored);
  };
  split(fraction.op(0), 1);
  split(fraction.op(1), -1);
  if (!rest.is_equal(1))
    total *= exponential(proof::to_text(form_->simplified(rest)), rest, exponent);
  return total;
}

// base^exponent for base > 0: base^(a + b) = base^a base^b, and one positive generator for base^(monomial/2).
ex Translation::exponential(const std::string& key, const ex& base, const ex& exponent) {
  ex total = 1;
  const auto multiply = [&](const ex& monomial) {
    if (is_a<numeric>(monomial)) {
      const numeric n = ex_to<numeric>(monomial);
      if (!n.is_rational() || n.denom() > 2) throw NotInClass("a root of order 3 or more");
      total *= GiNaC::pow(base, n);
      return;
    }
    numeric factor = 1;
    if (is_a<GiNaC::mul>(monomial))
      for (const ex& part : monomial)
        if (is_a<numeric>(part)) factor = ex_to<numeric>(part);
    if (!factor.is_rational()) throw NotInClass("an exponent that is not rational");
    const numeric below = factor.denom().is_equal(1) ? numeric(2) : factor.denom();
    const ex unit = monomial / factor / below;
    const numeric count = factor * below;
    if (GiNaC::abs(count) > 100) throw NotInClass("too large an exponent");
    total *= GiNaC::pow(named(key + "^(" + proof::to_text(unit) + ")", nullptr), count);
  };
  const ex expanded = form_->simplified(exponent).expand();
  if (is_a<GiNaC::add>(expanded))
    for (const ex& monomial : expanded) multiply(monomial);
  else
    multiply(expanded);
  return total;
}

// Even orders are square roots of roots of half the order. For others the radicand must be a perfect power.
ex Translation::root(const ex& radicand, long order, const Tree& shown) {
  if (order % 2 == 0) return square_root(order == 2 ? radicand : root(radicand, order / 2, shown));
  const ex fraction = form_->simplified(radicand).numer_denom();
  const auto root_of_polynomial = [&](const ex& polynomial) {
    const ex factored = GiNaC::factor(polynomial);
    ex result = 1;
    const auto add = [&](const ex& part) {
      const bool is_power = is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::integer);
      const numeric count = is_power ? ex_to<numeric>(part.op(1)) : numeric(1);
      const ex base = is_power ? part.op(0) : part;
      if (is_a<numeric>(base))
        result *= translated_constant(at(
            {}, equality::root(
                    number(cln::the<cln::cl_RA>(GiNaC::pow(ex_to<numeric>(base), count).to_cl_N())),
                    order)));
      else if (GiNaC::irem(count, order).is_zero())
        result *= GiNaC::pow(base, GiNaC::iquo(count, order));
      else
        throw NotInClass("a root of odd order: " + to_text(shown));
    };
    if (is_a<GiNaC::mul>(factored))
      for (const ex& part : factored) add(part);
    else
      add(factored);
    return result;
  };
  return root_of_polynomial(fraction.op(0)) / root_of_polynomial(fraction.op(1));
}

// sqrt(p^4 q) = p^2 sqrt(q) whatever the sign of p; the kernel keeps what has no known sign under one root.
ex Translation::square_root(const ex& radicand) {
  if (is_a<numeric>(radicand)) return sqrt(radicand);
  const ex fraction = form_->simplified(radicand).numer_denom();
  const ex factored = GiNaC::factor(fraction.op(0));
  ex outside = 1;
  ex inside = 1;
  const auto add = [&](const ex& part) {
    const bool is_power = is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::posint);
    const int count = is_power ? ex_to<numeric>(part.op(1)).to_int() : 1;
    const ex base = is_power ? part.op(0) : part;
    outside *= GiNaC::pow(base, 2 * (count / 4));
    inside *= GiNaC::pow(base, count % 4);
  };
  if (is_a<GiNaC::mul>(factored))
    for (const ex& part : factored) add(part);
  else
    add(factored);
  return outside.is_equal(1) ? sqrt(radicand) : outside * sqrt(inside / fraction.op(1));
}

}  // namespace magicmass::equality
