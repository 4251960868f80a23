// SPDX-License-Identifier: GPL-2.0-or-later
// Chebyshev's polynomials of the second kind, U_j: sines where their argument is a cosine, never
// falling where it is 1 or more.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
const Expr from_0 = le(0, j);
Expr U(Expr i, Expr at = x) { return chebyshev(i, at); }
Expr last(Expr i) { return fun("U_last", {x, i}); }
}  // namespace

void chebyshev(Book& book) {
  book.chapter("chebyshev", "Chebyshev's polynomials", {from_0});
  const Theorem from = assume(from_0), zero = linear(le(0, 0));
  const Theorems def =
      defined_by_recursion({"U", "U_last"}, {x}, j, {from_0}, {1, 0}, [](const Exprs& before) {
        return Exprs{2 * x * before[0] - before[1], before[0]};
      });
  const Theorem first = restate(eq(U(0), 1), def[0]);
  const Theorem second = equation(
      U(1), 2 * x,
      {restate(eq(U(1), 2 * x * U(0) - last(0)), use(def[2], {{j, 0}}, {zero})), def[0], def[1]});
  book.show("start", "The polynomials U_j are", under({from_0}, both({first, second})));
  const Theorem next =
      book.show("next", "and on by the rule",
                equation(U(j + 2), 2 * x * U(j + 1) - U(j),
                         {use(def[2], {{j, j + 1}}, {from}), use(def[3], {}, {from})}));

  const auto sine = [](Expr i) { return eq(U(i, cos(y)) * sin(y), sin((i + 1) * y)); };
  const auto at_cosine = [](const Theorem& t) { return instantiate(t, {{x, cos(y)}}); };
  book.show(
      "sine", "Of a cosine they are quotients of sines,",
      by_two(sine, equation(U(0, cos(y)) * sin(y), sin((Expr(0) + 1) * y), {at_cosine(first)}),
             equation(U(1, cos(y)) * sin(y), sin((Expr(1) + 1) * y), {at_cosine(second)}, {y}),
             [&](const Theorem&, const Theorem& now, const Theorem& later) {
               return equation(U(j + 2, cos(y)) * sin(y), sin((j + 2 + 1) * y),
                               {at_cosine(next), now, later}, {j * y, y});
             }));

  const auto sine_last = [](Expr i) { return eq(fun("U_last", {cos(y), i}) * sin(y), sin(i * y)); };
  book.show(
      "sine_last", "and so is the one before, U_last, which is 0 at first,",
      by_induction(j, sine_last(j), equation(sine_last(0), {at_cosine(def[1]), axiom("sin 0")}),
                   [&](const Theorem& i_from_0, const Theorem&) {
                     return equation(sine_last(j + 1), {at_cosine(use(def[3], {}, {i_from_0})),
                                                        book["chebyshev.sine"]});
                   }));
  const Theorem above_1 = assume(le(1, x));
  const Expr rises = logic_and({le(j + 1, U(j)), le(U(j) + 1, U(j + 1))});
  book.show(
      "rise", "and from 1 on they rise with j by 1 or more,",
      by_induction(j, rises,
                   both({linear(le(Expr(0) + 1, U(0)), {first}),
                         restate(le(U(0) + 1, U(Expr(0) + Expr(1))),
                                 linear(le(U(0) + 1, U(1)), {first, second, above_1}))}),
                   [&](const Theorem& i_from_0, const Theorem& known) {
                     const Theorem more = linear(le(j + 1 + 1, U(j + 1)), {known});
                     const Theorem up = linear(
                         le(U(j + 1) + 1, U(j + 2)),
                         {next, known, times(above_1, linear(lt(0, U(j + 1)), {more, i_from_0}))});
                     return both({more, restate(le(U(j + 1) + 1, U(j + 1 + 1)), up)});
                   }));
  const Theorem after = use(def[2], {}, {from}), last_after = use(def[3], {}, {from});
  const auto invariant = [&](Expr i) {
    return eq(power(U(i), 2), 1 - power(last(i), 2) + 2 * x * U(i) * last(i));
  };
  const Theorem kept = by_induction(j, invariant(j), equation(invariant(0), {first, def[1]}),
                                    [&](const Theorem&, const Theorem& known) {
                                      return equation(invariant(j + 1), {after, last_after, known});
                                    });
  book.show("last", "With U_last for the one before, 0 at first,",
            under({from_0}, both({def[1], last_after})));
  book.show("neighbours", "three neighbours keep, whatever x is,",
            equation(power(U(j), 2) - U(j + 1) * last(j), 1, {after, kept}));
  const Theorem above_0 = assume(lt(0, y)), mean = assume(eq(x, (y + 1 / y) / 2));
  const Known y_is_positive({above_0});
  const Theorem root = equation(power(y, 2), 2 * x * y - 1, {mean});
  const auto pow = [](Expr i) { return fun("pow", {y, i}); };
  const Theorems powers = parts({book["multiples.pow"]});
  const auto more = [&](Expr i, const Theorem& i_from_0) {
    return restate(eq(pow(i + 1), y * pow(i)), use(powers[1], {{j, i}}, {i_from_0}));
  };
  const auto distance = [&](Expr i) { return eq(y * U(i) - last(i), pow(i + 1)); };
  const Theorem one = restate(eq(pow(1), y * pow(0)), more(0, zero));
  book.show(
      "distance",
      "and where x is the mean of y and 1/y, quotients of neighbours differ from y by its powers:",
      by_induction(j, distance(j),
                   restate(distance(0),
                           equation(y * U(0) - last(0), pow(1), {first, def[1], one, powers[0]})),
                   [&](const Theorem& i_from_0, const Theorem& known) {
                     return restate(
                         distance(j + 1),
                         equation(y * U(j + 1) - last(j + 1), pow(j + 2),
                                  {after, last_after, root, more(j + 1, i_from_0), turned(known)}));
                   }));
}
}  // namespace derivation
