// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "proof/families.hpp"
#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using GiNaC::subs_options;

// 1/x for x > 0, or b^(-c x) with b > 1 and a whole c >= 1: tends to 0 as x grows without bound.
bool Kernel::tends_to_zero(const ex& vanishing, const ex& x, const Claim& claim,
                           Evidence& evidence) const {
  const std::string name = to_text(x);
  const bool grows = domain_.positive.contains(name) || claim.indices.contains(name);
  if (!grows || definitions_.contains(name)) return false;
  if (vanishing.is_equal(1 / x)) return true;
  if (!is_a<GiNaC::power>(vanishing) || is_a<numeric>(vanishing.op(1))) return false;
  const ex rate = vanishing.op(1) / x;
  return is_a<numeric>(rate) && ex_to<numeric>(-rate).is_pos_integer() &&
         !definitions_.expand_all(vanishing.op(0)).has(x) &&
         is_positive(vanishing.op(0) - 1, claim, evidence);
}

// f(x) = R(p(x)) with R rational in p, p(x) -> 0, and a denominator that is not 0 at p = 0: f(x) -> R(0).
Theorem Kernel::limit(const Claim& claim, const std::optional<Theorem>& closed, const ex& form,
                      const ex& p, const ex& vanishing) {
  const std::string rule = "limit";
  Evidence evidence;
  const ex& left = claim.statement.lhs();
  require(is_limit(left) && is_a<GiNaC::symbol>(left.op(1)), claim, rule,
          "the left side must be lim(f, x) for a symbol x that grows without bound");
  const ex x = left.op(1);
  const std::string name = to_text(x);
  ex f = left.op(0);
  if (closed) {
    use(*closed, claim, rule, evidence);
    require_equation(*closed, claim, rule);
    require(closed->lhs().is_equal(f), claim, rule, closed->id() + " is not about " + to_text(f));
    f = closed->rhs();
  }
  require(!contains_sequence(f) && !contains_family(f), claim, rule,
          to_text(f) + " is not a formula");
  require(is_a<GiNaC::symbol>(p) && !domain_of(claim).integer.contains(to_text(p)) &&
              !definitions_.contains(to_text(p)) && !p.is_equal(x) &&
              !definitions_.expand_all(f).has(p) && !definitions_.expand_all(vanishing).has(p) &&
              !definitions_.expand_all(claim.statement.rhs()).has(p),
          claim, rule, to_text(p) + " is not a new symbol");
  const ex open = definitions_.expand_all(form);
  require(!open.has(x) && !definitions_.expand_all(claim.statement.rhs()).has(x), claim, rule,
          "the form or the limit depends on " + name);
  require(tends_to_zero(vanishing, x, claim, evidence), claim, rule,
          to_text(vanishing) + " is not seen to tend to 0");
  require_equal(f, open.subs(p == vanishing, subs_options::no_pattern), claim, rule, evidence);

  for (const Condition& condition : evidence.conditions) {  // none may bound x
    std::vector<Statement> parts = condition.any_of;
    if (condition.statement) parts.push_back(*condition.statement);
    for (const Statement& part : parts)
      require(!definitions_.expand_all(part.lhs() - part.rhs()).has(x) ||
                  (part.lhs().is_equal(x) && part.relation() == Relation::greater &&
                   part.rhs().is_zero()),
              claim, rule, "it is known only if " + condition.text);
    require(!parts.empty() || condition.index == name || !speaks_of(condition.text, name), claim,
            rule, "it is known only if " + condition.text);
  }

  GiNaC::exmap constants;  // roots and angles free of p count as constants
  const ex fraction = open.to_rational(constants).numer_denom();
  for (const auto& [placeholder, meaning] : constants)
    require(!meaning.has(p), claim, rule, "the form is not rational in " + to_text(p));
  const auto at_zero = [&](const ex& polynomial) {
    require(polynomial.is_polynomial(p), claim, rule, "the form is not rational in " + to_text(p));
    return polynomial.subs(p == 0, subs_options::no_pattern)
        .subs(constants, subs_options::no_pattern);
  };
  const ex below = at_zero(fraction.op(1));
  require(is_positive(below, claim, evidence) || is_positive(-below, claim, evidence), claim, rule,
          "the denominator " + to_text(below) + " is not seen to differ from 0 at " + to_text(p) +
              " = 0");
  require_equal(at_zero(fraction.op(0)) / below, claim.statement.rhs(), claim, rule, evidence);
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
