// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/normal_form.hpp"
#include "proof/sampling.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using GiNaC::subs_options;

namespace {

constexpr int largest_order = 24;

const ex& small_root() {
  static const ex s = GiNaC::possymbol("s");
  return s;
}

// (s^2 p)^(q/2) = s^q p^(q/2), s > 0: what is left under roots does not vanish at s = 0.
ex without_s_under_roots(const ex& e) {
  const ex& s = small_root();
  if (is_a<GiNaC::power>(e)) {
    const ex base = without_s_under_roots(e.op(0));
    if (e.op(1).info(GiNaC::info_flags::integer)) return pow(base, e.op(1));
    const ex fraction = base.normal().numer_denom();
    const ex above = fraction.op(0).expand(), below = fraction.op(1).expand();
    const int order = above.ldegree(s) - below.ldegree(s);
    const ex rest =
        (above / pow(s, above.ldegree(s))).expand() / (below / pow(s, below.ldegree(s))).expand();
    return pow(s, order * e.op(1)) * pow(rest, e.op(1));
  }
  if (e.nops() == 0) return e;
  struct Inside : GiNaC::map_function {
    ex operator()(const ex& part) override { return without_s_under_roots(part); }
  } inside;
  return e.map(inside);
}

ex in_small_root(const ex& e) {
  return without_s_under_roots(
      e.subs(symbol("alpha") == pow(small_root(), 2), subs_options::no_pattern));
}

}  // namespace

// With s = sqrt(alpha) both sides are Laurent series in s: equal up to the last term of the right side.
Theorem Kernel::expansion(const Claim& claim) {
  const std::string rule = "series";
  Evidence evidence;
  require(claim.statement.relation() == Relation::asymptotic, claim, rule,
          "the claim must read f ~ p");
  for (const ex& side : {claim.statement.lhs(), claim.statement.rhs()})
    require_scalar(side, claim, rule, evidence);
  const ex& s = small_root();
  const ex function = in_small_root(definitions_.expand_all(claim.statement.lhs()));
  const ex terms = in_small_root(definitions_.expand_all(claim.statement.rhs())).expand();
  require(!terms.is_zero() && (terms * pow(s, largest_order)).expand().is_polynomial(s), claim,
          rule, to_text(claim.statement.rhs()) + " is not a sum of powers of sqrt(alpha)");
  const int last = terms.degree(s);
  require(last <= largest_order && terms.ldegree(s) >= -largest_order, claim, rule,
          "too many terms");
  NormalForm form(domain_of(claim), definitions_);
  try {
    const ex series = GiNaC::series_to_poly(function.series(s == 0, last + 1)).expand();
    require(!series.has(GiNaC::log(GiNaC::wild())), claim, rule, "the series has a logarithm");
    for (int order = std::min(series.ldegree(s), terms.ldegree(s)); order <= last; ++order)
      require(form.is_zero(series.coeff(s, order) - terms.coeff(s, order)), claim, rule,
              "the series has " + to_text(series.coeff(s, order)) + " sqrt(alpha)^" +
                  std::to_string(order) + ", the claim " + to_text(terms.coeff(s, order)));
  } catch (const NotInClass& outside) {
    refuse(claim, rule, outside.what());
  } catch (const GiNaC::pole_error& pole) {
    refuse(claim, rule, pole.what());
  }
  require(!terms.coeff(s, last).is_zero(), claim, rule, "the last term is zero");
  if (const auto difference = not_small(function, terms, s, last)) refuse(claim, rule, *difference);
  evidence.conditions.insert(form.conditions().begin(), form.conditions().end());
  evidence.conditions.insert({"as alpha goes to 0, with an error smaller than the last term"});
  return accept(claim, rule, evidence);
}

// N = ceil(y) + m differs from q f by less than a constant, where y - q f is a number; f ~ c alpha^(-p/2)
// grows beyond all bounds, so N ~ q c alpha^(-p/2).
Theorem Kernel::expansion_of_count(const Claim& claim, const Theorem& count,
                                   const Theorem& expansion) {
  const std::string rule = "series of a count";
  Evidence evidence;
  use(count, claim, rule, evidence);
  use(expansion, claim, rule, evidence);
  require(claim.statement.relation() == Relation::asymptotic &&
              expansion.statement().relation() == Relation::asymptotic,
          claim, rule, "the claim and " + expansion.id() + " must read f ~ p");
  require(claim.statement.lhs().is_equal(count.lhs()), claim, rule,
          "the claim must be about " + to_text(count.lhs()));
  const auto [y, whole] = ceiling_of(count, claim, rule);
  const ex terms = in_small_root(expansion.rhs()).expand();
  const ex& s = small_root();
  const int order = terms.ldegree(s);
  require(
      order < 0 && terms.degree(s) == order && is_positive(terms.coeff(s, order), claim, evidence),
      claim, rule, expansion.id() + " does not grow beyond all bounds");
  const ex factor = (claim.statement.rhs() / expansion.rhs()).normal();
  require(is_a<numeric>(factor) && ex_to<numeric>(factor).is_positive(), claim, rule,
          "the claim is not a multiple of " + to_text(expansion.rhs()));
  const ex rest = (y - factor * expansion.lhs()).expand();
  require(
      is_a<numeric>(rest), claim, rule,
      count.id() + " is not the ceiling of " + to_text(factor * expansion.lhs()) + " and a number");
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
