// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>

#include "proof/factored.hpp"
#include "proof/generators.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

struct Factor {
  ex base;
  int multiplicity = 0;
};
using Factors =
    std::map<std::string, Factor>;  // by text, so that the order is the same on every run

void add_factor(const ex& base, int multiplicity, Factors& factors) {
  Factor& factor = factors[to_text(base)];
  factor.base = base;
  factor.multiplicity += multiplicity;
}

// Trial division; what is left past the bound counts as one factor, which is sound and only less complete.
void add_prime_factors(numeric integer, Factors& factors) {
  const numeric bound = 100000;
  for (numeric d = 2; d <= bound && d * d <= integer; d += 1)
    while (GiNaC::irem(integer, d).is_zero()) {
      add_factor(d, 1, factors);
      integer = GiNaC::iquo(integer, d);
    }
  if (integer > 1) add_factor(integer, 1, factors);
}

// Splits off the rational content and adds the irreducible polynomials, primitive and with a settled sign.
numeric add_factors(const ex& factored, int multiplicity, Factors& factors) {
  if (is_a<numeric>(factored)) return ex_to<numeric>(factored).power(multiplicity);
  if (is_a<GiNaC::mul>(factored)) {
    numeric content = 1;
    for (const ex& part : factored) content *= add_factors(part, multiplicity, factors);
    return content;
  }
  if (is_a<GiNaC::power>(factored))
    return add_factors(factored.op(0), multiplicity * ex_to<numeric>(factored.op(1)).to_int(),
                       factors);
  numeric content = factored.integer_content();
  if (is_a<GiNaC::add>(factored) && leads_with_minus(factored)) content = -content;
  add_factor((factored / content).expand(), multiplicity, factors);
  return content.power(multiplicity);
}

}  // namespace

// (1 - C)(1 + C) rest = S^2 rest: where S > 0 is known the root is S sqrt(rest), so that S and
// sqrt(1 - C^2) stay one generator.
bool NormalForm::Generators::sine_product(ex& radicand, ex& root) {
  for (const auto& [cosine, sine] : pairs_) {
    if (!positive_generators_.contains(sine) || !radicand.has(cosine)) continue;
    const ex square = (1 - GiNaC::pow(cosine, 2)).expand();
    ex remaining;
    if (GiNaC::divide(radicand.expand(), square, remaining)) {
      radicand = remaining;
      root *= sine;
      return true;
    }
  }
  return false;
}

// The generator r with r^2 = square.
ex NormalForm::Generators::radical(const ex& square, bool is_positive) {
  const std::string key = "sqrt(" + to_text(square) + ")";
  const bool is_new = !by_key_.contains(key);
  ex generator = opaque(key, GiNaC::sqrt(back(square)), is_positive);
  if (is_new) relations_.push_back({generator, square.expand()});
  return generator;
}

// sqrt(u/v) = sqrt(u v)/v for v > 0, and u v is split into irreducible factors over the rationals.
// Each factor that is positive on the domain gets a generator of its own; even powers of it leave the
// root. What has no known sign stays under one root.
ex NormalForm::Generators::square_root(const ex& radicand) {
  auto [above, below] = quotient(radicand);
  if (!positive(below)) {
    above = -above;
    below = -below;
  }
  if (!positive(below))
    throw NotInClass("the sign of the denominator under a root is not known: " +
                     to_text(back(radicand)));
  ex under_root = (above * below).expand();
  if (under_root.is_zero()) return 0;
  ex root = 1 / below;
  while (sine_product(under_root, root)) {
  }

  Factors factors;
  const numeric content = add_factors(factored(under_root), 1, factors);
  root /= content.denom();
  add_prime_factors(GiNaC::abs(content.numer() * content.denom()), factors);
  ex unsigned_part = content.is_negative() ? -1 : 1;
  for (const auto& [key, factor] : factors) {
    const bool odd = factor.multiplicity % 2 != 0;
    ex base = factor.base;
    if (!positive(base) && positive(-base)) {
      base = -base;
      if (odd) unsigned_part = -unsigned_part;
    }
    if (positive(base)) {
      root *= GiNaC::pow(base, factor.multiplicity / 2);
      if (odd) root *= radical(base, true);
    } else {
      unsigned_part *= GiNaC::pow(base, factor.multiplicity);
    }
  }
  if (unsigned_part.is_equal(1)) return root;
  if (is_a<numeric>(unsigned_part))
    throw NotInClass("square root of a negative number: " + to_text(back(radicand)));
  if (is_a<numeric>((unsigned_part + 1).expand()))
    throw NotInClass("square root of a negative number: " + to_text(back(radicand)));
  conditions.insert(condition({-back(unsigned_part), Relation::less_equal, 0}));  // real
  return root * radical(unsigned_part, false);
}

}  // namespace magicmass::proof
