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

// All f_i > 0 at the first index; each f_i(n) is a sum of the f_k(n - 1) with factors >= 0, one of them > 0.
// So all f_i > 0 at every index.
Theorem Kernel::positivity_by_induction(const Claim& claim, const std::vector<ex>& values,
                                        const GiNaC::matrix& factors,
                                        const std::vector<Theorem>& initial,
                                        const std::vector<Theorem>& recurrences, const ex& n) {
  const std::string rule = "signs by induction";
  Evidence evidence;
  require(claim.statement.relation() == Relation::greater && claim.statement.rhs().is_zero(), claim,
          rule, "the claim must read e > 0");
  require(is_a<GiNaC::symbol>(n) && claim.indices.contains(to_text(n)), claim, rule,
          "the claim does not say where " + to_text(n) + " starts");
  const long first = claim.indices.at(to_text(n));
  const auto size = static_cast<unsigned>(values.size());
  require(size > 0 && factors.rows() == size && factors.cols() == size, claim, rule,
          "each value needs a row of factors");
  bool among = false;
  for (const ex& value : values) {
    require_visible(value, n, claim, rule);
    among = among || value.is_equal(claim.statement.lhs());
  }
  require(among, claim, rule, "the left side is none of the values");

  GiNaC::exmap at_first;
  for (const Theorem& theorem : initial) {
    use(theorem, claim, rule, evidence);
    require_equation(theorem, claim, rule);
    require(is_sequence(theorem.lhs()) && theorem.lhs().op(0).is_equal(first), claim, rule,
            theorem.id() + " is not about index " + std::to_string(first));
    at_first[theorem.lhs()] = theorem.rhs();
  }
  GiNaC::exmap step_back;
  for (const Theorem& theorem : recurrences) {
    use(theorem, claim, rule, evidence, to_text(n));
    require_equation(theorem, claim, rule);
    require_visible(theorem.rhs(), n, claim, rule);
    require(is_sequence(theorem.lhs()) && theorem.lhs().op(0).is_equal(n), claim, rule,
            theorem.id() + " does not give a sequence at " + to_text(n));
    const auto from = theorem.domain().integer.find(to_text(n));
    require(from != theorem.domain().integer.end() && from->second <= first + 1, claim, rule,
            theorem.id() + " does not hold from the first step on");
    for (const Condition& condition : theorem.conditions())
      if (condition.statement && (condition.statement->lhs() - condition.statement->rhs()).has(n))
        evidence.conditions.insert({condition.text + ", and so at every earlier " + to_text(n)});
    step_back[theorem.lhs()] = theorem.rhs();
  }

  Claim step = claim;
  step.indices[to_text(n)] = first + 1;
  for (unsigned i = 0; i < size; ++i) {
    const ex start = values[i]
                         .subs(n == first, subs_options::no_pattern)
                         .subs(at_first, subs_options::no_pattern);
    require(is_positive(start, claim, evidence), claim, rule,
            to_text(values[i]) + " is not seen to be positive at " + to_text(n) + " = " +
                std::to_string(first));
    ex sum = 0;
    bool some_positive = false;
    for (unsigned k = 0; k < size; ++k) {
      const ex& factor = factors(i, k);
      require(!contains_sequence(factor) && is_not_negative(factor, step, evidence), claim, rule,
              "the factor " + to_text(factor) + " is not seen to be >= 0");
      some_positive = some_positive || is_positive(factor, step, evidence);
      sum += factor * values[k].subs(n == n - 1, subs_options::no_pattern);
    }
    require(some_positive, claim, rule,
            "no factor of " + to_text(values[i]) + " is seen to be > 0");
    require_equal(values[i].subs(step_back, subs_options::no_pattern), sum, step, rule, evidence);
  }
  std::erase_if(evidence.conditions,
                [&](const Condition& condition) { return condition.index == to_text(n); });
  evidence.conditions.insert(index_condition(to_text(n), first));
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
