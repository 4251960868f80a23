// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/generators.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

// b^(x/2) > 0 for b > 0 and a monomial x, as one generator: so b^(n + 1) = b b^n, b^(2 n) = (b^n)^2 and
// sqrt(b)^n is the generator itself. Bases are told apart by their text: 4^n and 2^n stay independent.
ex NormalForm::Generators::symbolic_power(const ex& base, const ex& exponent) {
  ex root_base = base;  // sqrt(b)^x = b^(x/2)
  numeric scale = 1;
  while (is_a<GiNaC::power>(root_base) && is_a<numeric>(root_base.op(1)) &&
         ex_to<numeric>(root_base.op(1)).is_rational()) {
    scale *= ex_to<numeric>(root_base.op(1));
    root_base = root_base.op(0);
  }
  const ex inside = rewritten(root_base);
  if (!positive(inside))
    throw NotInClass("the power of a base that is not known to be positive: " +
                     to_text(GiNaC::power(base, exponent)));
  const std::string shown = to_text(reduced_fraction(inside));
  const ex expanded = (scale * exponent).expand();
  ex product = 1;
  const auto factor = [&](const ex& term) {
    if (is_a<numeric>(term)) {
      product *= rewritten(GiNaC::power(root_base, term));
      return;
    }
    numeric coefficient = 1;
    if (is_a<GiNaC::mul>(term))
      for (const ex& part : term)
        if (is_a<numeric>(part)) coefficient = ex_to<numeric>(part);
    const ex monomial = term / coefficient;
    const numeric halves = 2 * coefficient;
    if (!halves.is_integer() || GiNaC::abs(halves) > largest_exponent)
      throw NotInClass("only half and whole multiples of moderate size in exponents: " +
                       to_text(exponent));
    rewritten(monomial);  // real, and with what its roots and denominators ask for
    const std::string key = "(" + shown + ")^(" + to_text(monomial) + "/2)";
    const bool is_new = !by_key_.contains(key);
    const ex generator = opaque(key, GiNaC::power(root_base, monomial / 2), true);
    if (is_new) powers_.push_back({generator, root_base, monomial});
    product *= GiNaC::power(generator, halves);
  };
  if (is_a<GiNaC::add>(expanded))
    for (const ex& term : expanded) factor(term);
  else
    factor(expanded);
  return product;
}

// Where b > 1 or b >= 1 is assumed for a symbol b: b = 1 + d with d > 0 or d >= 0, and
// b^n = b^m (1 + x) with x >= 0 for n >= m >= 0.
ex NormalForm::Generators::in_excesses(const ex& polynomial, GiNaC::exset& strict,
                                       GiNaC::exset& not_negative, Conditions& used) const {
  ex result = polynomial;
  for (const Statement& assumption : domain_.assumed) {
    const bool greater = assumption.relation() == Relation::greater;
    const ex& base = greater ? assumption.lhs() : assumption.rhs();
    const ex& bound = greater ? assumption.rhs() : assumption.lhs();
    if (!is_a<GiNaC::symbol>(base) || !bound.is_equal(1) || definitions_.contains(to_text(base)) ||
        domain_.integer.contains(to_text(base)))
      continue;
    for (const SymbolicPower& known : powers_) {
      if (!known.base.is_equal(base) || !result.has(known.generator)) continue;
      const auto from = domain_.integer.find(to_text(known.exponent));
      if (!is_a<GiNaC::symbol>(known.exponent) || from == domain_.integer.end() ||
          from->second < 0 || domain_.positive.contains(to_text(known.exponent)))
        continue;
      const ex expanded = result.expand();
      const int degree = expanded.degree(known.generator);
      const ex excess = GiNaC::realsymbol("excess");
      const ex square = GiNaC::power(base, from->second) * (1 + excess);
      ex even = 0;
      bool only_even = true;
      for (int power = 0; power <= degree; ++power) {
        const ex coefficient = expanded.coeff(known.generator, power);
        only_even = only_even && (power % 2 == 0 || coefficient.is_zero());
        even += coefficient * GiNaC::power(square, power / 2);
      }
      if (!only_even) continue;
      result = even;
      not_negative.insert(excess);
      used.insert(index_condition(to_text(known.exponent), from->second));
      used.insert(condition(assumption));
    }
    if (!result.has(base)) continue;
    const ex surplus = GiNaC::realsymbol("surplus");
    result = result.subs(base == 1 + surplus, GiNaC::subs_options::no_pattern);
    (greater ? strict : not_negative).insert(surplus);
    used.insert(condition(assumption));
  }
  return result;
}

}  // namespace magicmass::proof
