// SPDX-License-Identifier: GPL-2.0-or-later
#include "examples.hpp"

using namespace kernel;

namespace examples {
namespace {
const Expr x = real("x"), y = real("y"), z = real("z"), n = integer("n"), m = integer("m");

coq::Chapter logic() {
  const Theorem equation = assume(eq(x, y + z));
  const Theorem whole = assume(all(n, lt(power(x + 1, 2), n)));
  const Expr other = all(n, lt(1 + 2 * x + x * x, Expr(0) + n));
  const Theorem ordered = assume(logic_or({le(y + x, z), lt(x, y)}));
  return {"logic",
          {{"discharge", discharge(lt(x, y), assume(lt(x, y)))},
           {"instance", instantiate(equation, {{x, x * y}, {z, Expr(n)}})},
           {"generalized", generalize(n, discharge(lt(0, n), assume(lt(0, n))))},
           {"specialized", specialize(whole, 2 * n + power(m, 2))},
           {"restated", restate(other, whole)},
           {"rewritten", rewrite(equation, assume(lt(sin(x) + y, x)))},
           {"order", tautology(logic_or({logic_not(lt(z, x + y)), lt(x, y)}), {ordered})},
           {"lost", tautology(lt(x, y), {assume(lt(x, y)), axiom("discrete")})},
           {"classical", tautology(logic_or({lt(x, y), logic_not(lt(x, y))}), {})},
           {"not less", tautology(le(y, x), {assume(logic_not(lt(x, y)))})},
           {"if and only if", tautology(iff(eq(x, y), eq(x, y + 0)), {})}}};
}
coq::Chapter certificates() {
  const Theorem equation = assume(eq(x, 2 * y));
  const Theorem positive = assume(lt(0, x + y));
  const Theorem other = assume(neq(z, 0));
  const Theorem at_least = assume(le(y, z / 2));
  Certificate substituted;
  substituted.equations = {{x + 2 * y, equation}};
  Certificate divided;
  divided.nonzero = {positive, other};
  Certificate multiplied;
  multiplied.multipliers = {positive};
  multiplied.products = {{cln::cl_RA(1) / 3, {positive, positive}, {}}, {2, {at_least}, {x}}};
  multiplied.equations = {
      {1, assume(eq(power(x + y, 2) / 3 + 2 * (z / 2 - y) * x * x, (x + y) * (y - sin(x + x))))}};
  Certificate least;
  least.products = {{1, {}, {x - y}}};
  return {"certificates",
          {{"square", arithmetic(eq(x * x, 4 * y * y), substituted)},
           {"inverses", arithmetic(eq(x / (x + y) / z + y / (y + x) / z, 1 / z), divided)},
           {"multiplier", arithmetic(lt(sin(2 * x), y), multiplied)},
           {"root", arithmetic(le(2 * x * y, x * x + y * y), least)},
           {"numbers", arithmetic(eq(Expr(1) / Expr(2) + fun("inv", {1 + Expr(1)}), 1), {})}}};
}
coq::Chapter definitions() {
  const Theorem named = define("double_of", {x}, 2 * x);
  const Theorem even = define("even_of", {n}, 2 * n);
  const Theorem small = define("is_small", {x, y}, lt(power(x, 2), y));
  const Theorem turned = define("turned", {x}, matrix(2, {cos(x), -sin(x), sin(x), cos(x)}));
  const Expr turn = fun("turned", {x});
  const Theorems counted =
      define_recursive({"count_of", "sum_of"}, {y}, n, {x, z}, {0, y}, {x + 1, z * y + n});
  const Theorem least = define_least("first_of", {y}, n, 0, lt(y, n));
  const Theorem powers = matrix_power(turn, n);
  const Expr count = fun("count_of", {y, n});
  const Expr counts = eq(count, n);
  const Theorem from_0 = assume(logic_and({le(0, n), counts}));
  const Theorem next =
      tautology(counted[2].conclusion().arg(1), {counted[2], tautology(le(0, n), {from_0})});
  Certificate step;
  step.equations = {{1, next}, {1, tautology(counts, {from_0})}};
  const Theorem hold =
      discharge(from_0.conclusion(), arithmetic(eq(fun("count_of", {y, n + 1}), n + 1), step));
  const Expr entries = logic_and({eq(entry(turn, 0, 0), cos(x)), eq(entry(turn, 0, 1), -sin(x)),
                                  eq(entry(turn, 1, 0), sin(x)), eq(entry(turn, 1, 1), cos(x))});
  const Expr a = matrix(2, {x, y, z, 1});
  const Theorem same = assume(eq(times(a, power(turn, n)), transpose(a)));
  return {"definitions",
          {{"name", named},
           {"integer", instantiate(least, {{n, fun("even_of", {n})}})},
           {"predicate", instantiate(small, {{y, y + 1}})},
           {"matrix", tautology(entries, {turned})},
           {"entries", restate(eq(times(a, power(turn, n + 0)), matrix(2, {x, z, y, 1})), same)},
           {"start", counted[0]},
           {"next", counted[3]},
           {"least", least},
           {"powers", powers},
           {"even", even},
           {"determinant", arithmetic(eq(det(a), x - y * z), {})},
           {"induction", induction(n, 0, counts, counted[0], hold)}}};
}
}  // namespace

const std::vector<coq::Chapter>& book() {
  static const std::vector<coq::Chapter> all = [] {
    coq::Chapter axioms{"axioms", {}};
    for (const std::string& name : axiom_names()) axioms.shown.emplace_back(name, axiom(name));
    return std::vector<coq::Chapter>{axioms, logic(), certificates(), definitions()};
  }();
  return all;
}
}  // namespace examples
