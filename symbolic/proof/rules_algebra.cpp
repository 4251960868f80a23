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

namespace {

ex difference(const Statement& statement) { return (statement.lhs() - statement.rhs()).evalm(); }

void collect_elements(const ex& e, const std::string& name, GiNaC::exset& elements) {
  if (is_sequence(e) && function_name(e) == name) elements.insert(e);
  for (const ex& part : e) collect_elements(part, name, elements);
}

}  // namespace

Theorem Kernel::identity(const Claim& claim) {
  Evidence evidence;
  require(claim.statement.relation() == Relation::equal, claim, "identity",
          "an identity is an equation");
  require_equal(claim.statement.lhs(), claim.statement.rhs(), claim, "identity", evidence);
  return accept(claim, "identity", evidence);
}

Theorem Kernel::consequence(const Claim& claim, const Combination& premises) {
  const std::string rule = "linear combination";
  Evidence evidence;
  ex combination = 0;
  for (const auto& [premise, cofactor] : premises) {
    require(premise.statement().relation() == Relation::equal, claim, rule,
            premise.id() + " is not an equation");
    require_scalar(cofactor, claim, rule, evidence);  // before GiNaC cancels 0/0
    combination += cofactor * difference(premise.statement());
    use(premise, claim, rule, evidence);
  }
  require(claim.statement.relation() == Relation::equal, claim, rule,
          "the claim is not an equation");
  require_equal(difference(claim.statement), combination, claim, rule, evidence);
  return accept(claim, rule, evidence);
}

// One equation used as a rule, left to right, everywhere at once.
ex Kernel::applied(const Theorem& equation, const ex& e, const Claim& claim,
                   const std::string& rule, Evidence& evidence) const {
  require(equation.statement().relation() == Relation::equal, claim, rule,
          equation.id() + " is not an equation");
  const ex& left = equation.lhs();
  const bool pattern = is_sequence(left) && is_a<GiNaC::symbol>(left.op(0));
  use(equation, claim, rule, evidence, pattern ? to_text(left.op(0)) : "");
  GiNaC::exmap replacements;
  if (pattern) {
    const ex index = left.op(0);
    const std::string index_name = ex_to<GiNaC::symbol>(index).get_name();
    require_visible(equation.rhs(), index, claim, rule);
    for (const Condition& condition : equation.conditions())
      if (condition.statement)
        require_visible(condition.statement->lhs() - condition.statement->rhs(), index, claim,
                        rule);
    GiNaC::exset elements;
    collect_elements(e, function_name(left), elements);
    for (const ex& element : elements) {
      const ex value = element.op(0);
      bool same_family = element.nops() == left.nops();
      for (size_t i = 1; same_family && i < left.nops(); ++i)
        same_family =
            element.op(i).is_equal(left.op(i).subs(index == value, subs_options::no_pattern));
      if (!same_family) continue;
      const auto from = equation.domain().integer.find(index_name);
      require(from != equation.domain().integer.end(), claim, rule,
              "the index of " + equation.id() + " is not an integer");
      if (!is_integer(value, claim) || !is_positive(value - from->second + 1, claim, evidence))
        continue;
      replacements[element] = equation.rhs().subs(index == value, subs_options::no_pattern);
      add_conditions_at(equation, {{index, value}}, claim, evidence);
    }
  } else {
    replacements[left] = equation.rhs();
  }
  return e.subs(replacements, subs_options::no_pattern).evalm();
}

Theorem Kernel::rewriting(const Claim& claim, const std::vector<Theorem>& equations) {
  const std::string rule = "substitution";
  Evidence evidence;
  require(claim.statement.relation() == Relation::equal, claim, rule,
          "the claim is not an equation");
  ex left = claim.statement.lhs();
  ex right = claim.statement.rhs();
  for (const Theorem& equation : equations) {
    left = applied(equation, left, claim, rule, evidence);
    right = applied(equation, right, claim, rule, evidence);
  }
  require_equal(left, right, claim, rule, evidence);
  return accept(claim, rule, evidence);
}

Theorem Kernel::cancellation(const Claim& claim, const Theorem& product, const ex& factor,
                             const std::optional<Theorem>& nonzero) {
  const std::string rule = "cancellation";
  Evidence evidence;
  use(product, claim, rule, evidence);
  require_equation(product, claim, rule);
  require_scalar(factor, claim, rule, evidence);
  require(claim.statement.relation() == Relation::equal, claim, rule,
          "the claim is not an equation");
  require_equal(difference(product.statement()), factor * difference(claim.statement), claim, rule,
                evidence);
  if (nonzero) {
    use(*nonzero, claim, rule, evidence);
    require(nonzero->statement().relation() == Relation::not_equal, claim, rule,
            nonzero->id() + " does not say that a difference is not zero");
    const ex known = difference(nonzero->statement());
    const ex ratio = simplified(factor / known, claim.indices);
    require(is_positive(ratio, claim, evidence) || is_positive(-ratio, claim, evidence), claim,
            rule, nonzero->id() + " does not show that " + to_text(factor) + " is not zero");
    require_equal(factor, known * ratio, claim, rule, evidence);
    evidence.conditions.insert(condition(nonzero->statement()));
  } else {
    require(is_positive(factor, claim, evidence) || is_positive(-factor, claim, evidence), claim,
            rule, "it is not known that " + to_text(factor) + " never vanishes");
  }
  return accept(claim, rule, evidence);
}

Theorem Kernel::instance(const Claim& claim, const Theorem& general, const Values& values) {
  const std::string rule = "special case";
  Evidence evidence;
  require_own(general, claim, rule);
  evidence.premises.push_back(general.id());
  require(claim.statement.relation() == general.statement().relation(), claim, rule,
          "the relations differ");
  require(general.statement().relation() != Relation::asymptotic, claim, rule,
          general.id() + " holds in the limit only");
  GiNaC::exmap replacements;
  for (const auto& [symbol, value] : values) {
    const std::string name = to_text(symbol);
    require(is_a<GiNaC::symbol>(symbol) && !definitions_.contains(name), claim, rule,
            name + " is not a free symbol");
    require(!fixed_.contains(name) || general.domain().integer.contains(name), claim, rule,
            "a law speaks of " + name + " itself, not of anything in its place");
    if (general.domain().positive.contains(name))
      require(is_positive(value, claim, evidence), claim, rule,
              to_text(value) + " is not known to be positive, as " + name + " must be");
    if (const auto integer = general.domain().integer.find(name);
        integer != general.domain().integer.end())
      require(is_integer(value, claim) && is_positive(value - integer->second + 1, claim, evidence),
              claim, rule,
              to_text(value) + " is not known to be an integer >= " +
                  std::to_string(integer->second) + ", as " + name + " must be");
    replacements[symbol] = value;
    require_scalar(value, claim, rule, evidence);
    require_replaceable(general, symbol, claim, rule);
  }
  for (const auto& [name, from] : general.domain().integer) {
    const ex index = symbol(name);
    if (replacements.contains(index) || !mentions(general, name)) continue;
    const auto own = claim.indices.find(name);
    require(own != claim.indices.end() && own->second >= from, claim, rule,
            general.id() + " holds for " + name + " >= " + std::to_string(from) + " only");
    evidence.conditions.insert(index_condition(name, own->second));
  }
  const auto at_values = [&](const ex& side) {
    return definitions_.with_angle_names(
        written_out(side, values).subs(replacements, subs_options::no_pattern));
  };
  require_equal(definitions_.with_angle_names(claim.statement.lhs()), at_values(general.lhs()),
                claim, rule, evidence);
  require_equal(definitions_.with_angle_names(claim.statement.rhs()), at_values(general.rhs()),
                claim, rule, evidence);
  for (const Condition& condition : general.conditions())
    if (!condition.statement && condition.any_of.empty() &&
        (condition.index.empty() || !mentions(general, condition.index)))
      evidence.conditions.insert(condition);
  add_conditions_at(general, values, claim, evidence);
  return accept(claim, rule, evidence);
}

Theorem Kernel::component(const Claim& claim, const Theorem& columns, unsigned row) {
  const std::string rule = "component";
  Evidence evidence;
  use(columns, claim, rule, evidence);
  require(columns.statement().relation() == Relation::equal && is_a<GiNaC::matrix>(columns.lhs()) &&
              is_a<GiNaC::matrix>(columns.rhs()) && row < columns.lhs().nops(),
          claim, rule, columns.id() + " has no such entry");
  require(claim.statement.lhs().is_equal(columns.lhs().op(row)), claim, rule,
          "the left side is not that entry");
  require_equal(claim.statement.rhs(), columns.rhs().op(row), claim, rule, evidence);
  return accept(claim, rule, evidence);
}

Theorem Kernel::cases(const Claim& claim, const std::vector<std::pair<Values, Theorem>>& all) {
  const std::string rule = "cases";
  Evidence evidence;
  require(!all.empty() && claim.statement.relation() == Relation::equal, claim, rule,
          "no case, or not an equation");
  Condition one_of{{}};  // that these are all the cases is a condition
  bool by_value = true;
  for (const auto& [values, theorem] : all) {
    use(theorem, claim, rule, evidence);
    require_equation(theorem, claim, rule);
    GiNaC::exmap replacements;
    std::string shown;
    for (const auto& [name, value] : values) {
      replacements[name] = value;
      shown += (shown.empty() ? "" : ", ") + to_text(name) + " = " + to_text(value);
    }
    one_of.text += (one_of.text.empty() ? "" : " or ") + shown;
    by_value = by_value && values.size() == 1;
    if (by_value) one_of.any_of.emplace_back(values[0].first, values[0].second);
    require_equal(difference(claim.statement).subs(replacements, subs_options::no_pattern),
                  difference(theorem.statement()), claim, rule, evidence);
  }
  if (!by_value) one_of.any_of.clear();
  evidence.conditions.insert(one_of);
  return accept(claim, rule, evidence);
}

Theorem Kernel::positivity(const Claim& claim) {
  const std::string rule = "sign";
  Evidence evidence;
  require(claim.statement.relation() == Relation::greater && claim.statement.rhs().is_zero(), claim,
          rule, "the claim must read e > 0");
  require(is_positive(claim.statement.lhs(), claim, evidence), claim, rule,
          "the sign does not follow from the signs of factors and coefficients");
  return accept(claim, rule, evidence);
}

bool Kernel::is_integer(const ex& e, const Claim& claim) const {
  const Domain domain = domain_of(claim);
  if (is_a<GiNaC::numeric>(e)) return ex_to<GiNaC::numeric>(e).is_integer();
  if (is_a<GiNaC::symbol>(e)) return domain.integer.contains(ex_to<GiNaC::symbol>(e).get_name());
  if (!is_a<GiNaC::add>(e) && !is_a<GiNaC::mul>(e)) return false;
  for (const ex& part : e)
    if (!is_integer(part, claim)) return false;
  return true;
}

}  // namespace magicmass::proof
