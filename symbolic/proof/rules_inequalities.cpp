// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "proof/arctangent.hpp"
#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

std::pair<ex, ex> Kernel::ceiling_of(const Theorem& count, const Claim& claim,
                                     const std::string& rule) const {
  require_equation(count, claim, rule);
  const ex& rhs = count.rhs();
  const auto is_ceiling = [](const ex& e) {
    return is_step_function(e) && function_name(e) == "ceil";
  };
  if (is_ceiling(rhs)) return {rhs.op(0), count.lhs()};
  require(is_a<GiNaC::add>(rhs) && rhs.nops() == 2, claim, rule, count.id() + " is not a ceiling");
  const ex& first = is_ceiling(rhs.op(0)) ? rhs.op(0) : rhs.op(1);
  const ex added = rhs - first;
  require(is_ceiling(first) && is_a<numeric>(added) && ex_to<numeric>(added).is_integer(), claim,
          rule, count.id() + " is not a ceiling and a whole number");
  return {first.op(0), count.lhs() - added};
}

Theorem Kernel::ceiling_bound(const Claim& claim, const Theorem& count) {
  const std::string rule = "ceiling";
  Evidence evidence;
  use(count, claim, rule, evidence);
  const auto [y, whole] = ceiling_of(count, claim, rule);
  const bool below = claim.statement.relation() == Relation::less_equal;
  require(below || claim.statement.relation() == Relation::greater, claim, rule,
          "the claim must read x <= y or x > y");
  const ex known = below ? whole - y : y + 1 - whole;
  const ex difference = below ? claim.statement.rhs() - claim.statement.lhs()
                              : claim.statement.lhs() - claim.statement.rhs();
  const ex factor = (difference / known).normal();
  require(is_positive(factor, claim, evidence), claim, rule,
          "the claim is not a positive multiple of " + to_text(known) + (below ? " >= 0" : " > 0"));
  require_equal(difference, factor * known, claim, rule, evidence);
  return accept(claim, rule, evidence);
}

Theorem Kernel::ceiling_value(const Claim& claim, const Theorem& count, const Theorem& at_most,
                              const Theorem& above) {
  const std::string rule = "ceiling";
  Evidence evidence;
  for (const Theorem& premise : {count, at_most, above}) use(premise, claim, rule, evidence);
  const auto [y, whole] = ceiling_of(count, claim, rule);
  require(
      claim.statement.relation() == Relation::equal && claim.statement.lhs().is_equal(count.lhs()),
      claim, rule, "the claim must be about " + to_text(count.lhs()));
  const ex k = (whole - count.lhs() + claim.statement.rhs()).expand();
  require(is_integer(k, claim), claim, rule, to_text(k) + " is not known to be a whole number");
  require(at_most.statement().relation() == Relation::less_equal, claim, rule,
          at_most.id() + " does not read x <= y");
  require(above.statement().relation() == Relation::greater, claim, rule,
          above.id() + " does not read x > y");
  const auto same_sign = [&](const ex& difference, const ex& known, const Theorem& premise) {
    const ex factor = (difference / known).normal();
    require(is_positive(factor, claim, evidence), claim, rule,
            premise.id() + " is not a positive multiple of " + to_text(known));
    require_equal(difference, factor * known, claim, rule, evidence);
  };
  same_sign(at_most.rhs() - at_most.lhs(), k - y, at_most);
  same_sign(above.lhs() - above.rhs(), y + 1 - k, above);
  return accept(claim, rule, evidence);
}

Theorem Kernel::angle_below_pi(const Claim& claim) {
  const std::string rule = "angle below pi";
  Evidence evidence;
  require(
      claim.statement.relation() == Relation::greater && claim.statement.lhs().is_equal(GiNaC::Pi),
      claim, rule, "the claim must read pi > x");
  const ex& angle = claim.statement.rhs();
  const ex written_out = definitions_.expand_all(angle);
  if (const auto multiple = multiple_of_arctangent(written_out)) {
    const auto& [q, t] = *multiple;
    require(!q.is_negative() && q <= 2 && is_positive(t, claim, evidence), claim, rule,
            to_text(angle) + " is not 2 atan(t), t > 0");
  } else {
    const ex d = (GiNaC::Pi / written_out).normal();
    require(!d.has(GiNaC::Pi) && is_positive(d - 1, claim, evidence), claim, rule,
            to_text(angle) + " is not pi/d, d > 1");
  }
  return accept(claim, rule, evidence);
}

// The cosine falls strictly on [0, pi].
Theorem Kernel::larger_angle(const Claim& claim, const Theorem& sign) {
  const std::string rule = "smaller cosine on [0, pi]";
  Evidence evidence;
  use(sign, claim, rule, evidence);
  const Relation relation = claim.statement.relation();
  const bool strict = relation == Relation::greater;
  require(strict || relation == Relation::less_equal, claim, rule,
          "the claim must read x > y or x <= y");
  require(sign.statement().relation() == relation, claim, rule,
          sign.id() + " does not read x " + (strict ? ">" : "<=") + " y");
  for (const ex& side : {claim.statement.lhs(), claim.statement.rhs()})
    require(is_angle_up_to_pi(side, claim, evidence), claim, rule,
            to_text(side) + " is not seen to lie in [0, pi]");
  const auto excess = [strict](const ex& left, const ex& right) {
    return strict ? left - right : right - left;
  };
  const ex fall = excess(cos(claim.statement.rhs()), cos(claim.statement.lhs()));
  const ex known = excess(sign.lhs(), sign.rhs());
  require_scalar(fall, claim, rule, evidence);
  Evidence nonzero;  // the ratio is only looked for by division
  require_scalar(1 / known, claim, rule, nonzero);
  const ex ratio = simplified(fall / known, claim.indices);
  require(is_positive(ratio, claim, evidence), claim, rule,
          "the cosines differ by " + to_text(ratio) + " times the difference in " + sign.id() +
              ", a factor of unknown sign");
  require_equal(fall, known * ratio, claim, rule, evidence);
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
