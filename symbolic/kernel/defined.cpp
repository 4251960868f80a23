// SPDX-License-Identifier: GPL-2.0-or-later
// Collects the conditions under which a formula makes sense.
#include "kernel/defined.hpp"

#include <algorithm>

#include "kernel/names.hpp"

namespace kernel {
namespace {
struct Domain {
  Exprs params;
  Expr condition;
};
std::map<std::string, Domain>& domains() {
  static std::map<std::string, Domain> table = {
      {"inv", {{real("x")}, neq(real("x"), 0)}},
      {"sqrt", {{real("x")}, le(0, real("x"))}},
  };
  return table;
}
Expr at_arguments(Expr formula, const Exprs& params, const Exprs& args) {
  Substitution s;
  for (std::size_t i = 0; i < params.size(); ++i) s.emplace(params[i], args[i]);
  return substitute(formula, s);
}

class Collector {
public:
  explicit Collector(Expr formula) : used(free_variables(formula)) { collect(formula, {}); }
  Exprs found;

private:
  void collect(Expr e, Exprs guards) {
    if (e.weight() > 200000) refuse("a formula of more than 200000 nodes");
    if (e.op() == Op::Imp || e.op() == Op::And) {  // a part is read where those before it hold
      for (Expr part : e.args()) {
        collect(part, guards);
        guards.push_back(part);
      }
    } else if (e.op() == Op::All) {
      collect(open(e, fresh(e.bound_sort())), guards);
    } else {
      for (Expr a : e.args()) collect(a, guards);
      if (e.op() == Op::Fun) of_function(e, guards);
      if (e.op() == Op::MatrixPower) need(le(0, e.arg(1)), guards);  // of others nothing is known
    }
  }
  void of_function(Expr e, const Exprs& guards) {
    const Signature& s = *signature(e.name());
    if (s.body) collect(at_arguments(s.body, s.variables, e.args()), guards);
    const auto it = domains().find(e.name());
    if (it == domains().end()) return;
    need(at_arguments(it->second.condition, it->second.params, e.args()), guards);
  }
  void need(Expr condition, const Exprs& guards) {
    if (!guards.empty()) condition = imp(logic_and(guards), condition);
    if (std::find(found.begin(), found.end(), condition) == found.end()) found.push_back(condition);
  }
  // A variable that stands nowhere in the formula and was not given before.
  Expr fresh(Sort sort) {
    for (int k = 1;; ++k) {
      const std::string name = (sort == Sort::Int ? "any_integer" : "any") + std::to_string(k);
      if (!why_no_variable(name, sort).empty()) continue;
      const Expr v = sort == Sort::Int ? integer(name) : real(name);
      if (used.insert(v).second) return v;
    }
  }
  std::set<Expr> used;
};
}  // namespace

void restrict_domain(const std::string& name, const Exprs& params, Expr condition) {
  const Signature* s = signature(name);
  if (!s) refuse("no function " + name);
  if (s->args.size() != params.size()) refuse(name + " has another number of arguments");
  const std::set<Expr> allowed(params.begin(), params.end());
  if (allowed.size() != params.size()) refuse("a parameter of " + name + " twice");
  for (std::size_t i = 0; i < params.size(); ++i)
    if (params[i].op() != Op::Var || params[i].sort() != s->args[i])
      refuse("a parameter of " + name + " must be a variable of its sort");
  if (!is_formula(condition)) refuse("the domain of " + name + " must be a formula");
  for (Expr v : free_variables(condition))
    if (!allowed.count(v)) refuse(v.name() + " is in the domain of " + name + ", no parameter");
  if (!domains().emplace(name, Domain{params, condition}).second)
    refuse(name + " has a domain already");
}
Exprs needs(Expr formula) {
  if (!is_formula(formula)) refuse("only a formula needs to make sense");
  return Collector(formula).found;
}
Exprs needs(const Theorem& t) {
  const Exprs hypotheses = t.hypotheses();
  return needs(hypotheses.empty() ? t.conclusion() : imp(logic_and(hypotheses), t.conclusion()));
}
}  // namespace kernel
