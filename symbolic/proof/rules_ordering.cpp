// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;

namespace {

bool is_inequality(const Statement& statement) {
  return statement.relation() == Relation::greater || statement.relation() == Relation::less_equal;
}
bool is_strict(const Statement& statement) { return statement.relation() == Relation::greater; }

// The larger side minus the smaller one.
ex excess(const Statement& statement) {
  return is_strict(statement) ? statement.lhs() - statement.rhs()
                              : statement.rhs() - statement.lhs();
}

// Not zero where it is defined.
bool never_zero(const ex& e) {
  if (GiNaC::is_a<GiNaC::numeric>(e)) return !e.is_zero();
  if (GiNaC::is_a<GiNaC::power>(e)) return e.op(1).info(GiNaC::info_flags::negative);
  return GiNaC::is_a<GiNaC::mul>(e) && std::all_of(e.begin(), e.end(), never_zero);
}

}  // namespace

Theorem Kernel::ordering(const Claim& claim, const std::vector<NonnegativeTerm>& terms,
                         const std::vector<Theorem>& equations) {
  const std::string rule = "sum of what is positive";
  Evidence evidence;
  require(is_inequality(claim.statement), claim, rule, "the claim must read x > y or x <= y");
  ex difference = excess(claim.statement);
  for (const Theorem& equation : equations)
    difference = applied(equation, difference, claim, rule, evidence);
  ex sum = 0;
  bool strict = false;
  for (const auto& [coefficient, factors, square] : terms) {
    require(is_positive(coefficient, claim, evidence), claim, rule,
            to_text(coefficient) + " is not seen to be positive");
    require_scalar(square, claim, rule, evidence);
    ex product = coefficient * pow(square, 2);
    bool all_strict = never_zero(square);
    for (const Theorem& factor : factors) {
      use(factor, claim, rule, evidence);
      require(is_inequality(factor.statement()), claim, rule,
              factor.id() + " is not an inequality x > y or x <= y");
      product *= excess(factor.statement());
      all_strict = all_strict && is_strict(factor.statement());
    }
    for (const Theorem& equation : equations)
      product = applied(equation, product, claim, rule, evidence);
    sum += product;
    strict = strict || all_strict;
  }
  require(strict || !is_strict(claim.statement), claim, rule, "no term is strictly positive");
  require_equal(difference, sum, claim, rule, evidence);
  return accept(claim, rule, evidence);
}

Theorem Kernel::strictly(const Claim& claim, const Theorem& at_most, const Theorem& different) {
  const std::string rule = "strict";
  Evidence evidence;
  use(at_most, claim, rule, evidence);
  use(different, claim, rule, evidence);
  require(at_most.statement().relation() == Relation::less_equal, claim, rule,
          at_most.id() + " does not read x <= y");
  require(different.statement().relation() == Relation::not_equal, claim, rule,
          different.id() + " does not read x != y");
  require(claim.statement.relation() == Relation::greater, claim, rule,
          "the claim must read y > x");
  require_equal(excess(claim.statement), excess(at_most.statement()), claim, rule, evidence);
  const ex gap = different.lhs() - different.rhs();
  require(is_zero(gap - excess(at_most.statement()), claim, evidence) ||
              is_zero(gap + excess(at_most.statement()), claim, evidence),
          claim, rule, different.id() + " is not about the same two sides");
  return accept(claim, rule, evidence);
}

Theorem Kernel::discharge(const Claim& claim, const Theorem& theorem,
                          const std::vector<Theorem>& proofs) {
  const std::string rule = "condition proved";
  Evidence evidence;
  use(theorem, claim, rule, evidence);
  require(claim.statement.relation() == theorem.statement().relation(), claim, rule,
          "the relations differ");
  require_equal(claim.statement.lhs(), theorem.lhs(), claim, rule, evidence);
  require_equal(claim.statement.rhs(), theorem.rhs(), claim, rule, evidence);
  Conditions met;
  const auto meets = [&](const Statement& proof, const Statement& needed) {
    const ex known = proof.lhs() - proof.rhs();
    const ex gap = needed.lhs() - needed.rhs();
    if (needed.relation() == Relation::not_equal)  // x > y or x != y: then x != y, y != x
      return (is_strict(proof) || proof.relation() == Relation::not_equal) &&
             (is_zero(known - gap, claim, evidence) || is_zero(known + gap, claim, evidence));
    return proof.relation() == needed.relation() && is_zero(known - gap, claim, evidence);
  };
  for (const Theorem& proof : proofs) {
    bool needed = false;
    for (const Condition& condition : theorem.conditions())
      if (condition.statement && meets(proof.statement(), *condition.statement)) {
        met.insert(condition);
        needed = true;
      }
    require(needed, claim, rule, proof.id() + " is no condition of " + theorem.id());
  }
  for (const Condition& condition : met) evidence.conditions.erase(condition);
  for (const Theorem& proof : proofs) use(proof, claim, rule, evidence);
  return accept(claim, rule, evidence);
}

// On [0, pi] the sine is >= 0, inside it is > 0, and sin x = -sin(x - pi).
Theorem Kernel::sine_sign(const Claim& claim, const std::vector<Theorem>& bounds) {
  const std::string rule = "sign of a sine";
  Evidence evidence;
  require(is_inequality(claim.statement), claim, rule, "the claim must read x > y or x <= y");
  const bool strict = is_strict(claim.statement);
  const bool left = claim.statement.rhs().is_zero();  // f(x) > 0 or f(x) <= 0; else 0 > f(x) ...
  const ex& function = left ? claim.statement.lhs() : claim.statement.rhs();
  require(left || claim.statement.lhs().is_zero(), claim, rule, "one side must be 0");
  const bool cosine = GiNaC::is_a<GiNaC::function>(function) &&
                      GiNaC::ex_to<GiNaC::function>(function).get_name() == "cos";
  require(cosine || (GiNaC::is_a<GiNaC::function>(function) &&
                     GiNaC::ex_to<GiNaC::function>(function).get_name() == "sin"),
          claim, rule, to_text(function) + " is not a sine or a cosine");
  require_scalar(function, claim, rule, evidence);
  const bool positive = left == strict;  // of the sine: > 0 on the left, or >= 0 on the right
  const ex x = function.op(0) + (cosine ? GiNaC::Pi / 2 : ex(0)) - (positive ? ex(0) : GiNaC::Pi);
  for (const Theorem& bound : bounds) {
    use(bound, claim, rule, evidence);
    require(is_inequality(bound.statement()), claim, rule,
            bound.id() + " is not an inequality x > y or x <= y");
  }
  const auto known = [&](const ex& needed) {  // needed > 0, or >= 0
    const ex written_out = definitions_.expand_except_angles(needed);
    if (is_positive(written_out, claim, evidence)) return true;
    if (!strict && is_zero(needed, claim, evidence)) return true;
    for (const Theorem& bound : bounds) {
      const ex slack = definitions_.expand_except_angles(needed - excess(bound.statement()));
      if (is_positive(slack, claim, evidence)) return true;
      if ((is_strict(bound.statement()) || !strict) && is_zero(slack, claim, evidence)) return true;
    }
    return false;
  };
  require(known(x), claim, rule,
          "it is not known that " + to_text(x) + (strict ? " > 0" : " >= 0"));
  require(known(GiNaC::Pi - x), claim, rule,
          "it is not known that " + to_text(x) + (strict ? " < pi" : " <= pi"));
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
