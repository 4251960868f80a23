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

// Seen to lie in [0, pi]: q atan(t) with t > 0 and q <= 2, or q <= 4 and t < 1; pi/d with d >= 1.
bool Kernel::is_angle_up_to_pi(const ex& angle, const Claim& claim, Evidence& evidence) const {
  const ex written_out = definitions_.expand_all(angle);
  if (const auto multiple = multiple_of_arctangent(written_out)) {
    const auto& [q, t] = *multiple;
    if (q.is_negative() || !is_positive(t, claim, evidence)) return false;
    if (q <= 2) return true;
    return q <= 4 && is_positive(1 - GiNaC::pow(t, 2), claim, evidence);
  }
  const ex d = (GiNaC::Pi / written_out).normal();
  return !d.has(GiNaC::Pi) && is_positive(d, claim, evidence) &&
         (d.is_equal(1) || is_positive(d - 1, claim, evidence));
}

Theorem Kernel::equal_angles(const Claim& claim) {
  const std::string rule = "equal cosines on [0, pi]";
  Evidence evidence;
  for (const ex& side : {claim.statement.lhs(), claim.statement.rhs()})
    require(is_angle_up_to_pi(side, claim, evidence), claim, rule,
            to_text(side) + " is not seen to lie in [0, pi]");
  require_equal(GiNaC::cos(claim.statement.lhs()), GiNaC::cos(claim.statement.rhs()), claim, rule,
                evidence);
  return accept(claim, rule, evidence);
}

// In [pi - psi/2, pi + psi/2) the cosine takes the value at pi + s psi also at pi - s psi and nowhere else;
// the angle is the only one with its cosine when s = 0, or when its mirror image falls out: s = -1/2.
Theorem Kernel::last_angle(const Claim& claim, const Theorem& cosine, const Theorem& count) {
  const std::string rule = "one angle in the last cycle";
  Evidence evidence;
  use(cosine, claim, rule, evidence);
  use(count, claim, rule, evidence);
  require_equation(cosine, claim, rule);
  require_equation(count, claim, rule);
  const ex psi = symbol("psi");
  const ex last = symbol("N_B");
  require(count.lhs().is_equal(last) && count.rhs().is_equal(ceiling(GiNaC::Pi / psi - 1)), claim,
          rule, count.id() + " is not N_B = ceil(pi/psi - 1)");
  const ex angle = (last + numeric(1, 2)) * psi;
  require((claim.statement.lhs() - angle).expand().is_zero(), claim, rule,
          "the left side must be " + to_text(angle));
  require(cosine.lhs().is_equal(GiNaC::cos(claim.statement.lhs())), claim, rule,
          cosine.id() + " does not give its cosine");
  require(is_angle_up_to_pi(psi, claim, evidence), claim, rule,
          "psi is not seen to lie in [0, pi]");
  const ex s = ((claim.statement.rhs() - GiNaC::Pi) / psi).normal();
  require(is_a<numeric>(s) && (s.is_zero() || s.is_equal(numeric(-1, 2))), claim, rule,
          "the right side must be pi or pi - psi/2, the angles there whose cosine no other has");
  require_equal(cosine.rhs(), GiNaC::cos(claim.statement.rhs()), claim, rule, evidence);
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
