// Definitions: a new name (declare refuses a used one) for a function of its parameters, which are
// distinct variables and all that the definition depends on. So the function exists, whatever else
// is assumed, and no instance can separate a name from what it depends on.
#include <algorithm>

#include "kernel/names.hpp"
#include "kernel/theorem.hpp"

namespace kernel {
namespace {
Exprs with(Exprs list, const Exprs& more) {
  list.insert(list.end(), more.begin(), more.end());
  return list;
}
void check_depends_on(const Exprs& params, Expr e) {
  const std::set<Expr> allowed(params.begin(), params.end());
  for (Expr v : free_variables(e))
    if (!allowed.count(v)) refuse(brief(v) + " is in the definition but is not a parameter");
}
std::vector<Sort> sorts_of(const Exprs& params) {
  std::vector<Sort> out;
  std::set<Expr> seen;
  for (Expr p : params) {
    if (p.op() != Op::Var) refuse("a parameter must be a variable, not " + brief(p));
    if (!seen.insert(p).second) refuse("the parameter " + brief(p) + " twice");
    out.push_back(p.sort());
  }
  return out;
}
}  // namespace

// DEFINE. The function with the term's value, or the predicate that is true where the formula is.
Theorem define(const std::string& name, const Exprs& params, Expr term, int hidden) {
  const std::vector<Sort> sorts = sorts_of(params);
  if (!is_term(term) && !is_matrix(term) && !is_formula(term))
    refuse("only a closed term, matrix or formula can be named");
  check_depends_on(params, term);
  if (hidden < -1 || hidden > int(params.size())) refuse("more hidden parameters than parameters");
  const auto end = hidden < 0 ? params.end() : params.begin() + hidden;
  const bool predicate = term.sort() == Sort::Bool;
  declare(name, {.args = sorts,
                 .result = term.sort(),
                 .params = Exprs(params.begin(), end),
                 .rows = term.rows(),
                 .cols = term.cols(),
                 .variables = params,
                 .body = term});
  const Expr left = fun(name, params);
  return Theorem({}, predicate ? iff(left, term) : eq(left, term), {"define", {}, {left, term}});
}

// DEFINE RECURSIVE. Functions f_i of the parameters and an integer n. They exist by recursion on
// n >= 0, all at once; for n < 0 they are some numbers of which nothing is said.
namespace {
void check_recursion(const std::vector<std::string>& names, const Exprs& params, Expr n,
                     const Exprs& previous, const Exprs& start, const Exprs& next) {
  if (names.empty()) refuse("a recursion without a name");
  if (names.size() != previous.size() || names.size() != start.size() ||
      names.size() != next.size())
    refuse("a start and a step for each name");
  const Exprs everything = with(with(params, {n}), previous);
  sorts_of(everything);
  if (n.sort() != Sort::Int) refuse("recursion is over an integer variable");
  for (Expr v : previous)
    if (v.sort() != Sort::Real) refuse("recursion makes real sequences");
  for (const auto& [terms, on] : {std::pair(start, params), {next, everything}})
    for (Expr e : terms) {
      if (!is_term(e)) refuse("a start and a step must be terms");
      check_depends_on(on, e);
    }
  if (std::set<std::string>(names.begin(), names.end()).size() != names.size())
    refuse("one name for two sequences");
}
}  // namespace
Theorems define_recursive(const std::vector<std::string>& names, const Exprs& params, Expr n,
                          const Exprs& previous, const Exprs& start, const Exprs& next) {
  check_recursion(names, params, n, previous, start, next);
  const std::vector<Sort> sorts = sorts_of(with(params, {n}));
  for (const std::string& name : names) declare(name, {sorts, Sort::Real, params});
  const auto value = [&](std::size_t i, Expr index) {
    return fun(names[i], with(params, {index}));
  };
  Substitution now;
  Exprs record{n};
  for (std::size_t i = 0; i < names.size(); ++i) {
    now.emplace(previous[i], value(i, n));
    record = with(record, {value(i, n), previous[i], start[i], next[i]});
  }
  Theorems out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out.push_back(Theorem({}, eq(value(i, 0), start[i]), {"start", {}, record}));
  for (std::size_t i = 0; i < names.size(); ++i)
    out.push_back(Theorem({}, imp(le(0, n), eq(value(i, n + 1), substitute(next[i], now))),
                          {"next", {}, record}));
  return out;
}

// MATRIX POWER. For n >= 0 what a power is; for n < 0 nothing is known.
Theorem matrix_power(Expr a, Expr n) {
  if (!is_matrix(a)) refuse("a matrix is needed, not " + brief(a));
  const Expr later = power(a, n + 1);
  Exprs unit;
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j) unit.push_back(i == j ? 1 : 0);
  return Theorem({},
                 logic_and({eq(power(a, Expr(0)), matrix(a.cols(), unit)),
                            imp(le(0, n), eq(later, times(a, power(a, n))))}),
                 {"matrix power", {}, {a, n}});
}

// DEFINE LEAST. name(params) is the least integer n >= lo with f, if there is one, else lo. A set
// of integers that is bounded below has a least one; so the theorem holds for every integer n.
Theorem define_least(const std::string& name, const Exprs& params, Expr n, Expr lo, Expr f) {
  const std::vector<Sort> sorts = sorts_of(params);
  sorts_of(with(params, {n}));
  if (n.sort() != Sort::Int || lo.sort() != Sort::Int || !is_term(lo) || !is_formula(f))
    refuse("the least integer from an integer on, with a property");
  check_depends_on(params, lo);
  check_depends_on(with(params, {n}), f);
  declare(name, {sorts, Sort::Int, params});
  const Expr least = fun(name, params);
  return Theorem({},
                 imp(logic_and({le(lo, n), f}),
                     logic_and({le(lo, least), substitute(f, {{n, least}}), le(least, n)})),
                 {"least", {}, {least, lo, n, f}});
}

// The conditions under which a formula makes sense.
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
    const auto it = domains().find(e.name());
    if (s.body && (it == domains().end() || s.result == Sort::Bool))
      collect(substitute(s.body, s.variables, e.args()), guards);
    if (it == domains().end()) return;
    need(substitute(it->second.condition, it->second.params, e.args()), guards);
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
  if (sorts_of(params) != s->args)
    refuse(name + " has parameters of another number or other sorts");
  if (!is_formula(condition)) refuse("the domain of " + name + " must be a formula");
  check_depends_on(params, condition);
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
