// SPDX-License-Identifier: GPL-2.0-or-later
// The terminal velocities: their forms, order and signs; on the way A slows down and B speeds up.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
const Expr from_0 = le(0, n), from_1 = le(1, n);
Expr a_t() { return fun("a_t", {alpha, V}); }
Expr b_t() { return fun("b_t", {alpha, V}); }
Expr c_t() { return fun("c_t", {alpha, V}); }

/// A theorem under 0 <= n, a cycle earlier.
Theorem one_before(const Theorem& t) {
  return use(discharge(from_0, t), {{n, n - 1}}, {linear(le(0, n - 1), {assume(from_1)})});
}

void kept_quantities(Book& book) {
  const Theorems velocities{book["power.a_multiplied"], book["power.b_multiplied"],
                            book["power.c_prime_multiplied"]};
  const Roots roots = roots_of(book);
  const Theorems rules = velocities + roots.squares + angles({cos(n * psi())}, {n * psi()});
  const Expr V2 = power(V, 2);
  const Theorem momentum =
      book.show("momentum_Q", "", "After n cycles momentum is what it was (over M),",
                equation(a(n) + b(n) + alpha * c_prime(n), V, rules, roots.divisors));
  const Theorem energy =
      book.show("energy_Q", "", "and energy (over M/2);",
                equation(power(a(n), 2) + power(b(n), 2) + alpha * power(c_prime(n), 2), V2, rules,
                         roots.divisors));
  Theorems vectors = entries(book["cycle.vector"]);
  for (const Theorem& t : entries(instantiate(book["cycle.vector"], {{n, 0}})))
    vectors.push_back(cut(linear(le(0, 0), {}), t));
  const auto start = [&](std::size_t i) { return part(book["cycle.start_vector"], i); };
  const auto length = [](Expr i) { return times(transpose(V_vector(i)), V_vector(i)); };
  book.show(
      "V_length", "eq:V2", "so that the length of V_n is always that of V_0;",
      matrix_equation(length(n), length(0),
                      vectors + roots.squares +
                          Theorems{linear(eq(power(a(n), 2),
                                             V2 - power(b(n), 2) - alpha * power(c_prime(n), 2)),
                                          {energy}),
                                   start(0), start(1), start(2)}));
  book.show("momentum_P", "", "so they are after P_n,",
            linear(eq(a(n) + b(n - 1) + alpha * c(n), V),
                   {one_before(momentum), book["cycle.momentum_P"]}));
  const Theorem at_P = equation(power(a(n - 1), 2) + alpha * power(c_prime(n - 1), 2),
                                power(a(n), 2) + alpha * power(c(n), 2),
                                {part(book["cycle.P"], 0), part(book["cycle.P"], 1)},
                                {positive(1 + alpha, {assume(alpha_positive)})});
  book.show("energy_P", "", "too:",
            linear(eq(power(a(n), 2) + power(b(n - 1), 2) + alpha * power(c(n), 2), V2),
                   {one_before(energy), at_P}));
}

/// The approach speeds before P_n and Q_n, by the velocities around them.
struct Approaches {
  Theorem at_P, at_Q;
};
Approaches approaches_of(Book& book) {
  return {
      restate(eq(approach(2 * n - 2), a(n - 1) - c_prime(n - 1)),
              one_before(book["counting.approach_P"])),
      restate(eq(approach(2 * n - 1), c(n) - b(n - 1)), one_before(book["counting.approach_Q"]))};
}
/// i < N |- 0 < approach_i, and |- approach_N <= 0
Theorem going_on(Book& book, Expr i, const Theorem& i_from_0, const Theorem& below) {
  const Theorem happens = use(discharge(le(0, j), book["counting.happens"]), {{j, i}}, {i_from_0});
  return tautology(lt(0, approach(i)), {happens, below});
}
Theorem ended(Book& book) {
  return part(use(discharge(le(0, j), book["counting.happens"]), {{j, 0}}, {linear(le(0, 0), {})}),
              1);
}

/// Each collision that takes place slows A down or speeds B up.
void on_the_way(Book& book, const Approaches& approaches) {
  const Theorem mass = assume(alpha_positive);
  const Theorem p1 = positive(1 + alpha, {mass});
  const Theorem n_from_1 = assume(from_1);
  const Theorem shares = book["counting.shares"];
  const Theorem rounded = use("ceiling", {{x, N() / 2}});
  const auto changes = [&](Expr goal, Expr last, Expr i, const Theorem& speed, const Theorem& step,
                           int sign) {
    const Theorem up_to = assume(le(n, last));
    const Theorem below = next_integer(linear(
        lt(i, N()), {up_to, part(shares, 0), part(shares, 1), part(rounded, 0), part(rounded, 1)}));
    const Theorem going =
        going_on(book, i, linear(le(0, i), {n_from_1}), linear(lt(i, N()), {below}));
    Certificate c;
    c.multipliers = {p1};
    c.nonzero = {p1};
    c.equations = {{Expr(sign) * (1 + alpha), step}};
    c.products = {{2, {mass, linear(lt(0, speed.conclusion().arg(1)), {going, speed})}, {}}};
    return arithmetic(goal, c);
  };
  book.show(
      "a_falls", "", "Each collision slows A down,",
      changes(lt(a(n), a(n - 1)), N_A(), 2 * n - 2, approaches.at_P, part(book["cycle.P"], 0), 1));
  book.show(
      "b_rises", "", "and each one of B speeds B up:",
      changes(lt(b(n - 1), b(n)), N_B(), 2 * n - 1, approaches.at_Q, part(book["cycle.Q"], 0), -1));
}

/// The end if the last collision is number N = `count`: who has had how many, the terminal
/// velocities and their order.
struct End {
  std::string name, words;
  Expr count, N_B_is, ball;
  Theorem order, momentum, energy;
};
Theorem at_the_end(Book& book, const End& end) {
  const Theorem mass = assume(alpha_positive);
  const Theorem is = assume(eq(N(), end.count));
  const Theorem shares = book["counting.shares"];
  const Theorem half = tautology(eq(ceil(N() / 2), n),
                                 {instantiate(ceiling_is(), {{x, N() / 2}, {k, n}}),
                                  linear(lt(n - 1, N() / 2), {is}), linear(le(N() / 2, n), {is})});
  const Theorem of_A = chain(part(shares, 0), half);
  const Theorem of_B = linear(eq(N_B(), end.N_B_is), {part(shares, 1), of_A, is});
  const Theorem definitions = book["terminal.definitions"];
  const Theorem a_is = rewrite(of_A, part(definitions, 0));
  const Theorem b_is = rewrite(of_B, part(definitions, 1));
  const Theorem c_is =
      equation(c_t(), end.ball,
               {part(definitions, 2), a_is, b_is,
                linear(eq(a(n), V - b(end.N_B_is) - alpha * end.ball), {end.momentum})},
               {mass});
  book.show(end.name, "", end.words, both({of_A, of_B, a_is, b_is, c_is, end.order}));
  const Theorem a_c = linear(le(a_t(), c_t()), {a_is, c_is, part(end.order, 0)});
  const Theorem c_b = linear(le(c_t(), b_t()), {c_is, b_is, part(end.order, 1)});
  const Theorem momentum = equation(
      a_t() + b_t() + alpha * c_t(), V,
      {a_is, b_is, c_is, linear(eq(a(n), V - b(end.N_B_is) - alpha * end.ball), {end.momentum})});
  const Expr squares = power(a_t(), 2) + power(b_t(), 2) + alpha * power(c_t(), 2);
  const Theorem energy = equation(squares, power(V, 2),
                                  {a_is, b_is, c_is,
                                   linear(eq(power(a(n), 2), power(V, 2) - power(b(end.N_B_is), 2) -
                                                                 alpha * power(end.ball, 2)),
                                          {end.energy})});
  return both({a_c, c_b, momentum, energy});
}

/// a <= c <= b with the momentum and energy of the start |- 0 < b, b <= V
void below_V(Book& book, const Theorem& facts) {
  const Theorem mass = assume(alpha_positive);
  const Theorem V_above_0 = assume(V_positive);
  const Theorem a_c = part(facts, 0), c_b = part(facts, 1);
  Certificate above;  // (2 + alpha) b = V + (1 + alpha)(b - c) + (c - a)
  above.multipliers = {positive(2 + alpha, {mass})};
  above.equations = {{-1, part(facts, 2)}};
  above.products = {
      {1, {V_above_0}, {}}, {1, {positive(1 + alpha, {mass}), c_b}, {}}, {1, {a_c}, {}}};
  const Theorem b_positive = arithmetic(lt(0, b_t()), above);
  Certificate below;  // (V + b)(V - b) = a^2 + alpha c^2
  below.multipliers = {linear(lt(0, V + b_t()), {V_above_0, b_positive})};
  below.equations = {{1, part(facts, 3)}};
  below.products = {{1, {}, {a_t()}}, {1, {mass}, {c_t()}}};
  book.show("order", "",
            "In any case they are in the order of the bodies, and B is not faster than A was:",
            both({a_c, c_b, b_positive, arithmetic(le(b_t(), V), below)}));
  book.show("energy", "", "with", both({part(facts, 2), part(facts, 3)}));
}

/// (N_A - 1/2) psi < pi <= (N_A + 1/2) psi, so that cosines of half of both have the signs that
/// make a_t <= 0.
void recoil(Book& book) {
  const Theorem mass = assume(alpha_positive);
  const Theorem around_pi = book["constraints.N_A_angle"];
  const Theorem psi_range = book["rotation.psi_range"];
  const Theorem N_A_from_1 = part(book["counting.at_least"], 0);
  const Expr up = (N_A() + rational(1, 2)) * (psi() / 2),
             down = (N_A() - rational(1, 2)) * (psi() / 2);
  const Theorem down_from =
      linear(lt(0, down),
             {times(linear(lt(0, N_A() - rational(1, 2)), {N_A_from_1}), part(psi_range, 0))});
  const Theorem cos_down =
      cosine_positive(down_from, linear(lt(down, pi() / 2), {part(around_pi, 0)}));
  const Theorem up_to = linear(le(up, pi()), {part(around_pi, 0), part(psi_range, 1)});
  const Theorem falls = cosine_falls(linear(le(0, pi() / 2), {positive(pi())}),
                                     linear(le(pi() / 2, up), {part(around_pi, 1)}), up_to);
  const Theorem cos_up = linear(le(cos(up), 0), {falls, axiom("cos pi/2")});
  const Theorem form = use(discharge(from_0, book["power.a_product"]), {{n, N_A()}},
                           {linear(le(0, N_A()), {N_A_from_1})});
  const Theorem a_is = chain(part(book["terminal.definitions"], 0), form);
  const Theorem mean = linear(
      lt(0, V_CM()), {positive(V / (2 + alpha), {mass, assume(V_positive)}), book["power.V_CM"]});
  Certificate c;
  c.equations = {{1, a_is}};
  c.products = {
      {2, {mean, positive(1 + alpha, {mass}), linear(le(0, -cos(up)), {cos_up}), cos_down}, {}}};
  book.show("a_recoils", "", "A does not go on forward:", arithmetic(le(a_t(), 0), c));
}
}  // namespace

void terminal(Book& book) {
  book.chapter("terminal", "Terminal velocities", {alpha_positive, V_positive, from_1});
  kept_quantities(book);
  const Approaches approaches = approaches_of(book);
  on_the_way(book, approaches);
  Theorems definitions;
  for (const auto& [name, value] : {std::pair{"a_t", a(N_A())}, std::pair{"b_t", b(N_B())}}) {
    definitions.push_back(define(name, {alpha, V}, value));
    restrict_domain(name, {alpha, V}, logic_and({alpha_positive, V_positive}));
  }
  definitions.push_back(define("c_t", {alpha, V}, (V - a_t() - b_t()) / alpha));
  restrict_domain("c_t", {alpha, V}, logic_and({alpha_positive, V_positive}));
  book.show("definitions", "eq:ct", "The terminal velocities, that of C from momentum:",
            under({alpha_positive, V_positive}, both(definitions)));
  const auto form = [&](const std::string& id, Expr count, std::size_t which) {
    const Theorem from = linear(le(0, count), {part(book["counting.at_least"], which)});
    return chain(definitions[which], use(discharge(from_0, book[id]), {{n, count}}, {from}));
  };
  const Theorem p1 = positive(1 + alpha, {assume(alpha_positive)});
  const Theorem cos_half = book["rotation.cos_half_psi"];
  const Theorems form_rules{book["power.V_CM"], cos_half};
  const Theorem cos_positive = part(book["rotation.half_signs"], 1);
  const auto show_form = [&](const std::string& name, const std::string& label, const Theorem& t,
                             Expr value) {
    book.show(name, label, name == "a" ? "Their forms:" : "and",
              equation(t.conclusion().arg(0), value, Theorems{t} + form_rules,
                       {cos_positive, p1, positive(2 + alpha, {assume(alpha_positive)})}));
  };
  show_form("a", "eq:a-terminal", form("power.a", N_A(), 0),
            V / (2 + alpha) * (1 + (1 + alpha) * cos(N_A() * psi())));
  show_form("b", "eq:b-terminal", form("power.b", N_B(), 1),
            V / (2 + alpha) * (1 - (1 + alpha) * cos((N_B() + rational(1, 2)) * psi())));

  // The last collision is Q_n, N = 2n, or P_n, N = 2n - 1.
  const Theorem n_from_1 = assume(from_1);
  const auto going = [&](Expr i, const Theorem& N_is) {
    return going_on(book, i, linear(le(0, i), {n_from_1}), linear(lt(i, N()), {N_is}));
  };
  const Theorem Q_last = assume(eq(N(), 2 * n));
  const Theorem Q_over = restate(le(approach(2 * n), 0), rewrite(Q_last, ended(book)));
  const Theorem n_from_0 = linear(le(0, n), {n_from_1});
  const auto from_1_on = [&](const std::string& id) { return cut(n_from_0, book[id]); };
  const Theorem order_Q =
      both({linear(le(a(n), c_prime(n)), {Q_over, from_1_on("counting.approach_P")}),
            linear(le(c_prime(n), b(n)),
                   {going(2 * n - 1, Q_last), approaches.at_Q, book["cycle.relative_Q"]})});
  const Theorem P_last = assume(eq(N(), 2 * n - 1));
  const Theorem P_over = restate(le(approach(2 * n - 1), 0), rewrite(P_last, ended(book)));
  const Theorem order_P = both({linear(le(a(n), c(n)), {going(2 * n - 2, P_last), approaches.at_P,
                                                        book["cycle.relative_P"]}),
                                linear(le(c(n), b(n - 1)), {P_over, approaches.at_Q})});
  const Theorem end_Q =
      at_the_end(book, {"after_Q", "If Q_n is the last collision,", 2 * n, n, c_prime(n), order_Q,
                        from_1_on("terminal.momentum_Q"), from_1_on("terminal.energy_Q")});
  const Theorem end_P =
      at_the_end(book, {"after_P", "If P_n is the last collision,", 2 * n - 1, n - 1, c(n), order_P,
                        book["terminal.momentum_P"], book["terminal.energy_P"]});
  // One of them is, with n = N_A.
  const Theorem shares = book["counting.shares"];
  const Theorem rounded = use("ceiling", {{x, N() / 2}});
  const Theorem less = assume(lt(N(), 2 * N_A()));
  const Theorem up =
      next_integer(linear(lt(2 * N_A(), N() + 2), {part(shares, 0), part(rounded, 1)}));
  const auto at_N_A = [&](const Theorem& t, Expr count) {
    return use(discharge(from_1, discharge(eq(N(), count), t)), {{n, N_A()}},
               {part(book["counting.at_least"], 0)});
  };
  const Theorem last = book.show(
      "last", "", "One of them is the last, with n = N_A:",
      tautology(
          logic_or({eq(N(), 2 * N_A()), eq(N(), 2 * N_A() - 1)}),
          {discharge(less.conclusion(), linear(eq(N(), 2 * N_A() - 1), {next_integer(less), up})),
           linear(le(N(), 2 * N_A()), {part(shares, 0), part(rounded, 0)}),
           use("equal or less or greater", {{x, N()}, {y, 2 * N_A()}})}));
  below_V(book,
          tautology(end_Q.conclusion(), {at_N_A(end_Q, 2 * n), at_N_A(end_P, 2 * n - 1), last}));
  recoil(book);
}
}  // namespace derivation
