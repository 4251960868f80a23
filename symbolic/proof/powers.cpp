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
                     text(GiNaC::power(base, exponent)));
  const std::string shown = text(reduced_fraction(inside));
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
                       text(exponent));
    rewritten(monomial);  // real, and with what its roots and denominators ask for
    const ex generator = opaque("(" + shown + ")^(" + text(monomial) + "/2)",
                                GiNaC::power(root_base, monomial / 2), true);
    product *= GiNaC::power(generator, halves);
  };
  if (is_a<GiNaC::add>(expanded))
    for (const ex& term : expanded) factor(term);
  else
    factor(expanded);
  return product;
}

}  // namespace magicmass::proof
