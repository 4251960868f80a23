// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;

Theorem Kernel::vanishing_square(const Claim& claim, const Theorem& square) {
  const std::string rule = "a square that is zero";
  Evidence evidence;
  use(square, claim, rule, evidence);
  require_equation(square, claim, rule);
  const ex root = (claim.statement.lhs() - claim.statement.rhs()).evalm();
  require_scalar(root, claim, rule, evidence);
  require_equal(square.lhs() - square.rhs(), GiNaC::pow(root, 2), claim, rule, evidence);
  return accept(claim, rule, evidence);
}

// The cosine falls strictly on [0, pi].
Theorem Kernel::larger_angle(const Claim& claim, const Theorem& sign) {
  const std::string rule = "smaller cosine on [0, pi]";
  Evidence evidence;
  use(sign, claim, rule, evidence);
  require(sign.statement().relation() == Relation::greater, claim, rule,
          sign.id() + " does not say that something is positive");
  require(claim.statement.relation() == Relation::greater, claim, rule,
          "the claim must read x > y");
  for (const ex& side : {claim.statement.lhs(), claim.statement.rhs()})
    require(is_angle_up_to_pi(side, claim, evidence), claim, rule,
            text(side) + " is not seen to lie in [0, pi]");
  const ex fall = GiNaC::cos(claim.statement.rhs()) - GiNaC::cos(claim.statement.lhs());
  const ex known = sign.lhs() - sign.rhs();
  require_scalar(fall, claim, rule, evidence);
  Evidence positive;  // known > 0 says more than known != 0
  require_scalar(1 / known, claim, rule, positive);
  const ex ratio = simplified(fall / known, claim.indices);
  require(is_positive(ratio, claim, evidence), claim, rule,
          "the cosines differ by " + text(ratio) + " times what " + sign.id() +
              " says is positive, a factor of unknown sign");
  require_equal(fall, known * ratio, claim, rule, evidence);
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
