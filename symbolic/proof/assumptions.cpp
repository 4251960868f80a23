// SPDX-License-Identifier: GPL-2.0-or-later
// What a theorem takes for granted, and what becomes of it when symbols are replaced.
#include <algorithm>

#include <ginac/ginac.h>

#include "proof/families.hpp"
#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::subs_options;

namespace {

bool hides_dependence(const ex& e, const std::string& name) {
  if ((is_sequence(e) || is_family(e)) && depends_on_hidden(e, name)) return true;
  return std::any_of(e.begin(), e.end(),
                     [&](const ex& part) { return hides_dependence(part, name); });
}

}  // namespace

void Kernel::require_assumptions(const Claim& claim, const std::string& rule,
                                 Evidence& evidence) const {
  for (const Statement& assumption : claim.assuming) {
    require(
        assumption.relation() == Relation::greater || assumption.relation() == Relation::less_equal,
        claim, rule, "an assumption must read > or <=");
    const ex surplus = definitions_.expand_all(assumption.lhs() - assumption.rhs());
    std::set<std::string> names;
    collect_symbol_names(surplus, names);
    bool constant = !contains_sequence(surplus) && !contains_family(surplus);
    for (const auto& [name, from] : domain_of(claim).integer)
      constant = constant && !names.contains(name);
    require(constant, claim, rule, to_text(assumption) + " is not about constants");
    evidence.conditions.insert(condition(assumption));
  }
}

// A family is a function of its parameters, so a law or a definition of one speaks of nothing else.
void Kernel::require_family_law(const Claim& claim, const std::string& rule) const {
  const ex both = claim.statement.lhs() - claim.statement.rhs();
  if (!contains_family(claim.statement.lhs()) && !contains_family(claim.statement.rhs())) return;
  std::set<std::string> names;
  collect_symbol_names(definitions_.expand_all(both), names);
  for (const std::string& name : names) {
    const bool parameter = std::any_of(family_parameters().begin(), family_parameters().end(),
                                       [&](const ex& p) { return p.is_equal(symbol(name)); });
    require(parameter || claim.indices.contains(name) || name == "V" || name == "L", claim, rule,
            "a family does not depend on " + name);
  }
  require(
      families_are_general(claim.statement.lhs()) && families_are_general(claim.statement.rhs()),
      claim, rule, "a family is given for all parameters at once");
}

void Kernel::require_replaceable(const Theorem& general, const ex& replaced, const Claim& claim,
                                 const std::string& rule) const {
  const std::string name = to_text(replaced);
  if (general.domain().integer.contains(name)) return;
  const auto require_open = [&](const ex& e) {
    require(!hides_dependence(e, name), claim, rule, "sequences may depend on " + name);
  };
  require_open(general.lhs());
  require_open(general.rhs());
  for (const Condition& condition : general.conditions()) {
    std::vector<Statement> parts = condition.any_of;
    if (condition.statement) parts.push_back(*condition.statement);
    for (const Statement& part : parts) {
      require_open(part.lhs());
      require_open(part.rhs());
    }
    const bool in_words = parts.empty() && condition.index.empty();
    require(!in_words || !definitions_.speaks_of(condition.text, name), claim, rule,
            "the condition \"" + condition.text + "\" is in words and speaks of " + name);
  }
  // Counts such as N_A are numbers that depend on all parameters.
  for (const Theorem& earlier : theorems_)
    if (is_a<GiNaC::symbol>(earlier.lhs()) &&
        (earlier.step().rule == "last collision" || earlier.step().rule == "every other collision"))
      require(!mentions(general, to_text(earlier.lhs())), claim, rule,
              to_text(earlier.lhs()) + " may depend on " + name);
}

// "x = 1 or x = y" where x and y are replaced; nothing is left of it where one holds by itself.
void Kernel::add_alternatives_at(const Condition& general, const Values& values, const Claim& claim,
                                 Evidence& evidence) const {
  const std::string rule = "special case";
  GiNaC::exmap replacements;
  for (const auto& [name, value] : values) replacements[name] = value;
  Condition here{{}};
  for (const Statement& before : general.any_of) {
    const auto at_values = [&](const ex& side) {
      const ex value = written_out(side, values).subs(replacements, subs_options::no_pattern);
      require_scalar(value, claim, rule, evidence);
      return simplified(value, claim.indices, claim.assuming);
    };
    const Statement after(at_values(before.lhs()), at_values(before.rhs()));
    if (is_zero(after.lhs() - after.rhs(), claim, evidence)) return;
    here.any_of.push_back(after);
    here.text += (here.text.empty() ? "" : " or ") + to_text(after);
  }
  evidence.conditions.insert(here);
}

// Names that stand for something with one of these symbols in it, written out.
ex Kernel::written_out(const ex& e, const Values& values) const {
  GiNaC::exmap meanings;
  const auto visit = [&](const auto& self, const ex& part) -> void {
    if (is_a<GiNaC::symbol>(part) && definitions_.contains(ex_to<GiNaC::symbol>(part).get_name())) {
      const ex meaning = definitions_.expand_all(part);
      if (std::any_of(values.begin(), values.end(),
                      [&](const auto& value) { return meaning.has(value.first); }))
        meanings[part] = meaning;
    }
    for (const ex& inner : part) self(self, inner);
  };
  visit(visit, e);
  return e.subs(meanings, subs_options::no_pattern).evalm();
}

}  // namespace magicmass::proof
