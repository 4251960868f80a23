// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/factored.hpp"
#include "proof/generators.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

std::string name_of(const ex& symbol) { return ex_to<GiNaC::symbol>(symbol).get_name(); }

void collect_symbols(const ex& e, GiNaC::exset& symbols) {
  if (is_a<GiNaC::symbol>(e)) symbols.insert(e);
  for (const ex& part : e) collect_symbols(part, symbols);
}

}  // namespace

// 1 - C or 1 + C, up to a positive factor, where C^2 + S^2 = 1 and S > 0.
bool NormalForm::Generators::within_unit_circle(const ex& polynomial) const {
  for (const auto& [cosine, sine] : pairs_)
    if (positive_generators_.contains(sine) && polynomial.has(cosine))
      for (const ex& bounded : {ex(1 - cosine), ex(1 + cosine)}) {
        const ex ratio = (polynomial / bounded).normal();
        if (is_a<numeric>(ratio) && ex_to<numeric>(ratio).is_positive()) return true;
      }
  return false;
}

// Every coefficient is >= 0 and some monomial > 0, once each integer k >= m is written m + k' with k' >= 0.
// Assumptions count as used only when this succeeds.
bool NormalForm::Generators::positive_polynomial(const ex& polynomial) {
  GiNaC::exset symbols;
  collect_symbols(polynomial, symbols);
  GiNaC::exset strictly_positive;
  GiNaC::exset not_negative;
  GiNaC::exmap shift;
  Conditions used;
  for (const ex& symbol : symbols) {
    const std::string name = name_of(symbol);
    if (positive_generators_.contains(symbol)) {
      strictly_positive.insert(symbol);
    } else if (domain_.positive.contains(name)) {
      strictly_positive.insert(symbol);
      used.insert(condition({symbol, Relation::greater, 0}));
    } else if (const auto found = domain_.integer.find(name); found != domain_.integer.end()) {
      const ex excess = GiNaC::realsymbol(name);
      shift[symbol] = excess + found->second;
      not_negative.insert(excess);
      used.insert(index_condition(name, found->second));
    }
  }
  if (within_unit_circle(polynomial) || assumed_positive(polynomial)) return true;
  const ex shifted = in_excesses(polynomial, strictly_positive, not_negative, used)
                         .subs(shift, GiNaC::subs_options::no_pattern)
                         .expand();
  bool some_positive = false;
  const auto inspect = [&](const ex& monomial) {
    bool strict = true;
    const auto inspect_factor = [&](const ex& factor) {
      const ex base = is_a<GiNaC::power>(factor) ? factor.op(0) : factor;
      if (is_a<numeric>(base)) return !ex_to<numeric>(base).is_negative();
      if (strictly_positive.contains(base)) return true;
      strict = false;
      return not_negative.contains(base) ||
             (is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::even));
    };
    bool fine = true;
    if (is_a<GiNaC::mul>(monomial))
      for (const ex& factor : monomial) fine = inspect_factor(factor) && fine;
    else
      fine = inspect_factor(monomial);
    some_positive = some_positive || (fine && strict && !monomial.is_zero());
    return fine;
  };
  bool all = true;
  if (is_a<GiNaC::add>(shifted))
    for (const ex& monomial : shifted) all = all && inspect(monomial);
  else
    all = inspect(shifted);
  if (!all || !some_positive) return false;
  conditions.merge(used);
  return true;
}

// The assumptions lhs > rhs as polynomials > 0, once; one is not used for another's denominator.
const std::vector<std::pair<ex, Condition>>& NormalForm::Generators::assumptions() {
  if (assumptions_) return *assumptions_;
  assumptions_.emplace();
  std::vector<std::pair<ex, Condition>> all;
  for (const Statement& assumption : domain_.assumed) {
    if (assumption.relation() != Relation::greater) continue;
    const auto [above, below] =
        quotient(rewritten(definitions_.expand_except_angles(assumption.lhs() - assumption.rhs())));
    if (above.is_zero()) continue;
    if (positive(below))
      all.emplace_back(above.expand(), condition(assumption));
    else if (positive(-below))
      all.emplace_back((-above).expand(), condition(assumption));
  }
  assumptions_ = std::move(all);
  return *assumptions_;
}

// A positive multiple of what is assumed to be positive.
bool NormalForm::Generators::assumed_positive(const ex& polynomial) {
  if (domain_.assumed.empty()) return false;
  const ex expanded = polynomial.expand();
  for (const auto& [assumed, assumption] : assumptions()) {
    if (expanded.nops() != assumed.nops()) continue;  // no multiple
    const ex ratio = (polynomial / assumed).normal();
    if (!is_a<numeric>(ratio) || !ex_to<numeric>(ratio).is_positive()) continue;
    conditions.insert(assumption);
    return true;
  }
  return false;
}

// Zero, positive, or a positive multiple of rhs - lhs where lhs <= rhs is assumed.
bool NormalForm::Generators::not_negative(const ex& rational) {
  const auto [above, below] = quotient(rational);
  if (above.is_zero() || positive(above / below)) return true;
  for (const Statement& assumption : domain_.assumed) {
    if (assumption.relation() != Relation::less_equal) continue;
    const ex bound =
        rewritten(definitions_.expand_except_angles(assumption.rhs() - assumption.lhs()));
    if (quotient(bound).first.is_zero()) continue;
    const auto [ratio_above, ratio_below] = quotient(rational / bound);
    if (ratio_above.is_zero() || !positive(ratio_above / ratio_below)) continue;
    conditions.insert(condition(assumption));
    return true;
  }
  return false;
}

bool NormalForm::Generators::positive(const ex& rational) {
  const auto [above, below] = quotient(rational);
  const auto product_positive = [this](const ex& polynomial) {
    if (positive_polynomial(polynomial)) return true;
    const ex factors = factored(polynomial);
    if (!is_a<GiNaC::mul>(factors) && !is_a<GiNaC::power>(factors)) return false;
    const auto part_sign = [this](const ex& part) {
      const ex base = is_a<GiNaC::power>(part) ? part.op(0) : part;
      if (positive_polynomial(base)) return 1;
      if (positive_polynomial((-base).expand()))
        return is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::even) ? 1 : -1;
      return 0;
    };
    if (is_a<GiNaC::power>(factors)) return part_sign(factors) > 0;
    int sign = 1;
    for (const ex& part : factors) sign *= part_sign(part);
    return sign > 0;
  };
  return (product_positive(above) && product_positive(below)) ||
         (product_positive(-above) && product_positive(-below));
}

// cos(pi/d) > 0 for d > 2 and sin(pi/d) > 0 for d > 1, where the bound on d follows from the domain.
bool NormalForm::Generators::positive_at_fraction_of_pi(const ex& e) {
  if (!is_a<GiNaC::function>(e)) return false;
  const std::string name = ex_to<GiNaC::function>(e).get_name();
  if (name != "cos" && name != "sin") return false;
  const ex d = (GiNaC::Pi / e.op(0)).normal();
  return !d.has(GiNaC::Pi) && positive(rewritten(d) - (name == "cos" ? 2 : 1));
}

// Either it follows that the expression never vanishes on the domain, or "!= 0" becomes a condition.
void NormalForm::Generators::require_nonzero(const ex& rational, const ex& shown) {
  const auto [above, below] = quotient(rational);
  if (above.is_zero())
    throw NotInClass("division by an expression that is identically zero: " + to_text(shown));
  if (positive_at_fraction_of_pi(shown)) return;
  if (!positive(above) && !positive(-above))
    conditions.insert(
        condition({is_a<GiNaC::add>(shown) && leads_with_minus(shown) ? ex(-shown) : shown,
                   Relation::not_equal, 0}));
}

}  // namespace magicmass::proof
