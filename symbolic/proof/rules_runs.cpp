// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

// The step holds for every j and for all values of whatever else its conditions name. As v(j + 1) = v(j) names
// nothing but j, it holds for a j as soon as there are such values for that j; they need not be the same for
// two steps. So v is the same after any number of such steps.
Theorem Kernel::unchanged_through_runs(const Claim& claim, const Theorem& step, const ex& j,
                                       const std::vector<Theorem>& supposing) {
  const std::string rule = "step by step, each with its own run";
  Evidence evidence;
  require_own(step, claim, rule);
  require_equation(step, claim, rule);
  evidence.premises.push_back(step.id());
  require(is_a<GiNaC::symbol>(j) && claim.indices.contains(to_text(j)), claim, rule,
          "the claim does not say where " + to_text(j) + " starts");
  const long first = claim.indices.at(to_text(j));
  const ex& element = claim.statement.lhs();
  require(is_sequence(element) && element.op(0).is_equal(j) &&
              claim.statement.rhs().is_equal(element.subs(j == first)),
          claim, rule, "the claim must read v(j) = v(" + std::to_string(first) + ")");
  require(step.rhs().is_equal(element) && step.lhs().is_equal(element.subs(j == j + 1)), claim,
          rule, step.id() + " does not read v(j + 1) = v(j)");
  const auto from = step.domain().integer.find(to_text(j));
  require(from != step.domain().integer.end() && from->second <= first, claim, rule,
          step.id() + " does not hold from the first step on");
  Conditions conditions = step.conditions();
  for (const Theorem& also : supposing) {
    require_own(also, claim, rule);
    evidence.premises.push_back(also.id());
    conditions.insert(also.conditions().begin(), also.conditions().end());
  }
  std::string supposed;
  for (const Condition& condition : conditions)
    if (condition.index != to_text(j)) supposed += (supposed.empty() ? "" : "; ") + condition.text;
  if (!supposed.empty())
    evidence.conditions.insert({"for every step " + to_text(j) +
                                " up to there, with a run and values of its own: " + supposed});
  evidence.conditions.insert(index_condition(to_text(j), first));
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
