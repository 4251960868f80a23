// SPDX-License-Identifier: GPL-2.0-or-later
// Matrices as terms: entries, shapes, powers, determinants.
#include "attack.hpp"
#include "kernel/polynomial.hpp"

using namespace kernel;

namespace {
const Expr a = matrix(2, {1, x, y, 2}), b = matrix(2, {3, 4, 5, x});
const Expr wide = matrix(3, {1, 2, 3, 4, 5, 6});
const Theorem turn = define("turn", {x}, matrix(2, {cos(x), -sin(x), sin(x), cos(x)}), 0);
Expr turned(Expr by) { return fun("turn", {by}); }
}  // namespace

TEST_CASE("an entry of a product is a sum, of a transpose the mirrored entry") {
  CHECK(entry(times(a, b), 0, 1) == 1 * Expr(4) + x * x);
  CHECK(entry(transpose(a), 0, 1) == y);
  CHECK(entry(transpose(times(a, b)), 1, 0) == entry(times(a, b), 0, 1));
  CHECK(entry(turned(x), 0, 1).op() == Op::Entry);
  CHECK(entry(power(a, n), 1, 1).op() == Op::Entry);
  CHECK(substitute(entry(power(a, n), 1, 1), {{x, y}}) ==
        entry(power(matrix(2, {1, y, y, 2}), n), 1, 1));
  CHECK(canonical(entry(power(a, n), 0, 0)) == canonical(entry(power(a, n + 0), 0, 0)));
  CHECK_FALSE(canonical(entry(power(a, n), 0, 0)) == canonical(entry(power(a, n + 1), 0, 0)));
  CHECK_FALSE(entry(power(a, n), 0, 0) == entry(power(a, n), 0, 1));
  CHECK_FALSE(matrix(1, {x, y}) == matrix(2, {x, y}));
  CHECK(times(wide, transpose(wide)).rows() == 2);
  CHECK(transpose(wide).cols() == 2);
}

TEST_CASE("matrices are equal entry by entry") {
  const Theorem same = assume(eq(turned(x), a));
  const Exprs entries{eq(entry(turned(x), 0, 0), 1), eq(entry(turned(x), 0, 1), x),
                      eq(entry(turned(x), 1, 0), y), eq(entry(turned(x), 1, 1), 2)};
  CHECK(restate(logic_and(entries), same).hypotheses().size() == 1);
  CHECK(tautology(entries[2], {same}).hypotheses().size() == 1);
  const Expr product = matrix(2, {3 + 5 * x, 4 + x * x, 3 * y + 10, 4 * y + 2 * x});
  CHECK(canonical(eq(times(a, b), turned(x))) == canonical(eq(product, turned(x))));
  CHECK_FALSE(canonical(eq(times(b, a), turned(x))) == canonical(eq(product, turned(x))));
  does_not_follow("from one entry", eq(turned(x), a), {assume(entries[0])});
}

TEST_CASE("determinants, powers and their shapes") {
  CHECK(canonical(det(a)) == canonical(2 - x * y));
  CHECK(canonical(det(matrix(3, {2, 0, 0, 1, x, y, 5, y, x}))) ==
        canonical(2 * (power(x, 2) - power(y, 2))));
  CHECK(canonical(det(times(a, b))) == canonical(det(a) * det(b)));
  const Theorem powers = matrix_power(turned(x), n);
  CHECK(text(powers) ==
        "|- turn(x)^0 = [1, 0; 0, 1] and (0 <= n implies turn(x)^(n + 1) = turn(x) turn(x)^n)");
  CHECK(rewrite(turn, powers).conclusion().arg(0) ==
        eq(power(turn.conclusion().arg(1), Expr(0)), matrix(2, {1, 0, 0, 1})));
}

TEST_CASE("matrices stand only where they fit") {
  const auto by = [](const Certificate& c) { return [=] { arithmetic(eq(0, 0), c); }; };
  refused("a product that does not fit", "do not fit", [] { times(a, transpose(wide)); });
  refused("equal shapes only", "two shapes", [] { eq(a, wide); });
  refused("equal shapes only, turned", "two shapes", [] { eq(wide, transpose(wide)); });
  refused("a matrix and a number", "where a", [] { eq(a, 1); });
  refused("a number and a matrix", "where a", [] { eq(1, a); });
  refused("a matrix put in", "a number is needed", [] { instantiate(turn, {{x, a}}); });
  refused("a matrix for every x", "a number is needed", [] { specialize(generalize(x, zero), a); });
  refused("a sum", "a number is needed", [] { sum({a, a}); });
  refused("a sum of one", "a number is needed", [] { sum({a}); });
  refused("a sign", "a number is needed", [] { -a; });
  refused("a square", "a number is needed", [] { power(a, 2); });
  refused("an order", "a number is needed", [] { lt(a, b); });
  refused("an argument", "a number is needed", [] { sin(a); });
  refused("an entry", "a number is needed", [] { matrix(1, {a}); });
  refused("a formula as an entry", "a number is needed", [] { matrix(1, {eq(x, 1)}); });
  refused("rows that are not whole", "whole rows", [] { matrix(2, {1, 2, 3}); });
  refused("no entries", "with 0 arguments", [] { matrix(2, {}); });
  refused("no columns", "whole rows", [] { matrix(0, {1}); });
  refused("a power of 6 entries", "square", [] { power(wide, n); });
  refused("a determinant of 6 entries", "square", [] { det(wide); });
  refused("a real power", "needs an integer", [] { power(a, x); });
  refused("no such row", "no such entry", [] { entry(a, 2, 0); });
  refused("no such column", "no such entry", [] { entry(a, 0, -1); });
  refused("an entry of a number", "a matrix is needed", [] { entry(x, 0, 0); });
  refused("an entry of a sum", "that entry() computes", made({.op = Op::Entry, .args = {a}}));
  refused("fifth entry", "no such entry", made({.op = Op::Entry, .args = {turned(x)}, .index = 4}));
  refused("9 rows", "more than 8", [] { matrix(1, Exprs(9, x)); });
  refused("9 by a product", "more than 8", [] { times(matrix(1, Exprs(9, x)), matrix(1, {1})); });
  refused("det of 7 rows", "more than 6 rows", [] { polynomial(det(matrix(7, Exprs(49, x)))); });
  refused("arithmetic of matrices", "not a polynomial", [] { arithmetic(eq(a, a), {}); });
  const Theorem named = assume(eq(turned(x), turned(y)));
  refused("arithmetic of names", "not a polynomial", by({.equations = {{1, named}}}));
  refused("a cofactor of matrices", "must be a term", by({.equations = {{a, zero}}}));
  refused("an equation of matrices", "not a polynomial", by({.equations = {{1, turn}}}));
  refused("matrices as a divisor", "not a polynomial", by({.nonzero = {assume(neq(a, b))}}));

  refused("a start that is a matrix", "must be terms", recursive({}, n, {x}, {a}, {x}));
  refused("powers of a number", "a matrix is needed", [] { matrix_power(x, n); });
  CHECK(matrix(8, Exprs(8, x)).cols() == 8);
  CHECK(polynomial(det(matrix(6, Exprs(36, x)))).empty());
}
