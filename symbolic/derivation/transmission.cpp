// What collisions that lose energy let through: the paper's four equations, and the share that B
// has after one cycle and after two.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
const Expr e_more = real("e'");

/// The paper's velocities with restitution: of A, B and the ball after Q_n, of the ball after P_n.
Expr with_e(const char* name, Expr i) { return fun(name, {alpha, V, e, i}); }
Theorems names_of_paper(Book& book) {
  const auto named = [&](const char* name, const char* body, Expr i, Expr from, const char* words) {
    return book.name(name, {alpha, V, e, n}, substitute(velocity(body, i), blocks_of_paper),
                     {alpha_positive, from}, words);
  };
  return {named("a_e", "A", 2 * n, n_from_0,
                "For blocks of mass 1 and a ball of mass alpha: the velocities of A,"),
          named("b_e", "B", 2 * n, n_from_0, "of B"),
          named("c_e'", "C", 2 * n, n_from_0, "and of the ball after n cycles,"),
          named("c_e", "C", 2 * n - 1, n_from_1, "and the ball's within the n-th.")};
}
/// The laws of P_n and Q_n in these names.
void equations_of_paper(Book& book, const Theorems& names) {
  const Theorem from = assume(n_from_1);
  Theorems rules = names;
  for (const Theorem& t : parts({one_before(book["cycle.turns"])}))
    rules.push_back(canonical_form(t));
  for (std::size_t i = 0; i < 3; ++i) rules.push_back(one_before(names[i]));
  for (const Theorem& law : parts({book["motion.next"]}))
    for (const Expr i : {2 * n - 2, 2 * n - 1})
      rules.push_back(canonical_form(for_blocks(law, {{j, i}}, {from})));
  const Expr a_0 = with_e("a_e", n - 1), a_1 = with_e("a_e", n), b_0 = with_e("b_e", n - 1),
             b_1 = with_e("b_e", n), c_0 = with_e("c_e'", n - 1), c_1 = with_e("c_e", n),
             c_2 = with_e("c_e'", n);
  book.show(
      "paper", "eq:inelastic", "These are the paper's equations of P_n and Q_n:",
      equation(
          logic_and({eq(a_0 + alpha * c_0, a_1 + alpha * c_1), eq(e * (a_0 - c_0), c_1 - a_1),
                     eq(b_0 + alpha * c_1, b_1 + alpha * c_2), eq(e * (c_1 - b_0), b_1 - c_2)}),
          rules));
}
/// b_n(e) < b_n(e') |- the same of rho, where they differ by `factor`, a positive term.
void rises(Book& book, const std::string& name, const std::string& words, const Theorem& is,
           Expr factor) {
  const Theorem is_more = at(is, {{e, e_more}});
  const Expr b_n = left(is), b_more = left(is_more);
  const Expr difference = V * alpha / power(1 + alpha, 2) * (e_more - e) * factor;
  const Theorem larger = positive(equation(b_more - b_n, difference, {is, is_more}));
  const Theorem sum = linear(lt(0, b_more + b_n), {positive(is), positive(is_more)});
  const Expr rho = power(b_n / V, 2), rho_more = power(b_more / V, 2);
  book.show(name, words, linear(lt(rho, rho_more), {times(times(larger, sum), 1 / power(V, 2))}));
}
/// The velocities of B after one cycle and after two, and that they rise with e.
void first_cycles(Book& book, const Theorems& names) {
  const Theorems rules = first_collisions(book, 4);
  const Expr s = (1 + e) / (1 + alpha);
  const auto at_cycle = [&](const Theorem& name, int i) {
    return canonical_form(at(name, {{n, i}}));
  };
  const auto B_has = [&](int i, Expr value) {
    return equation(with_e("b_e", i), value, rules + Theorems{at_cycle(names[1], i)});
  };
  const Theorem after_1 =
      book.show("cycle_1", "After one cycle B has", B_has(1, V * alpha * power(s, 2)));
  const Expr room = power(s, 2) - 2 * e;
  const Theorem after_2 = book.show("cycle_2", "and after two, the last of them",
                                    B_has(2, V * alpha * power(s, 2) * (1 + room)));
  const Theorem approach = book.show("last_approach", "with the approach speed",
                                     equation(with_e("c_e", 2) - with_e("b_e", 1), V * s * room,
                                              rules + Theorems{after_1, at_cycle(names[3], 2)}));
  const Known more({assume(lt(e, e_more))});
  rises(book, "rises_1",
        "Where e and e' both have two or three collisions the first of these is B's last velocity, "
        "and its share of the energy, rho, rises,",
        after_1, 2 + e + e_more);
  const Expr room_more = substitute(room, {{e, e_more}});
  for (const Substitution& at_e : {Substitution{}, Substitution{{e, e_more}}}) {
    const Theorem meet = assume(substitute(lt(with_e("b_e", 1), with_e("c_e", 2)), at_e));
    know(arithmetic(substitute(lt(0, room), at_e),
                    {.equations = {{1, at(approach, at_e)}},
                     .products = {{1, {meet}}},
                     .multipliers = {positive(substitute(V * s, at_e))}}));
  }
  rises(book, "rises_2",
        "and so it does with the second where both have four or five (for more collisions figures "
        "show it, but it is not proved):",
        after_2, (2 + e + e_more) * (room + room_more) + (1 + e) * e_more + (1 + e_more) * e);
}
}  // namespace

Theorem for_blocks(const Theorem& t, Substitution terms, const Theorems& facts) {
  terms.insert(blocks_of_paper.begin(), blocks_of_paper.end());
  return at(t, terms, facts);
}
Theorems first_collisions(const Book& book, int count, const Substitution& bodies) {
  Theorems out = parts({book["cycle.turn"], at(book["motion.start"], bodies)});
  const Theorems laws = parts({out[1], book["motion.next"]});
  out.erase(out.begin() + 1);
  for (int i = 0; i < count; ++i) {
    Substitution there = bodies;
    there.insert({j, i});
    for (const Theorem& law : laws) out.push_back(canonical_form(at(law, there)));
  }
  return out;
}

void transmission(Book& book) {
  book.chapter("transmission", "What losses let through", {alpha_positive, V_positive, lt(0, e)});
  const Theorems names = names_of_paper(book);
  equations_of_paper(book, names);
  first_cycles(book, names);
}

// What each collision takes from the energy of any motion, and all of them together.
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
