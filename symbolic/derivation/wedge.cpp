// SPDX-License-Identifier: GPL-2.0-or-later
// Three bodies of any masses with restitution are a ray in a wedge: how fast they approach, how
// often they collide, and that they never stop where the wedge is no angle.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
/// The roots of the shares of mass.
void shares(Book& book) {
  const auto share = [&](const char* name, Expr of, Expr value, Expr domain, const char* words) {
    const Theorem is = book.name(name, {of, M_C}, sqrt(value), {domain, lt(0, M_C)}, words);
    know(positive(is));
  };
  share("r_A", M_A, M_A / (M_A + M_C), lt(0, M_A), "With the roots of the shares of mass");
  share("r_B", w_B, 1 / (1 + w_B * M_C), le(0, w_B), "and, for a block or with 1 for a wall,");
}
void signs_of_factors(Book& book) {
  const Expr side_j = side(j), q = r_A() / r_B();
  const Theorem sides =
      positive(equation(side_j, (power(side_j, 2) + q) / (1 + q), {book["motion.turn_squared"]}));
  const Theorems pow_is = parts({at(book["multiples.pow"], {{y, sqrt(e)}})});
  const Theorem powers = by_induction(
      j, lt(0, root_power(j)), linear(lt(0, root_power(0)), {pow_is[0]}), [&](const Theorem& now) {
        return linear(lt(0, root_power(j + 1)), {at(pow_is[1]), times(now, sqrt(e))});
      });
  know(book.show("signs", "Its factors are positive:",
                 both({positive(r_A()), positive(r_B()), sides, powers})));
}
/// Where kappa is the cosine of an angle h: pi/h collisions, rounded up, less one.
void angle_of_the_wedge(Book& book, const Theorem& speed) {
  const Expr x_e = kappa(), rest = 1 - power(x_e, 2), t = sqrt(rest) / x_e;
  const Theorem below_1 = assume(lt(x_e, 1));
  const Known in_an_angle({below_1, linear(lt(0, rest), {times(below_1, x_e), below_1})});
  Exprs domain = of_wedge({lt(0, e), below_1.conclusion()});
  const Theorem is = book.name("h_e", masses_and_e(), atan(t), domain,
                               "Where kappa is below 1 it is the cosine of an angle,");
  const Expr h = left(is);
  const Theorem square = equation(power(1 / x_e, 2), 1 + power(t, 2));
  const Theorem cosine =
      book.show("cosine", "as",
                under(domain, equation(cos(h), x_e,
                                       {chain(rewrite(turned(is), at("cos atan", {{x, t}})),
                                              equation(1 / sqrt(1 + power(t, 2)), x_e,
                                                       {root_of(square, positive(1 / x_e))}))})));
  know(book.show("acute", "an acute one,", both({positive(is), linear(lt(h, pi() / 2), {is})})));
  const Expr sine = sin((j + 1) * h), U_j = U(j);
  const Theorem quotient = rewrite(cosine, at(book["chebyshev.sine"], {{y, h}}));
  book.show("speed_sine", "so that the approach speeds are sines, too,",
            equation(closing(j), V * root_power(j) * side(j) * (sine / sin(h)),
                     {speed, divided(U_j, sine / sin(h), {sin(h)}, quotient)}));
  const Theorem sign =
      tautology(iff(lt(0, closing(j)), lt(0, sine)),
                {book["wedge.takes_place"],
                 same_sign(iff(lt(0, sine), lt(0, U_j)), sin(h), {turned(quotient)})});
  book.show("in_the_angle", "and collision j takes place if and only if a sine is positive:", sign);
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

Theorem divided(Expr l, Expr r, const Exprs& factors, const Theorem& times_factors) {
  Certificate c{.equations = {{1, times_factors}}};
  for (const Expr& f : factors) c.multipliers.push_back(positive(f));
  return certified(eq(l, r), c);
}
Theorems squared_shares(const Book& book) {
  Theorems out;
  for (const char* id : {"wedge.r_A", "wedge.r_B"}) {
    const Theorem r = book[id];
    const Expr share = right(r).arg(0);
    out.push_back(equation(power(left(r), 2), share, {r}));
  }
  return out;
}

Theorem approach_speeds(const Book& book, const Motion& of, const std::function<Expr(Expr)>& value,
                        const Theorems& rules) {
  const Theorems pow_is = parts({at(book["multiples.pow"], {{y, sqrt(e)}})});
  const Theorems turns = parts({book["cycle.turn"]});
  const auto of_kappa = [&](const char* id) { return at(book[id], {{x, kappa()}}); };
  const auto of_motion = [&](const char* id) { return book[of.chapter + id]; };
  const auto at_0 = [](const Theorem& t) { return canonical_form(at(t, {{j, 0}})); };
  const auto claim = [&](Expr i) { return eq(of.closing(i), value(i)); };
  const Theorems first{at_0(of_motion(".first")),
                       at_0(of_motion(".second")),
                       turns[0],
                       at_0(turns[1]),
                       pow_is[0],
                       at_0(pow_is[1]),
                       at_0(of_kappa("chebyshev.start")),
                       at_0(of_kappa("chebyshev.last"))};
  const Theorem last = of_kappa("chebyshev.last");
  Theorems next{of_motion(".recurrence"), book["motion.turn_squared"], of_kappa("chebyshev.next")};
  for (const Theorem& t : {turns[1], pow_is[1], last})
    next = next + Theorems{at(t), at(t, {{j, j + 1}})};
  const auto all = squared_shares(book) + rules;
  return part(by_induction(j, logic_and({claim(j), claim(j + 1)}), first + all, next + all), 0);
}

void wedge(Book& book) {
  book.chapter("wedge", "The wedge", of_wedge({le(0, j), lt(0, e)}));
  shares(book);
  const Theorem is = book.name("kappa", masses_and_e(), (1 + e) * r_A() * r_B() / (2 * sqrt(e)),
                               of_wedge({lt(0, e)}), "the shape of the motion is one number:");
  know(positive(is));
  const Theorem speed =
      book.show("speed", "So collision j has the approach speed",
                approach_speeds(book, at_rest,
                                [](Expr i) { return V * root_power(i) * side(i) * U(i); }, {is}));
  signs_of_factors(book);
  const Expr U_j = U(j), closes = closing(j);
  book.show("takes_place", "and takes place if and only if U_j is positive:",
            same_sign(iff(lt(0, closes), lt(0, U_j)), V * root_power(j) * side(j), {speed}));
  angle_of_the_wedge(book, speed);
  know(assume(le(1, kappa())));
  book.show("never_ends", "Where kappa is 1 or more, the collisions never end:",
            under({V_positive},
                  tautology(lt(0, closes),
                            {book["wedge.takes_place"],
                             linear(lt(0, U_j), {at(book["chebyshev.rise"], {{x, kappa()}})})})));
}
}  // namespace derivation
