// Attacks on arithmetic: certificates that do not certify.
#include "attack.hpp"

using namespace kernel;

namespace {
const Theorem not_0 = assume(neq(x, 0)), at_least_0 = assume(le(0, x));
const Theorem y_at_least_0 = assume(le(0, y)), xy = assume(eq(x * y, 0));
const Expr loose = all(x, eq(x, 0)).arg(0).arg(0);

void refuses(const std::string& name, const std::string& because, Expr goal,
             const Certificate& certificate) {
  refused(name, because, [&] { arithmetic(goal, certificate); });
}
void proves(std::size_t hypotheses, Expr goal, const Certificate& certificate) {
  const Theorem t = arithmetic(goal, certificate);
  CHECK(t.conclusion() == goal);
  CHECK(t.hypotheses().size() == hypotheses);
}
}  // namespace

TEST_CASE("no certificate proves what is false") {
  for (Expr goal : {eq(0, 1), eq(x / x, 1), eq(power(sqrt(x), 2), x), eq(sqrt(power(x, 2)), x),
                    eq(sin(atan(x)), x), eq(fun("inv", {0}), 0), eq(Expr(1) / (x - x), 0),
                    eq(fun("inv", {2 * x}), Expr(1) / 2 / x), eq(power(x, 2), power(x, 3)),
                    eq(x * y, x), eq(2 * x, x)})
    refuses(text(goal), "does not add up", goal, {});
  refuses("0 < 0", "no product is proved positive", lt(0, 0), {});
  refuses("x/x = 1, 0 <= x", "divisor must be", eq(x / x, 1), {.nonzero = {at_least_0}});
  refuses("y/y = 1, x != 0", "does not add up", eq(y / y, 1), {.nonzero = {not_0}});
  refuses("x/x = 1, x = 0", "divisor must be", eq(x / x, 1), {.nonzero = {nought}});
  refuses("x/x = 1, not 0 < x", "divisor must be", eq(x / x, 1),
          {.nonzero = {assume(logic_not(lt(0, x)))}});
  refuses("x/x^2 = 1, x != 0", "does not add up", eq(x / power(x, 2), 1), {.nonzero = {not_0}});
  refuses("y = 0, x*y = 0", "does not add up", eq(y, 0), {.equations = {{1, xy}}});
  refuses("y = 0, x*y = 0, 0 <= x", "multiplier must be", eq(y, 0),
          {.equations = {{1, xy}}, .multipliers = {at_least_0}});
  refuses("y < 0, x*y < 0, x != 0", "multiplier must be", lt(y, 0),
          {.products = {{1, {assume(lt(x * y, 0))}}}, .multipliers = {not_0}});
  refuses("y = 1, x*y = 0, 0 < x", "does not add up", eq(y, 1),
          {.equations = {{-1, xy}}, .multipliers = {positive}});
  refuses("0 < x, 0 <= x", "no product", lt(0, x), {.products = {{1, {at_least_0}}}});
  refuses("0 < x*y, 0 < x, 0 <= y", "no product", lt(0, x * y),
          {.products = {{1, {positive, y_at_least_0}}}});
  refuses("0 < x^2", "no product", lt(0, power(x, 2)), {.products = {{1, {}, {x}}}});
  refuses("0 < 0*x", "no product", lt(0, 0), {.products = {{0, {positive}}}});
  refuses("x <= 0, 0 < x", "must be >= 0", le(x, 0), {.products = {{-1, {positive}}}});
  refuses("x = 0, 0 <= x", "equations only", eq(0, x), {.products = {{1, {at_least_0}}}});
  refuses("x <= 0, x = 0 as a factor", "an inequality", le(x, 0), {.products = {{1, {nought}}}});
  refuses("x <= 0, 0 < x as an equation", "an equation", le(x, 0), {.equations = {{-1, positive}}});
  refuses("x = 0, x != 0", "an equation", eq(x, 0), {.equations = {{1, not_0}}});
  refuses("x != 0 by arithmetic", "proves =, < and <=", neq(x, 0), {});
  refuses("a disjunction", "proves =, < and <=", logic_or({lt(0, 1), lt(1, 0)}), {});
  refuses("a loose cofactor", "must be a term", eq(0, 0), {.equations = {{loose, nought}}});
  refuses("a formula as cofactor", "must be a term", eq(0, 0), {.equations = {{eq(x, 0), nought}}});
  refuses("a loose square", "only a term", le(0, 0), {.products = {{1, {}, {loose}}}});
}

TEST_CASE("what a certificate does prove, under all its hypotheses") {
  proves(0, eq(power(x + y, 2), power(x, 2) + 2 * x * y + power(y, 2)), {});
  proves(1, eq(x / x, 1), {.nonzero = {not_0}});
  proves(1, eq(x / x, 1), {.nonzero = {positive}});
  proves(1, eq(power(x, 2) / power(x, 3), 1 / x), {.nonzero = {not_0}});
  proves(2, eq(fun("inv", {2 * x}), Expr(1) / 2 / x), {.nonzero = {not_0, assume(neq(2 * x, 0))}});
  proves(3, eq(1 / (1 + 1 / x), x / (x + 1)),
         {.nonzero = {not_0, assume(neq(1 + 1 / x, 0)), assume(neq(x + 1, 0))}});
  proves(1, eq(Expr(1) / (x - y), -(Expr(1) / (y - x))), {.nonzero = {assume(neq(x, y))}});
  proves(2, eq(y, 0), {.equations = {{-1, xy}}, .multipliers = {not_0}});
  proves(2, lt(y, 0), {.products = {{1, {assume(lt(x * y, 0))}}}, .multipliers = {positive}});
  proves(1, eq(y, y), {.multipliers = {not_0}});
  proves(1, lt(0, x + x), {.products = {{1, {positive}}, {1, {positive}}}});
  proves(1, lt(0, x * x), {.products = {{1, {positive, positive}}}});
  proves(2, lt(0, x + y), {.products = {{1, {positive}}, {1, {y_at_least_0}}}});
  proves(0, le(0, power(x, 2) + 2 * x * y + power(y, 2)), {.products = {{1, {}, {x + y}}}});
  proves(1, le(0, x), {.equations = {{-1, nought}}});
  proves(0, lt(0, 1), {.products = {{1}}});
}
