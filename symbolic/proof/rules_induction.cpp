// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::subs_options;

Theorem Kernel::matrix_power(const Claim& claim, const Theorem& matrix, const ex& n) {
  const std::string rule = "induction";
  Evidence evidence;
  use(matrix, claim, rule, evidence);
  const ex& power = claim.statement.lhs();
  require(is_a<GiNaC::power>(power) && power.op(0).is_equal(matrix.lhs()) &&
              power.op(1).is_equal(n) && claim.indices.contains(to_text(n)) &&
              claim.indices.at(to_text(n)) == 0,
          claim, rule, "the claim must read " + to_text(matrix.lhs()) + "^n = F(n), n >= 0");
  const ex& formula = claim.statement.rhs();
  require_equation(matrix, claim, rule);
  require(is_a<GiNaC::matrix>(matrix.rhs()) && !definitions_.expand_all(matrix.rhs()).has(n), claim,
          rule, matrix.id() + " is not a constant matrix");
  require_visible(formula, n, claim, rule);
  const auto& base = ex_to<GiNaC::matrix>(matrix.rhs());
  require_equal(formula.subs(n == 0, subs_options::no_pattern), GiNaC::unit_matrix(base.rows()),
                claim, rule, evidence);
  require_equal(formula.subs(n == n + 1, subs_options::no_pattern),
                (matrix.rhs() * formula).evalm(), claim, rule, evidence);
  evidence.conditions.insert(index_condition(to_text(n), 0));
  return accept(claim, rule, evidence);
}

Theorem Kernel::induction(const Claim& claim, const std::vector<Theorem>& initial,
                          const std::vector<Theorem>& recurrences, const ex& n) {
  const std::string rule = "induction";
  Evidence evidence;
  require(claim.indices.contains(to_text(n)), claim, rule,
          "the claim does not say where " + to_text(n) + " starts");
  const long first = claim.indices.at(to_text(n));
  ex left = claim.statement.lhs();
  ex right = claim.statement.rhs();
  if (!is_a<GiNaC::matrix>(left)) {
    left = GiNaC::matrix{{left}};
    right = GiNaC::matrix{{right}};
  }
  require(left.nops() == initial.size() && left.nops() == recurrences.size() &&
              left.nops() == right.nops(),
          claim, rule, "each sequence needs one initial value and one recurrence");

  require_visible(right, n, claim, rule);
  GiNaC::exmap earlier;  // f(n - 1) -> F(n - 1)
  for (size_t i = 0; i < left.nops(); ++i) {
    require(is_sequence(left.op(i)) && left.op(i).op(0).is_equal(n), claim, rule,
            to_text(left.op(i)) + " is not an element of a sequence at " + to_text(n));
    earlier[left.op(i).subs(n == n - 1, subs_options::no_pattern)] =
        right.op(i).subs(n == n - 1, subs_options::no_pattern);
  }
  Claim step = claim;  // the inductive step speaks of n from first + 1 on
  step.indices[to_text(n)] = first + 1;
  for (size_t i = 0; i < left.nops(); ++i) {
    const ex& element = left.op(i);
    const auto at_first = [&](const ex& e) { return e.subs(n == first, subs_options::no_pattern); };
    require(initial[i].lhs().is_equal(at_first(element)), claim, rule,
            initial[i].id() + " does not give " + to_text(at_first(element)));
    use(initial[i], claim, rule, evidence);
    require_equation(initial[i], claim, rule);
    require_equation(recurrences[i], claim, rule);
    require_equal(initial[i].rhs(), at_first(right.op(i)), claim, rule, evidence);

    require(recurrences[i].lhs().is_equal(element), claim, rule,
            recurrences[i].id() + " does not give " + to_text(element));
    const auto from = recurrences[i].domain().integer.find(to_text(n));
    require(from != recurrences[i].domain().integer.end() && from->second <= first + 1, claim, rule,
            recurrences[i].id() + " does not hold from the first step on");
    use(recurrences[i], claim, rule, evidence, to_text(n));
    Evidence of_step;  // needed at every index on the way, and not at the first
    of_step.conditions = recurrences[i].conditions();
    const ex next = recurrences[i].rhs().subs(earlier, subs_options::no_pattern);
    require(!contains_sequence(next), claim, rule,
            recurrences[i].id() + " uses more than the elements at " + to_text(n) + " - 1");
    require_equal(next, right.op(i), step, rule, of_step);
    for (const Condition& condition : of_step.conditions) {
      const bool of_n =
          condition.statement && (condition.statement->lhs() - condition.statement->rhs()).has(n);
      if (of_n)
        evidence.conditions.insert({condition.text + " for every " + to_text(n) + " from " +
                                    std::to_string(first + 1) + " up to there"});
      else if (condition.index != to_text(n))
        evidence.conditions.insert(condition);
    }
  }
  std::erase_if(evidence.conditions,
                [&](const Condition& condition) { return condition.index == to_text(n); });
  evidence.conditions.insert(index_condition(to_text(n), first));
  return accept(claim, rule, evidence);
}

Theorem Kernel::first_and_later(const Claim& claim, const Theorem& at_first, const Theorem& later,
                                const ex& n) {
  const std::string rule = "the first and all later";
  Evidence evidence;
  require(is_a<GiNaC::symbol>(n) && claim.indices.contains(to_text(n)), claim, rule,
          "the claim does not say where " + to_text(n) + " starts");
  const long first = claim.indices.at(to_text(n));
  Claim rest = claim;
  rest.indices[to_text(n)] = first + 1;
  use(at_first, claim, rule, evidence);
  use(later, rest, rule, evidence);
  require_equation(at_first, claim, rule);
  require_equation(later, claim, rule);
  for (const ex& side : {claim.statement.lhs(), claim.statement.rhs()})
    require_visible(side, n, claim, rule);
  const auto difference_at = [&](const ex& value) {
    return (claim.statement.lhs() - claim.statement.rhs())
        .subs(n == value, subs_options::no_pattern);
  };
  require(
      later.lhs().is_equal(claim.statement.lhs()) &&
          at_first.lhs().is_equal(claim.statement.lhs().subs(n == first, subs_options::no_pattern)),
      claim, rule, "the premises are about something else");
  require_equal(later.lhs() - later.rhs(), difference_at(n), rest, rule, evidence);
  require_equal(at_first.lhs() - at_first.rhs(), difference_at(first), claim, rule, evidence);
  std::erase_if(evidence.conditions,
                [&](const Condition& condition) { return condition.index == to_text(n); });
  evidence.conditions.insert(index_condition(to_text(n), first));
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
