// SPDX-License-Identifier: GPL-2.0-or-later
// What a rule asks of its premises, and what they hand on: conditions, indices and ids.
#include <algorithm>

#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/normal_form.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

void Kernel::require_own(const Theorem& premise, const Claim& claim,
                         const std::string& rule) const {
  require(std::any_of(theorems_.begin(), theorems_.end(),
                      [&](const Theorem& own) { return own.data_ == premise.data_; }),
          claim, rule, premise.id() + " is not a theorem of this kernel");
  for (const auto& [name, from] : claim.indices)
    require(!premise.domain().positive.contains(name) || !mentions(premise, name), claim, rule,
            premise.id() + " means a positive number by " + name + ", not an index");
}

void Kernel::require_equation(const Theorem& premise, const Claim& claim,
                              const std::string& rule) const {
  require(premise.statement().relation() == Relation::equal, claim, rule,
          premise.id() + " is not an equation");
}

void Kernel::require_scalar(const ex& e, const Claim& claim, const std::string& rule,
                            Evidence& evidence) const {
  NormalForm form(domain_of(claim), definitions_);
  try {
    const ex scalar = definitions_.expand_except_angles(e);
    require(!is_a<GiNaC::matrix>(scalar), claim, rule, to_text(e) + " is a matrix");
    form.require_defined(scalar);
  } catch (const NotInClass& outside) {
    refuse(claim, rule, outside.what());
  }
  evidence.conditions.insert(form.conditions().begin(), form.conditions().end());
}

void Kernel::require_visible(const ex& e, const ex& name, const Claim& claim,
                             const std::string& rule) const {
  const auto visit = [&](const auto& self, const ex& part) -> void {
    if (is_a<GiNaC::symbol>(part) && definitions_.contains(ex_to<GiNaC::symbol>(part).get_name()))
      require(!definitions_.expand_all(part).has(name), claim, rule,
              to_text(part) + " depends on " + to_text(name) + ": write it out first");
    for (const ex& inner : part) self(self, inner);
  };
  visit(visit, e);
}

void Kernel::use(const Theorem& premise, const Claim& claim, const std::string& rule,
                 Evidence& evidence, const std::string& bound) const {
  require_own(premise, claim, rule);
  if (std::find(evidence.premises.begin(), evidence.premises.end(), premise.id()) ==
      evidence.premises.end())
    evidence.premises.push_back(premise.id());
  for (const Condition& condition : premise.conditions()) {
    const bool of_bound =
        !bound.empty() && condition.statement &&
        (condition.statement->lhs() - condition.statement->rhs()).has(symbol(bound));
    const bool of_statement = !condition.index.empty() &&
                              (condition.index == bound || mentions(premise, condition.index));
    if (!of_statement && !of_bound) evidence.conditions.insert(condition);
  }
  for (const auto& [name, from] : premise.domain().integer) {
    if (name == bound) continue;
    if (!mentions(premise, name)) continue;
    const auto own = claim.indices.find(name);
    require(own != claim.indices.end() && own->second >= from, claim, rule,
            premise.id() + " holds for " + name + " >= " + std::to_string(from) + " only");
    evidence.conditions.insert(index_condition(name, own->second));
  }
}

void Kernel::add_conditions_at(const Theorem& premise, const Values& values, const Claim& claim,
                               Evidence& evidence) const {
  GiNaC::exmap replacements;
  for (const auto& [name, value] : values) replacements[name] = value;
  for (const Condition& general : premise.conditions()) {
    if (!general.any_of.empty()) add_alternatives_at(general, values, claim, evidence);
    if (!general.statement) continue;
    const Statement& before = *general.statement;
    const auto at_values = [&](const ex& side) {
      return definitions_.with_angle_names(
          written_out(side, values).subs(replacements, GiNaC::subs_options::no_pattern));
    };
    const Statement here(at_values(before.lhs()), before.relation(), at_values(before.rhs()));
    if (here.lhs().is_equal(before.lhs()) && here.rhs().is_equal(before.rhs())) {
      evidence.conditions.insert(general);
      continue;
    }
    const ex surplus = here.lhs() - here.rhs();
    const bool holds =
        (here.relation() == Relation::greater && is_positive(surplus, claim, evidence)) ||
        (here.relation() == Relation::not_equal &&
         (is_positive(surplus, claim, evidence) || is_positive(-surplus, claim, evidence)));
    if (!holds) evidence.conditions.insert(condition(here));
  }
}

}  // namespace magicmass::proof
