// SPDX-License-Identifier: GPL-2.0-or-later
// Three bodies from any start: how fast they approach, and how often they collide.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
/// The approach speed before collision j, and its recurrence.
void recurrence(Book& book, const Theorems& motion) {
  const Theorems turns = parts({book["cycle.turn"]});
  const Theorem square = book["cycle.turn_squared"];
  const Theorem definition =
      book.name("nearing", any_start() + Exprs{j},
                is_P(j) * (any_velocity("A", j) - any_velocity("C", j)) +
                    is_Q(j) * (any_velocity("C", j) - any_velocity("B", j)),
                of_wedge({le(0, j)}), "Before collision j its two bodies approach with the speed",
                "", "closing");
  Theorems step{definition, at(turns[1]), square};
  for (std::size_t i = 3; i < 6; ++i) step.push_back(at(motion[i]));
  const Expr next = j + 1, from_P = (1 + e) / (M_A + M_C), from_Q = (1 + e) / (1 + w_B * M_C);
  Theorems changes;
  for (const auto& [body, share] :
       {std::pair{"A", -(is_P(j) * (M_C * from_P))}, std::pair{"B", is_Q(j) * (w_B * M_C * from_Q)},
        std::pair{"C", is_P(j) * (M_A * from_P) - is_Q(j) * from_Q}})
    changes.push_back(
        equation(any_velocity(body, next), any_velocity(body, j) + share * nearing(j), step));
  book.show("changes", "which changes velocities by shares of it:", both(changes));
  const Theorem closes = at(definition, {{j, next}});
  const auto other = [&](Expr i) {  // of the two that collide next
    return is_Q(i) * (any_velocity("A", i) - any_velocity("C", i)) +
           is_P(i) * (any_velocity("C", i) - any_velocity("B", i));
  };
  const Theorem parting = book.show("parting", "They part e times as fast as they approached:",
                                    equation(other(next), -e * nearing(j), step));
  const auto share = [](Expr i) {
    return is_P(i) * (M_A / (M_A + M_C)) + is_Q(i) * (1 / (1 + w_B * M_C));
  };
  const Theorem gain =
      equation(nearing(next), other(j) + (1 + e) * share(j) * nearing(j), step + Theorems{closes});
  const Theorems start{motion[0], motion[1], motion[2], turns[0], at(definition, {{j, 0}})};
  const Theorem second = equation(nearing(Expr(0) + 1), W + (1 + e) * (M_A / (M_A + M_C)) * V,
                                  Theorems{at(gain, {{j, 0}})} + start);
  book.show("first", "The first two speeds are",
            both({equation(nearing(0), V, start), restate(eq(nearing(1), right(second)), second)}));
  const auto carried = [&](Expr i) {  // the momentum, times w_B
    return w_B * (M_A * any_velocity("A", i) + M_C * any_velocity("C", i)) + any_velocity("B", i);
  };
  const Theorem momentum =
      book.show("momentum", "Momentum is kept, if there is no wall:",
                by_induction(j, eq(carried(j), any_momentum()),
                             equation(carried(0), any_momentum(), start), [&](const Theorem& now) {
                               return chain(equation(carried(next), carried(j), changes), now);
                             }));
  // The two speeds after collision j, by the one before it and the one before the next.
  const Theorem parts_with = solved_for(e * nearing(j), parting);
  const Expr A = any_velocity("A", next), B = any_velocity("B", next), C = any_velocity("C", next);
  const Expr of_A = nearing(next) - e * nearing(j), all = mass_of_all();
  const Expr of_B = is_Q(next) * nearing(next) - is_P(next) * (e * nearing(j));
  const Theorem A_B = book.show("A_B", "After collision j the velocities of A and B differ by",
                                linear(eq(A - B, of_A), {closes, parting}));
  const Theorem C_B =
      book.show("C_B", "those of C and B by",
                equation(C - B, of_B, {closes, parts_with, at(square, {{j, next}})}));
  const Expr given_off = any_momentum() - w_B * (M_A * of_A + M_C * of_B);
  const Theorem of_one = rewrite(solved_for(A, A_B), at(momentum, {{j, next}}));
  const Theorem whole = linear(eq(B * all, given_off), {rewrite(solved_for(C, C_B), of_one)});
  book.show("B_velocity", "and B has", divided(B, all, whole));
  book.show("recurrence", "and each one follows from two before:",
            linear(eq(nearing(j + 2), (1 + e) * share(next) * nearing(next) - e * nearing(j)),
                   {at(gain, {{j, next}}), parting}));
}
/// The motion, collision by collision.
void sequence(Book& book) {
  const Exprs of_masses{right(book["restitution.v_1"]), right(book["restitution.v_2"])};
  const auto of_A = [&](std::size_t body, Expr u, Expr other) {
    return substitute(of_masses[body], {{M_1, M_A}, {M_2, M_C}, {u_1, u}, {u_2, other}});
  };
  const auto of_B = [&](std::size_t body, Expr u, Expr other) {
    const Expr v = replace(right(part(book["restitution.inverse_mass"], body)), 1 / M_2, w_B);
    return substitute(v, {{M_1, M_C}, {u_1, u}, {u_2, other}});
  };
  const Expr P = is_P(j), Q = is_Q(j);
  const auto next = [&](const Exprs& before) {
    const Expr A = before[0], B = before[1], C = before[2];
    return Exprs{P * of_A(0, A, C) + Q * A, P * B + Q * of_B(1, C, B),
                 P * of_A(1, A, C) + Q * of_B(0, C, B)};
  };
  const Theorems motion = defined_by_recursion({"any_A", "any_B", "any_C"}, any_start(), j,
                                               of_wedge({le(0, j)}), {V + W, 0, W}, next);
  book.show("start",
            "At the start A approaches the ball with V and the ball B with W, seen from B; w_B is "
            "1/M_B for a block and 0 for a wall:",
            both({motion[0], motion[1], motion[2]}));
  book.show("next", "Collision j is one of A and C, or of C and B, by turns:",
            both({motion[3], motion[4], motion[5]}));
  recurrence(book, motion);
}
void closed_form(Book& book, const Theorem& r_e_is) {
  const Theorems pow_is = parts({at(book["multiples.pow"], {{y, sqrt(e)}})});
  const Theorems turns = parts({book["cycle.turn"]});
  const auto of_kappa = [&](const char* id) { return at(book[id], {{x, kappa()}}); };
  const auto claim = [&](Expr i) { return eq(nearing(i), root_power(i) * side(i) * swing(i)); };
  const Theorem last = of_kappa("chebyshev.last");
  const Theorems values = squared_shares(book) + Theorems{book["wedge.kappa"], r_e_is};
  Theorems first = values + Theorems{book["any_start.first"], turns[0], pow_is[0]};
  for (const Theorem& t : {turns[1], pow_is[1], of_kappa("chebyshev.start"), last})
    first.push_back(canonical_form(at(t, {{j, 0}})));
  Theorems next = values + Theorems{book["any_start.recurrence"], book["cycle.turn_squared"]};
  for (const Theorem& t : {turns[1], pow_is[1], last})
    next = next + Theorems{at(t), at(t, {{j, j + 1}})};
  const Theorem speed =
      book.show("speed", "collision j has the approach speed",
                part(by_induction(j, logic_and({claim(j), claim(j + 1)}), first, next), 0));
  know(book["wedge.signs"]);
  book.show("takes_place", "and takes place if and only if a sum is positive:",
            same_sign(iff(lt(0, nearing(j)), lt(0, swing(j))), root_power(j) * side(j), {speed}));
}
/// Where kappa is below 1: how many collisions there are.
void number(Book& book) {
  const Known here;
  Exprs domain = of_wedge({lt(0, e), lt(kappa(), 1), V_positive});
  const Theorem cosine = turned(book["wedge.cosine"]);
  know(book["wedge.acute"]);
  const Expr h = right(cosine).arg(0);
  const Expr slope = (kappa() + W / V * r_e()) / sin(h), tilt = atan(slope);
  const Theorem is =
      book.define("phase_e", any_start(), pi() / 2 - tilt, domain,
                  "Where kappa is below 1 and A approaches the ball, with the angle");
  const Expr phase = left(is), length = sqrt(1 + power(slope, 2));
  know(positive(length));
  const auto angle = [&](Expr i) { return phase + (i - 1) * h; };
  const auto turned_by = [&](Expr value, const char* axiom, Expr over) {
    return rewrite(turned(is),
                   equation(value, over / length, {at(axiom, {{x, slope}})}, {pi() / 2, tilt}));
  };
  const Theorems rules{turned_by(sin(right(is)), "cos atan", 1),
                       turned_by(cos(right(is)), "sin atan", slope), cosine};
  const Theorem sines =
      book.show("sine", "the approach speeds are sines,",
                equation(swing(j), V * length * sin(phase + j * h),
                         rules + quotients_of_sines(book, cosine), {j * h, h, phase}));
  const Theorem sign =
      tautology(iff(lt(0, nearing(j)), lt(0, sin(angle(j + 1)))),
                {book["any_start.takes_place"],
                 same_sign(iff(lt(0, swing(j)), lt(0, sin(angle(j + 1)))), V * length,
                           {restate(eq(swing(j), V * length * sin(angle(j + 1))), sines)})});
  know(both({linear(lt(0, phase), {is}), linear(lt(0, pi() - phase), {is})}));
  count(book, {"N_any", any_start(), domain, nearing, angle, h, (pi() - phase) / h + 1, sign});
}
}  // namespace

void from_any_start(Book& book) {
  book.chapter("any_start", "Three bodies from any start", of_wedge({le(0, j), lt(0, e)}));
  sequence(book);
  know(at(book["wedge.signs"], {{j, 0}}));
  const Theorem r_e_is =
      book.define("r_e", masses_and_e(), r_B() / (r_A() * sqrt(e)), of_wedge({lt(0, e)}),
                  "With a number by which the ball's approach to B counts,");
  know(positive(r_e_is));
  closed_form(book, r_e_is);
  number(book);
}
}  // namespace derivation
