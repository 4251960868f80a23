// Random terms and formulas against a model in exact rationals: sin is any function, 1/0 is 7.
#include <random>

#include "attack.hpp"
#include "kernel/polynomial.hpp"

using namespace kernel;

namespace {
using Values = std::map<Expr, cln::cl_RA>;

class Model {
public:
  explicit Model(unsigned seed) : random(seed) {}
  int below(int k) { return int(random() % unsigned(k)); }
  cln::cl_RA number() { return cln::cl_RA(below(9) - 4) / (1 + below(3)); }
  Expr term(int depth) {
    const int kind = below(depth > 0 ? 9 : 4);
    if (kind < 3) return Exprs{x, y, n}[std::size_t(kind)];
    if (kind == 3) return Expr(number());
    const Expr a = term(depth - 1);
    if (kind == 4) return power(a, 1 + below(3));
    if (kind == 5) return fun(below(2) ? "inv" : "sin", {a});
    return kind == 6 ? a * term(depth - 1) : kind == 7 ? a + term(depth - 1) : a - term(depth - 1);
  }
  Expr formula(int depth) {
    const int kind = below(depth > 0 ? 8 : 3);
    if (kind == 0) return eq(term(1), term(1));
    if (kind == 1) return lt(term(1), term(1));
    if (kind == 2) return le(x, y);
    const Expr f = formula(depth - 1);
    if (kind == 3) return logic_not(f);
    const Expr g = formula(depth - 1);
    return kind == 4   ? logic_and({f, g})
           : kind == 5 ? logic_or({f, g})
           : kind == 6 ? imp(f, g)
                       : iff(f, g);
  }
  Values point() { return {{x, number()}, {y, number()}, {n, cln::cl_RA(below(5) - 2)}}; }

private:
  std::mt19937 random;
};
cln::cl_RA value(Expr e, const Values& at) {
  const Op op = e.op();
  if (op == Op::Num) return e.value();
  if (op == Op::Var) return at.at(e);
  if (op == Op::Pow) return cln::expt(value(e.arg(0), at), e.exponent());
  if (op == Op::Fun) {
    const cln::cl_RA a = value(e.arg(0), at);
    if (e.name() != "inv") return a * a * a - 5;
    return a == 0 ? cln::cl_RA(7) : 1 / a;
  }
  cln::cl_RA out = op == Op::Mul ? 1 : 0;
  for (Expr a : e.args()) out = op == Op::Mul ? out * value(a, at) : out + value(a, at);
  return out;
}
bool truth(Expr f, const Values& at) {
  const auto part = [&](std::size_t i) { return truth(f.arg(i), at); };
  const auto side = [&](std::size_t i) { return value(f.arg(i), at); };
  if (f.op() == Op::Eq) return side(0) == side(1);
  if (f.op() == Op::Lt) return side(0) < side(1);
  if (f.op() == Op::Le) return side(0) <= side(1);
  if (f.op() == Op::Not) return !part(0);
  if (f.op() == Op::And) return part(0) && part(1);
  if (f.op() == Op::Or) return part(0) || part(1);
  if (f.op() == Op::Imp) return !part(0) || part(1);
  return part(0) == part(1);
}
}  // namespace

TEST_CASE("a canonical form has the same value, a substitution the value at the terms") {
  Model model(1);
  for (int round = 0; round < 4000; ++round) {
    const Expr e = model.term(1 + round % 4), t = model.term(2);
    const Values at = model.point();
    INFO(text(e));
    CHECK(value(canonical(e), at) == value(e, at));
    CHECK(value(canonical(-e), at) == -value(e, at));
    Values moved = at;
    moved[x] = value(t, at);
    CHECK(value(substitute(e, {{x, t}}), at) == value(e, moved));
    CHECK(value(replace(e, x, t), at) == value(e, moved));
    CHECK(canonical(canonical(e)) == canonical(e));
  }
}

TEST_CASE("what is taken for a tautology holds in the model") {
  Model model(2);
  int accepted = 0;
  for (int round = 0; round < 6000; ++round) {
    const Expr premise = model.formula(2);
    const Expr goal = round % 3 == 0 ? logic_or({model.formula(1), premise}) : model.formula(2);
    try {
      tautology(goal, {assume(premise)});
    } catch (const Refused&) {
      continue;
    }
    ++accepted;
    for (int k = 0; k < 10; ++k) {
      const Values at = model.point();
      INFO(text(premise) << " |- " << text(goal));
      CHECK((!truth(premise, at) || truth(goal, at)));
    }
  }
  CHECK(accepted > 1000);
}
