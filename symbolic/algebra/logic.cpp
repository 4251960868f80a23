#include <algorithm>

#include "algebra/tactics.hpp"

namespace algebra {
namespace {
AllKnown& all_known() {
  static AllKnown all;
  return all;
}
using Sides = std::set<std::pair<Expr, Expr>>;
/// The sides of each equation of terms in f, or else of each inequality.
void sides_in(Expr f, bool of_equations, Sides& out) {
  const Op op = f.op();
  const bool relation = of_equations ? op == Op::Eq : op == Op::Lt || op == Op::Le;
  if (relation && !is_matrix(f.arg(0)) && out.count({f.arg(1), f.arg(0)}) == 0)
    out.emplace(f.arg(0), f.arg(1));
  if (op == Op::Not || op == Op::And || op == Op::Or || op == Op::Imp || op == Op::Iff)
    for (const Expr& a : f.args()) sides_in(a, of_equations, out);
}
}  // namespace

Exprs conjuncts(Expr f) { return f.op() == Op::And ? f.args() : Exprs{f}; }
bool is_among(Expr f, const Exprs& formulas) {
  return std::find(formulas.begin(), formulas.end(), f) != formulas.end();
}
Known::Known(const Theorems& facts) : before(all_known()) {
  for (const Theorem& t : facts) know(t);
}
Known::~Known() { all_known() = before; }
void know(const Theorem& fact) { all_known().here = all_known().here + parts({fact}); }
void know_for_good(const Theorem& fact) {
  all_known().for_good = all_known().for_good + parts({fact});
}
void suppose(const Exprs& assumptions) { all_known().here = parts(assumed(assumptions)); }
Theorems known() { return all_known().for_good + all_known().here; }
Theorems parts(const Theorems& theorems) {
  Theorems out;
  for (const Theorem& t : theorems) {
    const Expr f = t.conclusion();
    if (f.op() == Op::And)
      for (std::size_t i = 0; i < f.size(); ++i) out = out + parts({part(t, i)});
    else if (f.op() == Op::Eq && is_matrix(f.arg(0)))
      out = out + entries(t);
    else
      out.push_back(t);
  }
  return out;
}
Theorem at(const Theorem& rule, const Substitution& terms, const Theorems& facts) {
  Theorem t = terms.empty() ? rule : instantiate(rule, terms);
  const Theorems given = parts(facts);
  const auto proof = [&](Expr f) {
    const auto it = std::ranges::find_if(given, [&](const auto& g) { return g.conclusion() == f; });
    return it == given.end() ? linear(f, given) : *it;
  };
  for (const Expr& h : t.hypotheses())
    if (!is_among(h, rule.hypotheses()) && is_relation(h)) t = cut(proof(h), t);
  if (t.conclusion().op() != Op::Imp) return t;
  Theorems from = given + Theorems{t};
  for (const Expr& f : conjuncts(left(t)))
    if (is_relation(f)) from.push_back(proof(f));
  return tautology(right(t), from);
}
Theorem at(const std::string& axiom_name, const Substitution& terms, const Theorems& facts) {
  return at(axiom(axiom_name), terms, facts);
}
Theorem given(Expr f, const std::function<Theorem(const Theorem&)>& body) {
  return discharge(f, body(assume(f)));
}
Theorem where_equal(Expr l, Expr r, Expr goal, const Theorem& there) {
  const Expr denied = logic_not(goal);
  return given(eq(l, r), [&](const Theorem& same) {
    return tautology(goal, {discharge(denied, rewrite(same, assume(denied))), there});
  });
}
Theorem equivalent(const Theorem& forth, const Theorem& back) {
  const Expr f = back.conclusion(), g = forth.conclusion();
  return tautology(iff(f, g), {discharge(f, forth), discharge(g, back)});
}
Theorem follows(Expr goal, const Theorems& from) {
  Sides sides;
  for (const bool of_equations : {true, false}) {
    sides_in(goal, of_equations, sides);
    for (const Theorem& t : from) sides_in(t.conclusion(), of_equations, sides);
  }
  Theorems all = from;
  for (const auto& [l, r] : sides) {
    all.push_back(at("equal or less or greater", {{real("x"), l}, {real("y"), r}}));
    const Expr up = le(l, r), down = le(r, l);
    for (const Expr& f :
         {imp(lt(l, r), up), imp(eq(l, r), logic_and({up, down})), imp(lt(r, l), down)})
      all.push_back(linear(f));
  }
  return tautology(goal, all);
}
Theorems assumed(const Exprs& formulas) {
  Theorems out;
  for (const Expr& f : formulas) out.push_back(assume(f));
  return out;
}
Theorem part(const Theorem& conjunction, std::size_t i) {
  return tautology(conjunction.conclusion().arg(i), {conjunction});
}
std::optional<Theorem> by_parts(Expr goal, const std::function<Theorem(Expr)>& prove) {
  if (goal.op() == Op::And) {
    Theorems all;
    for (const Expr& g : goal.args()) all.push_back(prove(g));
    return both(all);
  }
  if (goal.op() != Op::Eq || !is_matrix(goal.arg(0))) return {};
  return restate(goal, prove(logic_and(entry_equations(goal))));
}
Theorem both(const Theorems& theorems) {
  Exprs formulas;
  for (const Theorem& t : theorems) formulas.push_back(t.conclusion());
  return tautology(logic_and(formulas), theorems);
}
Theorem never() {
  static const Theorem result =
      tautology(logic_not(lt(0, 0)),
                {instantiate(axiom("less is not equal"), {{real("x"), 0}, {real("y"), 0}}),
                 arithmetic(eq(0, 0), {})});
  return result;
}
Theorem refute(Expr f, const Theorem& absurd) {
  return tautology(logic_not(f), {discharge(f, absurd), never()});
}
Theorem by_induction(Expr n, Expr f, const Theorem& base,
                     const std::function<Theorem(const Theorem&)>& step) {
  const Expr premise = logic_and({le(0, n), f});
  const Theorem now = assume(premise), from_0 = assume(le(0, n));
  const Known in_step({from_0});
  const Theorem next = discharge(premise, cut(part(now, 0), step(part(now, 1))));
  return tautology(f, {induction(n, 0, f, base, next), from_0});
}
Theorem by_induction(Expr n, Expr f, const Theorems& start, const Theorems& next,
                     const Exprs& bases) {
  return by_induction(n, f, equation(substitute(f, {{n, 0}}), start, bases),
                      [&](const Theorem& now) {
                        return equation(substitute(f, {{n, n + 1}}), next + Theorems{now}, bases);
                      });
}
Theorem otherwise(Expr goal, const Theorems& facts) {
  const Expr l = goal.arg(0), r = goal.arg(1);
  return tautology(goal,
                   {refute(goal.op() == Op::Lt ? le(r, l) : lt(r, l), linear(lt(0, 0), facts))});
}
Theorem under(const Exprs& hypotheses, const Theorem& theorem) {
  const Theorem shown = tautology(theorem.conclusion(), assumed(hypotheses) + Theorems{theorem});
  return shown.hypotheses() == theorem.hypotheses() ? theorem : shown;
}
Theorem cut(const Theorem& proof, const Theorem& theorem) {
  return tautology(theorem.conclusion(), {discharge(proof.conclusion(), theorem), proof});
}
Theorem next_integer(const Theorem& less) {
  const Expr i = left(less), j = right(less);
  return tautology(le(i + 1, j), {at("discrete", {{integer("i"), i}, {integer("j"), j}}), less});
}
}  // namespace algebra
