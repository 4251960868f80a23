// Chebyshev's polynomials of the second kind, U_j: sines of cosines, never falling from 1 on.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
Expr U_x(Expr i) { return U(i, x); }
Expr last(Expr i) { return fun("U_last", {x, i}); }
}  // namespace

void chebyshev(Book& book) {
  book.chapter("chebyshev", "Chebyshev's polynomials", {j_from_0});
  const Theorems def =
      defined_by_recursion({"U", "U_last"}, {x}, j, {j_from_0}, {1, 0}, [](const Exprs& before) {
        return Exprs{2 * x * before[0] - before[1], before[0]};
      });
  const Theorem after = at(def[2]), last_after = at(def[3]);
  const Theorem first = restate(eq(U_x(0), 1), def[0]);
  const Theorem second =
      equation(U_x(1), 2 * x, {canonical_form(at(def[2], {{j, 0}})), def[0], def[1]});
  book.show("start", "The polynomials U_j are", under({j_from_0}, both({first, second})));
  const Theorem next = book.show(
      "next", "and on by the rule",
      equation(U_x(j + 2), 2 * x * U_x(j + 1) - U_x(j), {at(def[2], {{j, j + 1}}), last_after}));
  book.show(
      "two_steps", "so that each second one follows from the two such before,",
      equation(U_x(j + 4), (4 * power(x, 2) - 2) * U_x(j + 2) - U_x(j),
               {at(next, {{j, j + 2}}), at(next, {{j, j + 1}}), solved_for(U_x(j + 1) * x, next)}));

  const auto at_cosine = [](const Theorem& t) { return at(t, {{x, cos(y)}}); };
  const Theorem sines = by_induction(
      j,
      logic_and({eq(U(j, cos(y)) * sin(y), sin((j + 1) * y)),
                 eq(fun("U_last", {cos(y), j}) * sin(y), sin(j * y))}),
      {at_cosine(first), at_cosine(def[1])}, {at_cosine(after), at_cosine(last_after)}, {j * y, y});
  book.show("sine", "Of a cosine they are quotients of sines,", part(sines, 0));
  book.show("sine_last", "and so is the one before, U_last, which is 0 at first,", part(sines, 1));
  const auto large = [](Expr i) {
    return logic_and({le(i + 1, U_x(i)), le(last(i) + 1, U_x(i)), le(i, last(i))});
  };
  const auto steps = [&](const Theorem& now) {
    return Theorems{now, after, last_after, times(assume(le(1, x)), linear(lt(0, U_x(j)), {now}))};
  };
  const Theorem rises =
      by_induction(j, large(j), linear(large(0), {first, def[1]}),
                   [&](const Theorem& now) { return linear(large(j + 1), steps(now)); });
  book.show("rise", "and from 1 on they rise with j by 1 or more,",
            linear(logic_and({le(j + 1, U_x(j)), le(U_x(j) + 1, U_x(j + 1)), le(j, last(j))}),
                   steps(rises)));
  const Theorem kept =
      by_induction(j, eq(power(U_x(j), 2), 1 - power(last(j), 2) + 2 * x * U_x(j) * last(j)),
                   {first, def[1]}, {after, last_after});
  book.show("last", "With U_last for the one before, 0 at first,",
            under({j_from_0}, both({def[1], last_after, after})));
  book.show("neighbours", "three neighbours keep, whatever x is,",
            equation(power(U_x(j), 2) - U_x(j + 1) * last(j), 1, {after, kept}));
  const Theorem doubled =
      by_induction(j,
                   logic_and({eq(U_x(2 * j), power(U_x(j), 2) - power(last(j), 2)),
                              eq(U_x(2 * j + 1), 2 * x * power(U_x(j), 2) - 2 * U_x(j) * last(j))}),
                   {first, second, def[1]},
                   {after, last_after, at(next, {{j, 2 * j}}), at(next, {{j, 2 * j + 1}})});
  book.show("double", "those of even j are differences of squares,", part(doubled, 0));
  know(assume(lt(0, y)));
  const Theorem root = equation(power(y, 2), 2 * x * y - 1, {assume(eq(x, (y + 1 / y) / 2))});
  const auto pow = [](Expr i) { return fun("pow", {y, i}); };
  const Theorems powers = parts({book["multiples.pow"]});
  const Theorem before =
      by_induction(j, eq(last(j), y * U_x(j) - pow(j + 1)),
                   {first, def[1], canonical_form(at(powers[1], {{j, 0}})), powers[0]},
                   {after, last_after, root, at(powers[1], {{j, j + 1}})});
  book.show(
      "distance",
      "and where x is the mean of y and 1/y, quotients of neighbours differ from y by its powers:",
      linear(eq(y * U_x(j) - last(j), pow(j + 1)), {before}));
  const Theorem scaled =
      by_induction(j, eq(pow(j) * U_x(j), 1 + y * pow(j) * last(j)), {first, def[1], powers[0]},
                   {after, last_after, root, at(powers[1])});
  const Theorem apart =
      equation(pow(j) * U_x(j) - pow(j) * last(j) / y, power(pow(j), 2), {before, at(powers[1])});
  book.show("unit", "In these powers as the unit they stay near 1:",
            both({scaled, linear(eq((1 / y - y) * pow(j) * last(j), 1 - power(pow(j), 2)),
                                 {scaled, apart})}));
  book.show("steps", "At 1 they are",
            by_induction(j, logic_and({eq(U(j, 1), j + 1), eq(fun("U_last", {Expr(1), j}), j)}),
                         {at(first, {{x, 1}}), at(def[1], {{x, 1}})},
                         {at(after, {{x, 1}}), at(last_after, {{x, 1}})}));
}
}  // namespace derivation
