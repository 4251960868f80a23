// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/factored.hpp"
#include "proof/generators.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;

// Linear in every generator that has a relation: later generators first, for a square may hold earlier ones.
ex NormalForm::Generators::reduced(const ex& polynomial) const {
  ex result = polynomial.expand();
  for (std::size_t i = relations_.size(); i-- > 0;) {
    const auto& [generator, square] = relations_[i];
    const int degree = result.degree(generator);
    if (degree < 2) continue;
    ex even = 0;
    ex odd = 0;
    ex square_power = 1;
    for (int power = 0; power <= degree; ++power) {
      (power % 2 == 0 ? even : odd) += result.coeff(generator, power) * square_power;
      if (power % 2 == 1) square_power = (square_power * square).expand();
    }
    result = (even + odd * generator).expand();
  }
  return result;
}

// Numerator and denominator, each reduced: they may have common factors that the relations made.
std::pair<ex, ex> NormalForm::Generators::reduced_parts(const ex& rational) const {
  const ex fraction = rational.numer_denom();
  const ex above = reduced(fraction.op(0));
  const ex below = reduced(fraction.op(1));
  if (below.is_zero()) throw NotInClass("division by an expression that is identically zero");
  return {above, below};
}

std::pair<ex, ex> NormalForm::Generators::quotient(const ex& rational) const {
  const ex fraction = rational.numer_denom();
  const ex first_above = fraction.op(0).expand(), first_below = fraction.op(1).expand();
  const ex above = reduced(first_above), below = reduced(first_below);
  if (below.is_zero()) throw NotInClass("division by an expression that is identically zero");
  if (above.is_zero()) return {0, 1};
  if (above.is_equal(first_above) && below.is_equal(first_below)) return {above, below};
  const ex again = (above / below).numer_denom();  // the relations may have made common factors
  return {again.op(0), again.op(1)};
}

ex NormalForm::Generators::reduced_fraction(const ex& rational) const {
  const auto [above, below] = quotient(rational);
  return above / below;
}

// Factored, and each factor a sum over the independent cosines and sines with factored coefficients:
// the same shape on every run, whatever shape GiNaC's factor() leaves the factors in.
ex NormalForm::Generators::tidied(const ex& polynomial) const {
  const auto tidy_sum = [this](const ex& sum) {
    std::map<std::string, std::pair<ex, ex>>
        collected;  // by trigonometric monomial: (it, coefficient)
    const ex expanded = sum.expand();
    for (const ex& term : GiNaC::is_a<GiNaC::add>(expanded) ? expanded : ex(GiNaC::lst{expanded})) {
      ex trigonometric = 1;
      for (const auto& [cosine, sine] : pairs_)
        for (const ex& generator : {cosine, sine})
          trigonometric *= GiNaC::power(generator, term.degree(generator));
      auto& entry = collected.try_emplace(to_text(trigonometric), trigonometric, 0).first->second;
      entry.second += term / trigonometric;
    }
    ex result = 0;
    for (const auto& [key, entry] : collected) {
      const auto& [trigonometric, coefficient] = entry;
      result += trigonometric * (collected.size() == 1 ? coefficient : tidied(coefficient));
    }
    return result;
  };
  const ex factors = factored(polynomial);
  const auto tidy_factor = [&](const ex& factor) {
    if (GiNaC::is_a<GiNaC::power>(factor))
      return ex(GiNaC::power(tidy_sum(factor.op(0)), factor.op(1)));
    return tidy_sum(factor);
  };
  if (!GiNaC::is_a<GiNaC::mul>(factors)) return tidy_factor(factors);
  ex product = 1;
  for (const ex& factor : factors) product *= tidy_factor(factor);
  return product;
}

}  // namespace magicmass::proof
