// Substitution, replacement, binding and opening: one walk that rebuilds a tree bottom-up.
#include <functional>

#include "kernel/expr.hpp"

namespace kernel {
namespace {
using Change = std::function<Expr(Expr, int)>;
using Known = std::map<std::pair<Expr, int>, Expr>;

// `change` may give another tree for a subtree under `depth` binders; each is visited once.
Expr walk(Expr e, const Change& change, int depth, Known& known) {
  const auto [it, fresh] = known.emplace(std::pair(e, depth), Expr());
  if (!fresh) return it->second;
  Expr out = change(e, depth);
  if (!out) {
    Exprs args = e.args();
    for (Expr& a : args) a = walk(a, change, depth + (e.op() == Op::All ? 1 : 0), known);
    out = args == e.args() ? e : with_args(e, args);
  }
  return it->second = out;
}
Expr walk(Expr e, const Change& change) {
  Known known;
  return walk(e, change, 0, known);
}
void check_replacement(Sort sort, const std::string& what, Expr by) {
  if (by.sort() != Sort::Real && by.sort() != Sort::Int)
    refuse("a formula or matrix stands where a number is needed: " + brief(by));
  if (by.loose()) refuse("a term with a loose index");
  if (sort == Sort::Int && by.sort() != Sort::Int)
    refuse(what + " is an integer: " + brief(by) + " cannot be put in");
}
}  // namespace

Expr all(Expr v, Expr f) {
  if (v.op() != Op::Var) refuse("only a variable can be bound, not " + brief(v));
  const Expr body = walk(f, [v](Expr e, int depth) {
    return e == v ? make({.op = Op::Bound, .index = depth, .variable = v.sort()}) : Expr();
  });
  return make({.op = Op::All, .args = {body}, .name = v.name(), .variable = v.sort()});
}
Expr open(Expr q, Expr t) {
  if (q.op() != Op::All) refuse("not a statement for all: " + brief(q));
  if (q.loose()) refuse("a statement with a loose index");
  check_replacement(q.bound_sort(), q.name(), t);
  // q is closed: a bound index that leads out of its body is q's own.
  return walk(q.arg(0), [t](Expr e, int depth) {
    if (e.loose() <= depth) return e;
    return e.op() == Op::Bound ? t : Expr();
  });
}
Expr substitute(Expr e, const Substitution& s) {
  for (const auto& [v, t] : s) {
    if (v.op() != Op::Var) refuse(brief(v) + " is not a variable: nothing can be put in for it");
    check_replacement(v.sort(), v.name(), t);
  }
  return walk(e, [&s](Expr x, int) {
    const auto it = s.find(x);
    return it == s.end() ? Expr() : it->second;
  });
}
Expr substitute(Expr e, const Exprs& variables, const Exprs& terms) {
  if (variables.size() != terms.size()) refuse("not a term for each variable");
  Substitution s;
  for (std::size_t i = 0; i < variables.size(); ++i) s.emplace(variables[i], terms.at(i));
  return substitute(e, s);
}
Expr replace(Expr e, Expr from, Expr to) {
  if (from.loose() || to.loose()) refuse("a term with a loose index");
  if (from.sort() == Sort::Int && to.sort() != Sort::Int)
    refuse("an integer term can be replaced by an integer term only");
  return walk(e, [from, to](Expr x, int) { return x == from ? to : Expr(); });
}
std::set<Expr> free_variables(Expr e) {
  std::set<Expr> out;
  walk(e, [&out](Expr x, int) {
    if (x.op() == Op::Var) out.insert(x);
    return Expr();
  });
  return out;
}
}  // namespace kernel
