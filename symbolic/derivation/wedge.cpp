// SPDX-License-Identifier: GPL-2.0-or-later
// Three bodies of any masses with restitution are a ray in a wedge: how fast they approach, how
// often they collide, and that they never stop where the wedge is no angle.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
const Expr from_0 = le(0, j);
const Exprs masses{lt(0, M_A), le(0, w_B), lt(0, M_C), lt(0, e)};
Expr pow(Expr i) { return fun("pow", {sqrt(e), i}); }

/// The roots of the shares of mass, and kappa.
Theorems shares(Book& book) {
  Theorems rules;
  for (const char* name : {"r_A", "r_B"}) {
    const bool is_of_A = name[2] == 'A';
    const Expr share = is_of_A ? M_A / (M_A + M_C) : 1 / (1 + w_B * M_C);
    const Exprs params{is_of_A ? M_A : w_B, M_C};
    const Theorem is = define(name, params, sqrt(share), -1);
    restrict_domain(name, params, logic_and({is_of_A ? lt(0, M_A) : le(0, w_B), lt(0, M_C)}));
    book.show(
        name, "",
        is_of_A ? "With the roots of the shares of mass" : "and, for a block or with 1 for a wall,",
        is);
    const Expr r = is.conclusion().arg(0);
    know(linear(lt(0, r), {is, positive(sqrt(share))}));
    rules.push_back(equation(power(r, 2), share, {is, root_squared(positive(share))}));
  }
  const Theorem is = define("kappa", masses_and_e(), (1 + e) * r_A() * r_B() / (2 * sqrt(e)), -1);
  restrict_domain("kappa", masses_and_e(), logic_and(masses));
  book.show("kappa", "", "the shape of the motion is one number:", is);
  return rules + Theorems{is, root_squared(assume(lt(0, e)))};
}
/// closing_j = V e^(j/2) U_j(kappa), times r_A/r_B for Q.
Theorem speeds(Book& book, const Theorems& rules) {
  const Theorem zero = linear(le(0, 0));
  const Theorems pow_is = parts({instantiate(book["multiples.pow"], {{y, sqrt(e)}})});
  const Theorems turns = parts({book["cycle.turn"]});
  const auto value = [&](Expr i) { return V * pow(i) * side(i) * chebyshev(i, kappa()); };
  const auto claim = [&](Expr i) { return eq(closing(i), value(i)); };
  const auto U = [&](const char* id, Expr i) {
    return at(book[std::string("chebyshev.") + id], {{x, kappa()}, {j, i}}, {zero});
  };
  const Theorems start = parts({U("start", 0)});
  const Theorem first = equation(
      closing(0), value(0), {at(book["motion.first"], {{j, 0}}), turns[0], pow_is[0], start[0]});
  const Theorem second =
      equation(closing(1), value(1),
               Theorems{at(book["motion.second"], {{j, 0}}), start[1], turns[0], pow_is[0],
                        restate(eq(turn(1), -turn(0)), use(turns[1], {{j, 0}}, {zero})),
                        restate(eq(pow(1), sqrt(e) * pow(0)), use(pow_is[1], {{j, 0}}, {zero}))} +
                   rules);
  const auto third = [&](const Theorem& from, const Theorem& now, const Theorem& later) {
    const auto next = [&](const Theorem& t, Expr i) { return use(t, {{j, i}}, {from}); };
    return equation(closing(j + 2), value(j + 2),
                    Theorems{book["motion.recurrence"], now, later, next(turns[1], j + 1),
                             next(turns[1], j), next(pow_is[1], j + 1), next(pow_is[1], j),
                             U("next", j), book["motion.turn_squared"]} +
                        rules);
  };
  return book.show("speed", "", "So collision j has the approach speed",
                   by_two(claim, first, second, third));
}
void signs_of_factors(Book& book) {
  const Theorem zero = linear(le(0, 0));
  const Theorems turns = parts({book["cycle.turn"]});
  const auto turn_next = [&](Expr i, const Theorem& from) {
    return use(turns[1], {{j, i}}, {from});
  };
  const auto above_0 = [](Expr i) { return lt(0, side(i)); };
  const Theorem turn_1 = restate(eq(turn(1), -turn(0)), turn_next(0, zero));
  const Theorem sides = (by_two(
      above_0, linear(lt(0, side(0)), {equation(side(0), 1, {turns[0]})}),
      linear(lt(0, side(1)),
             {equation(side(1), r_A() / r_B(), {turn_1, turns[0]}), positive(r_A() / r_B())}),
      [&](const Theorem& from, const Theorem& now, const Theorem&) {
        return linear(
            above_0(j + 2),
            {now, equation(side(j + 2), side(j), {turn_next(j + 1, from), turn_next(j, from)})});
      }));
  const Theorems pow_is = parts({instantiate(book["multiples.pow"], {{y, sqrt(e)}})});
  const Theorem powers = (by_induction(
      j, lt(0, pow(j)), linear(lt(0, pow(0)), {pow_is[0]}),
      [&](const Theorem& from, const Theorem& now) {
        return linear(lt(0, pow(j + 1)), {use(pow_is[1], {}, {from}), times(now, sqrt(e))});
      }));
  know(sides);
  know(powers);
  book.show("signs", "",
            "Its factors are positive:", both({positive(r_A()), positive(r_B()), sides, powers}));
}
/// Where kappa is the cosine of an angle h_e: pi/h_e collisions, rounded up, less one.
void angle_of_the_wedge(Book& book) {
  const Theorem below_1 = assume(lt(kappa(), 1)),
                above_0 = linear(
                    lt(0, kappa()),
                    {book["wedge.kappa"], positive((1 + e) * r_A() * r_B() / (2 * sqrt(e)))});
  know(above_0);
  const Known in_an_angle(
      {below_1, linear(lt(0, 1 - power(kappa(), 2)), {times(below_1, above_0), below_1})});
  const Expr rest = 1 - power(kappa(), 2), t = sqrt(rest) / kappa();
  const Theorem is = define("h_e", masses_and_e(), atan(t), -1);
  const Expr h = is.conclusion().arg(0);
  Exprs domain = masses;
  domain.push_back(lt(kappa(), 1));
  restrict_domain("h_e", masses_and_e(), logic_and(domain));
  book.show("h_e", "", "Where kappa is below 1 it is the cosine of an angle,", under(domain, is));
  const Theorem square =
      equation(power(1 / kappa(), 2), 1 + power(t, 2), {root_squared(positive(rest))});
  const Theorem cosine = book.show(
      "cosine", "", "as",
      under(domain, equation(cos(h), kappa(),
                             {chain(rewrite(turned(is), use("cos atan", {{x, t}})),
                                    equation(1 / sqrt(1 + power(t, 2)), kappa(),
                                             {root_of(square, positive(1 / kappa()))}))})));
  know(linear(lt(0, h), {is, positive(atan(t))}));
  know(linear(lt(h, pi() / 2), {is, use("atan range", {{x, t}})}));
  const Expr sine = sin((j + 1) * h), U_j = chebyshev(j, kappa());
  const Theorem quotient = rewrite(cosine, instantiate(book["chebyshev.sine"], {{y, h}}));
  const Theorem sin_h = positive(sin(h));
  know(sin_h);
  book.show("speed_sine", "", "so that the approach speeds are sines, too,",
            equation(closing(j), V * pow(j) * side(j) * (sine / sin(h)),
                     {book["wedge.speed"], divided(U_j, sine / sin(h), {sin(h)}, quotient)}));
  const auto with_sign = [&](Expr goal, Expr premise, Expr difference) {
    return given(premise, [&](const Theorem& p) {
      return linear(goal, {quotient, times(linear(difference, {p}), sin(h))});
    });
  };
  const Theorem sign =
      tautology(iff(lt(0, closing(j)), lt(0, sine)),
                {book["wedge.takes_place"], with_sign(lt(0, sine), lt(0, U_j), lt(0, U_j)),
                 with_sign(le(sine, 0), le(U_j, 0), le(0, -U_j))});
  book.show("in_the_angle", "",
            "and collision j takes place if and only if a sine is positive:", sign);
  domain.push_back(V_positive);
  count(book, {"N_e",
               {M_A, w_B, M_C, e, V},
               domain,
               closing,
               [&](Expr i) { return i * h; },
               h,
               pi() / h,
               sign});
}
}  // namespace

Expr all_take_place(Expr last) {
  const Expr i = integer("i");
  return all(i, imp(logic_and({le(0, i), le(i, last)}), lt(0, closing(i))));
}
Theorem all_of(Expr last, const std::function<Theorem(Expr, const Theorem&)>& each) {
  const Expr i = integer("i");
  return generalize(i, given(logic_and({le(0, i), le(i, last)}),
                             [&](const Theorem& range) { return each(i, range); }));
}
Theorem divided(Expr l, Expr r, const Exprs& factors, const Theorem& times_factors) {
  Certificate c;
  for (const Expr& f : factors) c.multipliers.push_back(positive(f));
  c.nonzero = c.multipliers;
  c.equations = {{1, times_factors}};
  return arithmetic(eq(l, r), c);
}

void wedge(Book& book) {
  Exprs assumptions = wedge_assumptions();
  assumptions.push_back(lt(0, e));
  book.chapter("wedge", "The wedge", assumptions);
  const Known signs({assume(lt(0, M_A)), assume(le(0, w_B)), assume(lt(0, M_C)), assume(lt(0, e)),
                     assume(from_0)});
  const Theorems rules = shares(book);
  const Theorem speed = speeds(book, rules);
  signs_of_factors(book);
  const Theorem factor = positive(V * pow(j) * side(j));
  const Expr U_j = chebyshev(j, kappa());
  book.show("takes_place", "", "and takes place if and only if U_j is positive:",
            tautology(iff(lt(0, closing(j)), lt(0, U_j)),
                      {given(lt(0, U_j),
                             [&](const Theorem& c) {
                               return linear(lt(0, closing(j)), {speed, times(factor, c)});
                             }),
                       given(le(U_j, 0), [&](const Theorem& c) {
                         return linear(le(closing(j), 0), {speed, times(factor, c)});
                       })}));
  angle_of_the_wedge(book);
  know(assume(le(1, kappa())));
  book.show("never_ends", "", "Where kappa is 1 or more, the collisions never end:",
            under({V_positive},
                  tautology(lt(0, closing(j)),
                            {book["wedge.takes_place"],
                             linear(lt(0, U_j), {at(book["chebyshev.rise"], {{x, kappa()}})})})));
}
}  // namespace derivation
