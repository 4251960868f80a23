// What each collision takes from the energy of any motion, and all of them together.
#include "derivation/wedge.hpp"

namespace derivation {
void losses(Book& book) {
  const Exprs domain = of_wedge({le(0, j), lt(0, e)});
  book.chapter("losses", "The energy of any motion", domain);
  const Expr A = any_velocity("A", j), B = any_velocity("B", j), C = any_velocity("C", j);
  const auto of_pairs = [](Expr A_B, Expr C_B, Expr A_C) {
    return (M_A * power(A_B, 2) + M_C * power(C_B, 2) + w_B * M_A * M_C * power(A_C, 2)) /
           mass_of_all();
  };
  const Theorem is = book.define("energy", any_start() + Exprs{j}, of_pairs(A - B, C - B, A - C),
                                 of_wedge({le(0, j)}),
                                 "Twice the kinetic energy after j collisions, without that of the "
                                 "centre of mass, by the pairs of bodies:");
  const auto energy = [&](Expr i) { return substitute(left(is), {{j, i}}); };
  Theorems step{is, at(is, {{j, j + 1}}), book["any_start.closing"], book["cycle.turn_squared"]};
  for (const Theorem& next : parts({book["any_start.next"]})) step.push_back(at(next));
  const Expr mass = is_P(j) * (M_A * M_C / (M_A + M_C)) + is_Q(j) * (M_C / (1 + w_B * M_C));
  const Theorem lost = book.show(
      "collision", "Collision j takes from it, by the reduced mass of its two bodies,",
      equation(energy(j) - energy(j + 1), (1 - power(e, 2)) * mass * power(nearing(j), 2), step));

  const Known signs({book["wedge.signs"]});
  const Expr square = power(root_power(j), 2) * power(swing(j), 2);
  const Expr first_loss = (1 - power(e, 2)) * (M_C * power(r_A(), 2));
  const Theorems rules =
      squared_shares(book) + Theorems{book["any_start.speed"], book["cycle.turn_squared"]};
  const Theorem alike = book.show("alike", "which is alike for both kinds:",
                                  chain(lost, equation(right(lost), first_loss * square, rules)));
  const Theorems sum =
      defined_by_recursion({"squares"}, any_start(), j, domain, {0},
                           [&](const Exprs& before) { return Exprs{before[0] + square}; });
  book.show("squares", "So with a sum of squares,", under(domain, both(sum)));
  const Expr first = of_pairs(V + W, W, V);
  const Expr taken = first_loss * fun("squares", any_start() + Exprs{j});
  book.show("left", "after j collisions there is left",
            by_induction(j, eq(energy(j), first - taken),
                         {at(is, {{j, 0}}), sum[0], book["any_start.start"]},
                         {solved_for(energy(j + 1), alike), at(sum[1])}));
  book.show("bounded",
            "never less than 0; so if e < 1, and collisions never end, the terms of that sum, and "
            "with them the approach speeds, tend to 0:",
            linear(le(taken, first), {book["losses.left"], is, not_negative(right(is))}));
  book.show("falls", "and energy never rises:",
            linear(le(energy(j + 1), energy(j)),
                   {alike, product_of({assume(le(e, 1)), positive(1 + e),
                                       not_negative(M_C * power(r_A(), 2) * square)})}));
}
}  // namespace derivation
