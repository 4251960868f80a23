// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/kernel.hpp"

#include <algorithm>
#include <set>

#include <ginac/ginac.h>

#include "proof/names.hpp"
#include "proof/normal_form.hpp"
#include "proof/sampling.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

namespace {

// Keys are printed names: two symbols of one name, or a complex one, would be taken for each other.
// The index of a sum is known inside sums only.
bool only_known_symbols(const ex& e) {
  if (is_finite_sum(e))
    return only_known_symbols(e.op(0).subs(summation_index() == 1)) &&
           only_known_symbols(e.op(1)) && only_known_symbols(e.op(2));
  if (is_a<GiNaC::symbol>(e)) return e.is_equal(symbol(ex_to<GiNaC::symbol>(e).get_name()));
  return std::all_of(e.begin(), e.end(), only_known_symbols);
}

// The rules that look at the relation of their claim themselves.
bool may_be_an_inequality(const std::string& rule) {
  static const std::set<std::string> rules{"sign",
                                           "special case",
                                           "sum of what is positive",
                                           "strict",
                                           "ceiling",
                                           "angle below pi",

                                           "smaller cosine on [0, pi]",
                                           "signs by induction",
                                           "series",
                                           "series of a count",
                                           "condition proved",
                                           "sign of a sine"};
  return rules.contains(rule);
}

bool uses_sequence(const ex& e, const std::string& name) {
  return (is_sequence(e) && function_name(e) == name) ||
         std::any_of(e.begin(), e.end(), [&](const ex& part) { return uses_sequence(part, name); });
}

}  // namespace

struct Theorem::Data {
  Step step;
  Statement statement;
  Domain domain;
  Conditions conditions;
  std::set<std::string> symbols;  // of both sides, all names written out
};

const Step& Theorem::step() const { return data_->step; }
const Statement& Theorem::statement() const { return data_->statement; }
const Domain& Theorem::domain() const { return data_->domain; }
const Conditions& Theorem::conditions() const { return data_->conditions; }

NotProved::NotProved(Step refused, const std::string& reason)
    : Error(refused.id + ": not proved: " + refused.from + " " + refused.relation + " " +
            refused.to + ": " + reason),
      step(std::move(refused)) {}

Kernel::Kernel(Domain domain) : domain_(std::move(domain)) {}

Domain Kernel::domain_of(const Claim& claim) const {
  Domain domain = domain_;
  for (const auto& [name, from] : claim.indices) {
    domain.integer[name] = from;
    domain.positive.erase(name);  // an index m >= 0 is no mass m > 0
  }
  domain.assumed.insert(domain.assumed.end(), claim.assuming.begin(), claim.assuming.end());
  return domain;
}

ex Kernel::simplified(const ex& e, const std::map<std::string, long>& indices,
                      const std::vector<Statement>& assuming) const {
  const Claim setting{.id = {}, .statement = {e, e}, .indices = indices, .assuming = assuming};
  return NormalForm(domain_of(setting), definitions_).simplified(e.evalm());
}

bool Kernel::mentions(const Theorem& theorem, const std::string& name) const {
  return theorem.data_->symbols.contains(name);
}

Step Kernel::step_for(const Claim& claim, const std::string& rule, const Evidence& evidence) const {
  std::vector<std::string> conditions;
  for (const Condition& condition : evidence.conditions) conditions.push_back(condition.text);
  const std::string left = to_text(claim.statement.lhs()), right = to_text(claim.statement.rhs());
  const std::string relation = to_text(claim.statement.relation());
  return {claim.id,
          rule,
          claim.shown_lhs.empty() ? left : claim.shown_lhs,
          relation,
          claim.shown_rhs.empty() ? right : claim.shown_rhs,
          conditions,
          claim.label,
          claim.words,
          "proved",
          evidence.premises,
          left + " " + relation + " " + right};
}

void Kernel::require_new_id(const Claim& claim) const {
  for (const Theorem& earlier : theorems_)
    if (earlier.id() == claim.id) throw std::logic_error("two steps are called " + claim.id);
}

Theorem Kernel::accept(const Claim& claim, const std::string& rule, const Evidence& found,
                       const std::string& verdict) {
  Evidence evidence = found;
  require_assumptions(claim, rule, evidence);
  Step step = step_for(claim, rule, evidence);
  step.verdict = verdict;
  if (verdict == "proved" && !may_be_an_inequality(rule))
    require(claim.statement.relation() == Relation::equal, claim, rule,
            "the claim is not an equation");
  for (const auto& [name, from] : claim.indices)
    require(!definitions_.contains(name), claim, rule, "the index " + name + " has a definition");
  require_new_id(claim);
  for (const ex& side : {claim.statement.lhs(), claim.statement.rhs()})
    require(only_known_symbols(side), claim, rule, "a symbol that symbol(name) did not make");
  // A name gets its meaning before its first use, so what is written out now stays so.
  std::set<std::string> symbols;
  for (const ex& side : {claim.statement.lhs(), claim.statement.rhs()})
    collect_symbol_names(definitions_.expand_all(side), symbols);
  theorems_.push_back(Theorem(std::make_shared<const Theorem::Data>(Theorem::Data{
      step, claim.statement, domain_of(claim), evidence.conditions, std::move(symbols)})));
  return theorems_.back();
}

void Kernel::refuse(const Claim& claim, const std::string& rule, const std::string& reason) const {
  Step step = step_for(claim, rule, {});
  step.verdict = "refused";
  throw NotProved(step, reason);
}

void Kernel::require(bool holds, const Claim& claim, const std::string& rule,
                     const std::string& reason) const {
  if (!holds) refuse(claim, rule, reason);
}

void Kernel::require_equal(const ex& lhs, const ex& rhs, const Claim& claim,
                           const std::string& rule, Evidence& evidence) const {
  const ex left = definitions_.expand_except_angles(lhs);
  const ex right = definitions_.expand_except_angles(rhs);
  const bool matrices = is_a<GiNaC::matrix>(left) || is_a<GiNaC::matrix>(right);
  if (matrices)
    require(is_a<GiNaC::matrix>(left) && is_a<GiNaC::matrix>(right) &&
                ex_to<GiNaC::matrix>(left).rows() == ex_to<GiNaC::matrix>(right).rows() &&
                ex_to<GiNaC::matrix>(left).cols() == ex_to<GiNaC::matrix>(right).cols(),
            claim, rule, "the sides have different shapes");
  const Domain domain = domain_of(claim);
  // Of identical sides it only has to be seen that they are defined somewhere.
  const int points = left.is_equal(right) ? 1 : sampled_points;
  const auto difference = counterexample(left, right, domain, definitions_, claim.id, points);
  if (difference) refuse(claim, rule, *difference);
  NormalForm form(domain, definitions_);
  try {
    require(form.are_equal(left, right), claim, rule,
            "the normal form of the difference of " + to_text(left) + " and " + to_text(right) +
                " is not zero, though the sides agree at every point tried");
  } catch (const NotInClass& outside) {
    refuse(claim, rule, outside.what());
  }
  evidence.conditions.insert(form.conditions().begin(), form.conditions().end());
}

bool Kernel::is_positive(const ex& e, const Claim& claim, Evidence& evidence) const {
  NormalForm form(domain_of(claim), definitions_);
  try {
    if (!form.is_positive(e)) return false;
  } catch (const NotInClass&) {
    return false;
  }
  evidence.conditions.insert(form.conditions().begin(), form.conditions().end());
  return true;
}

bool Kernel::is_not_negative(const ex& e, const Claim& claim, Evidence& evidence) const {
  NormalForm form(domain_of(claim), definitions_);
  try {
    if (!form.is_not_negative(e)) return false;
  } catch (const NotInClass&) {
    return false;
  }
  evidence.conditions.insert(form.conditions().begin(), form.conditions().end());
  return true;
}

bool Kernel::is_zero(const ex& e, const Claim& claim, Evidence& evidence) const {
  NormalForm form(domain_of(claim), definitions_);
  try {
    if (!form.is_zero(definitions_.expand_except_angles(e))) return false;
  } catch (const NotInClass&) {
    return false;
  }
  evidence.conditions.insert(form.conditions().begin(), form.conditions().end());
  return true;
}

Theorem Kernel::law(const Claim& claim) {
  require_family_law(claim, "law");
  const Theorem result = accept(claim, "law", {}, "law");
  const auto visit = [&](const auto& self, const ex& part) -> void {
    if (is_a<GiNaC::symbol>(part)) {
      const std::string name = ex_to<GiNaC::symbol>(part).get_name();
      if (!claim.schematic.contains(name) && !claim.indices.contains(name)) fixed_.insert(name);
    }
    for (const ex& inner : part) self(self, inner);
  };
  visit(visit, definitions_.expand_all(claim.statement.lhs()));
  visit(visit, definitions_.expand_all(claim.statement.rhs()));
  return result;
}

Theorem Kernel::definition(const Claim& claim) {
  require_new_id(claim);
  require_family_law(claim, "definition");
  Evidence evidence;
  const ex& name = claim.statement.lhs();
  require(claim.statement.relation() == Relation::equal, claim, "definition",
          "a definition is an equation");
  if (is_a<GiNaC::symbol>(name)) {
    const std::string text_name = ex_to<GiNaC::symbol>(name).get_name();
    require(!domain_.positive.contains(text_name) && !domain_.integer.contains(text_name) &&
                !definitions_.contains(text_name),
            claim, "definition", "the name is taken");
    for (const Theorem& earlier : theorems_)
      require(!mentions(earlier, text_name) && !earlier.domain().integer.contains(text_name), claim,
              "definition", "the name is in use already, in " + earlier.id());
    if (is_a<GiNaC::matrix>(claim.statement.rhs())) {
      for (const ex& entry : claim.statement.rhs())
        require_scalar(entry, claim, "definition", evidence);
    } else {
      require_scalar(claim.statement.rhs(), claim, "definition", evidence);
    }
    definitions_.add(text_name, claim.statement.rhs());
  } else {
    require(is_sequence(name) && is_a<GiNaC::symbol>(name.op(0)), claim, "definition",
            "the left side must be a new name or a sequence such as T(m)");
    require(!uses_sequence(definitions_.expand_all(claim.statement.rhs()), function_name(name)),
            claim, "definition", "the definition uses itself");
    for (const Theorem& earlier : theorems_)
      require(!uses_sequence(earlier.lhs(), function_name(name)) &&
                  !uses_sequence(earlier.rhs(), function_name(name)),
              claim, "definition", "the sequence is in use already, in " + earlier.id());
    require_scalar(claim.statement.rhs(), claim, "definition", evidence);
  }
  return accept(claim, "definition", evidence, "definition");
}

Theorem Kernel::hypothesis(const Claim& claim) {
  Evidence evidence;
  evidence.conditions.insert(condition(claim.statement));
  return accept(claim, "hypothesis", evidence, "hypothesis");
}

}  // namespace magicmass::proof
