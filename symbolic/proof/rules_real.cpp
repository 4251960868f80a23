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

}  // namespace magicmass::proof
