// SPDX-License-Identifier: GPL-2.0-or-later
// Attacks on arithmetic: certificates that do not certify.
#include "attack.hpp"

using namespace kernel;

namespace {
const Expr x = real("x");
const Expr y = real("y");
const Theorem positive = assume(lt(0, x));
const Theorem nought = assume(eq(x, 0));
const Theorem not_0 = assume(neq(x, 0));
const Theorem at_least_0 = assume(le(0, x));
const Theorem y_at_least_0 = assume(le(0, y));
const Expr loose = all(x, eq(x, 0)).arg(0).arg(0);

struct Claim {
  std::string name;
  std::string because;
  Expr goal;
  Certificate certificate;
};
}  // namespace

TEST_CASE("no certificate proves what is false") {
  for (const Claim& c : std::vector<Claim>{
           {"0 = 1", "does not add up", eq(0, 1), {}},
           {"0 < 0", "no product is proved positive", lt(0, 0), {}},
           {"x/x = 1", "does not add up", eq(x / x, 1), {}},
           {"x/x = 1, 0 <= x", "divisor must be", eq(x / x, 1), {.nonzero = {at_least_0}}},
           {"y/y = 1, x != 0", "does not add up", eq(y / y, 1), {.nonzero = {not_0}}},
           {"x/x = 1, x = 0", "divisor must be", eq(x / x, 1), {.nonzero = {nought}}},
           {"x/x = 1, not 0 < x",
            "divisor must be",
            eq(x / x, 1),
            {.nonzero = {assume(logic_not(lt(0, x)))}}},
           {"x/x^2 = 1, x != 0", "does not add up", eq(x / power(x, 2), 1), {.nonzero = {not_0}}},
           {"y = 0, x*y = 0",
            "does not add up",
            eq(y, 0),
            {.equations = {{1, assume(eq(x * y, 0))}}}},
           {"y = 0, x*y = 0, 0 <= x",
            "multiplier must be",
            eq(y, 0),
            {.equations = {{1, assume(eq(x * y, 0))}}, .multipliers = {at_least_0}}},
           {"y < 0, x*y < 0, x != 0",
            "multiplier must be",
            lt(y, 0),
            {.products = {{1, {assume(lt(x * y, 0))}}}, .multipliers = {not_0}}},
           {"y = 1, x*y = 0, 0 < x",
            "does not add up",
            eq(y, 1),
            {.equations = {{-1, assume(eq(x * y, 0))}}, .multipliers = {positive}}},
           {"0 < x, 0 <= x", "no product", lt(0, x), {.products = {{1, {at_least_0}}}}},
           {"0 < x*y, 0 < x, 0 <= y",
            "no product",
            lt(0, x * y),
            {.products = {{1, {positive, y_at_least_0}}}}},
           {"0 < x^2", "no product", lt(0, power(x, 2)), {.products = {{1, {}, {x}}}}},
           {"0 < 0*x", "no product", lt(0, 0), {.products = {{0, {positive}}}}},
           {"x <= 0, 0 < x", "must be >= 0", le(x, 0), {.products = {{-1, {positive}}}}},
           {"x = 0, 0 <= x", "equations only", eq(0, x), {.products = {{1, {at_least_0}}}}},
           {"x <= 0, x = 0 as a factor", "an inequality", le(x, 0), {.products = {{1, {nought}}}}},
           {"x <= 0, 0 < x as an equation",
            "an equation",
            le(x, 0),
            {.equations = {{-1, positive}}}},
           {"x = 0, x != 0", "an equation", eq(x, 0), {.equations = {{1, not_0}}}},
           {"x != 0 by arithmetic", "proves =, < and <=", neq(x, 0), {}},
           {"a disjunction", "proves =, < and <=", logic_or({lt(0, 1), lt(1, 0)}), {}},
           {"sqrt(x)^2 = x", "does not add up", eq(power(sqrt(x), 2), x), {}},
           {"sqrt(x^2) = x", "does not add up", eq(sqrt(power(x, 2)), x), {}},
           {"sin(atan(x)) = x", "does not add up", eq(sin(atan(x)), x), {}},
           {"1/0 = 0", "does not add up", eq(fun("inv", {0}), 0), {}},
           {"inv(x - x) = 0", "does not add up", eq(Expr(1) / (x - x), 0), {}},
           {"1/(2*x) = 1/2*1/x is unknown",
            "does not add up",
            eq(fun("inv", {2 * x}), Expr(1) / 2 / x),
            {}},
           {"a loose cofactor", "must be a term", eq(0, 0), {.equations = {{loose, nought}}}},
           {"a formula as cofactor",
            "must be a term",
            eq(0, 0),
            {.equations = {{eq(x, 0), nought}}}},
           {"a loose square", "only a term", le(0, 0), {.products = {{1, {}, {loose}}}}},
           {"x^2 = x^3", "does not add up", eq(power(x, 2), power(x, 3)), {}},
           {"x*y = x", "does not add up", eq(x * y, x), {}},
           {"2*x = x", "does not add up", eq(2 * x, x), {}}}) {
    INFO(c.name);
    CHECK_THROWS_WITH(arithmetic(c.goal, c.certificate), ContainsSubstring(c.because));
  }
}

TEST_CASE("what a certificate does prove, under all its hypotheses") {
  const Theorem xy = assume(eq(x * y, 0));
  const Theorem below = assume(lt(x * y, 0));
  struct Proof {
    Expr goal;
    Certificate certificate;
    std::size_t hypotheses;
  };
  for (const Proof& p : std::vector<Proof>{
           {eq(power(x + y, 2), power(x, 2) + 2 * x * y + power(y, 2)), {}, 0},
           {eq(x / x, 1), {.nonzero = {not_0}}, 1},
           {eq(x / x, 1), {.nonzero = {positive}}, 1},
           {eq(power(x, 2) / power(x, 3), 1 / x), {.nonzero = {not_0}}, 1},
           {eq(fun("inv", {2 * x}), Expr(1) / 2 / x),
            {.nonzero = {not_0, assume(neq(2 * x, 0))}},
            2},
           {eq(1 / (1 + 1 / x), x / (x + 1)),
            {.nonzero = {not_0, assume(neq(1 + 1 / x, 0)), assume(neq(x + 1, 0))}},
            3},
           {eq(Expr(1) / (x - y), -(Expr(1) / (y - x))), {.nonzero = {assume(neq(x, y))}}, 1},
           {eq(y, 0), {.equations = {{-1, xy}}, .multipliers = {not_0}}, 2},
           {lt(y, 0), {.products = {{1, {below}}}, .multipliers = {positive}}, 2},
           {eq(y, y), {.multipliers = {not_0}}, 1},
           {lt(0, x + x), {.products = {{1, {positive}}, {1, {positive}}}}, 1},
           {lt(0, x * x), {.products = {{1, {positive, positive}}}}, 1},
           {lt(0, x + y), {.products = {{1, {positive}}, {1, {y_at_least_0}}}}, 2},
           {le(0, power(x, 2) + 2 * x * y + power(y, 2)), {.products = {{1, {}, {x + y}}}}, 0},
           {le(0, x), {.equations = {{-1, nought}}}, 1},
           {lt(0, 1), {.products = {{1}}}, 0}}) {
    const Theorem t = arithmetic(p.goal, p.certificate);
    CHECK(t.conclusion() == p.goal);
    CHECK(t.hypotheses().size() == p.hypotheses);
  }
}
