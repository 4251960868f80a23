// The terminal velocities: their forms, order and signs; on the way A slows down and B speeds up.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
void kept_quantities(Book& book) {
  const Theorems velocities{book["power.a_multiplied"], book["power.b_multiplied"],
                            book["power.c_prime_multiplied"]};
  const Expr V2 = power(V, 2);
  const Theorem momentum =
      book.show("momentum_Q", "After n cycles momentum is what it was (over M),",
                equation(a(n) + b(n) + alpha * c_prime(n), V, velocities));
  const Theorem vector = book["cycle.vector"];
  const Theorems velocities_of{vector, at(vector, {{n, 0}})};
  const Theorem energy =
      book.show("energy_Q", "and energy (over M/2);",
                linear(eq(power(a(n), 2) + power(b(n), 2) + alpha * power(c_prime(n), 2), V2),
                       {rewritten(velocities_of + parts({book["cycle.start_vector"]}),
                                  book["cycle.V_length"])}));
  book.show("momentum_P", "so they are after P_n,",
            linear(eq(a(n) + b(n - 1) + alpha * c(n), V),
                   {one_before(momentum), book["cycle.momentum_P"]}));
  const Theorem at_P = equation(power(a(n - 1), 2) + alpha * power(c_prime(n - 1), 2),
                                power(a(n), 2) + alpha * power(c(n), 2), {book["cycle.P"]});
  book.show("energy_P", "too:",
            linear(eq(power(a(n), 2) + power(b(n - 1), 2) + alpha * power(c(n), 2), V2),
                   {one_before(energy), at_P}));
}

/// i < N |- 0 < approach_i, and |- approach_N <= 0
Theorem going_on(Book& book, Expr i, const Theorems& facts) {
  const Theorem happens = at(book["counting.happens"], {{j, i}});
  return tautology(lt(0, approach(i)), {happens, linear(lt(i, N()), facts)});
}
Theorem ended(Book& book) { return part(at(book["counting.happens"], {{j, 0}}), 1); }

/// Each collision that takes place slows A down or speeds B up.
void on_the_way(Book& book, const Theorems& approaches) {
  const auto changes = [&](Expr goal, Expr last, Expr i, std::size_t which, const char* step) {
    const Theorem going = going_on(book, i, {assume(le(n, last)), book["counting.shares"]});
    const Theorem speed = approaches[which];
    const Theorem above_0 = linear(lt(0, right(speed)), {going, speed});
    return linear(goal, {part(book[step], 0), times(above_0, 2 * alpha / (1 + alpha))});
  };
  book.show("a_falls", "Each collision slows A down,",
            changes(lt(a(n), a(n - 1)), N_A(), 2 * n - 2, 0, "cycle.P"));
  book.show("b_rises", "and each one of B speeds B up:",
            changes(lt(b(n - 1), b(n)), N_B(), 2 * n - 1, 1, "cycle.Q"));
}

/// The end if the last collision is number N = `count`: counts, terminal velocities, their order.
struct End {
  std::string name, words;
  Expr count, N_B_is, ball;
  Theorem order, momentum, energy;
};
Theorem at_the_end(Book& book, const End& end) {
  const Theorem is = assume(eq(N(), end.count)), shares = book["counting.shares"];
  const Theorem of_A = linear(eq(N_A(), n), {shares, is});
  const Theorem of_B = linear(eq(N_B(), end.N_B_is), {shares, is});
  const Theorems definitions = parts({book["terminal.definitions"]});
  const Theorem a_is = rewrite(of_A, definitions[0]), b_is = rewrite(of_B, definitions[1]);
  const Theorem from_momentum = solved_for(a(n), end.momentum);
  const Theorem c_is = equation(c_t(), end.ball, {definitions[2], a_is, b_is, from_momentum});
  book.show(end.name, end.words, both({of_A, of_B, a_is, b_is, c_is, end.order}));
  const Theorems values{a_is, b_is, c_is};
  return both(
      {linear(logic_and({le(a_t(), c_t()), le(c_t(), b_t())}), values + Theorems{end.order}),
       equation(power(a_t(), 2) + power(b_t(), 2) + alpha * power(c_t(), 2), power(V, 2),
                values + Theorems{solved_for(power(a(n), 2), end.energy)})});
}

/// a <= c <= b with the energy of the start |- 0 < b, b <= V
void below_V(Book& book, const Theorem& facts) {
  const Theorems all = parts({facts});  // a <= c, c <= b, energy
  const Theorem momentum =
      equation(a_t() + b_t() + alpha * c_t(), V, parts({book["terminal.definitions"]}));
  const Theorem b_positive = scaled(lt(0, b_t()), lt(0, (2 + alpha) * b_t()), 1 / (2 + alpha),
                                    {all[0], times(all[1], 1 + alpha), momentum});
  const Theorem not_faster =
      scaled(le(b_t(), V), le(power(b_t(), 2), power(V, 2)), 1 / (V + b_t()),
             {b_positive, all[2], not_negative(power(a_t(), 2) + alpha * power(c_t(), 2))});
  book.show("order",
            "In any case they are in the order of the bodies, and B is not faster than A was:",
            both({all[0], all[1], b_positive, not_faster}));
  book.show("energy", "with", both({momentum, all[2]}));
}
}  // namespace

void terminal(Book& book) {
  book.chapter("terminal", "Terminal velocities", {alpha_positive, V_positive, n_from_1});
  kept_quantities(book);
  const Theorems approaches{
      restate(eq(approach(2 * n - 2), a(n - 1) - c_prime(n - 1)),
              one_before(book["counting.approach_P"])),
      restate(eq(approach(2 * n - 1), c(n) - b(n - 1)), one_before(book["counting.approach_Q"]))};
  on_the_way(book, approaches);
  const Exprs domain{alpha_positive, V_positive};
  const auto named = [&](const std::string& name, Expr value) {
    return defined(name, {alpha, V}, value, domain);
  };
  const Theorem a_is = named("a_t", a(N_A())), b_is = named("b_t", b(N_B()));
  const Theorems definitions{a_is, b_is, named("c_t", (V - a_t() - b_t()) / alpha)};
  book.show("definitions", "eq:ct",
            "The terminal velocities, that of C from momentum:", under(domain, both(definitions)));
  const auto show_form = [&](const std::string& name, const std::string& label,
                             const Theorem& definition, Expr count, Expr value) {
    book.show(name, label, name == "a" ? "Their forms:" : "and",
              equation(left(definition), value,
                       {definition, at(book["power." + name], {{n, count}}), book["power.V_CM"],
                        book["rotation.cos_half_psi"]}));
  };
  show_form("a", "eq:a-terminal", definitions[0], N_A(),
            V / (2 + alpha) * (1 + (1 + alpha) * cos(N_A() * psi())));
  show_form("b", "eq:b-terminal", definitions[1], N_B(),
            V / (2 + alpha) * (1 - (1 + alpha) * cos((N_B() + rational(1, 2)) * psi())));

  // The last collision is Q_n, N = 2n, or P_n, N = 2n - 1.
  const auto last_is = [&](Expr count) { return assume(eq(N(), count)); };
  const auto over = [&](Expr i) {
    return restate(le(approach(i), 0), rewrite(last_is(i), ended(book)));
  };
  const auto going = [&](Expr i, Expr count) { return going_on(book, i, {last_is(count)}); };
  const auto weaker = [&](const std::string& id) { return cut(linear(le(0, n)), book[id]); };
  const Theorem order_Q =
      linear(logic_and({le(a(n), c_prime(n)), le(c_prime(n), b(n))}),
             {over(2 * n), weaker("counting.approach_P"), going(2 * n - 1, 2 * n), approaches[1],
              book["cycle.relative_Q"]});
  const Theorem order_P = linear(logic_and({le(a(n), c(n)), le(c(n), b(n - 1))}),
                                 {going(2 * n - 2, 2 * n - 1), approaches[0],
                                  book["cycle.relative_P"], over(2 * n - 1), approaches[1]});
  const Theorem end_Q =
      at_the_end(book, {"after_Q", "If Q_n is the last collision,", 2 * n, n, c_prime(n), order_Q,
                        weaker("terminal.momentum_Q"), weaker("terminal.energy_Q")});
  const Theorem end_P =
      at_the_end(book, {"after_P", "If P_n is the last collision,", 2 * n - 1, n - 1, c(n), order_P,
                        book["terminal.momentum_P"], book["terminal.energy_P"]});
  // One of them is, with n = N_A.
  const Theorem shares = book["counting.shares"];
  const auto at_N_A = [&](Expr count, const Theorem& end) {
    return given(eq(N(), count), [&](const Theorem& is) { return at(end, {{n, N_A()}}, {is}); });
  };
  const Theorem last =
      book.show("last", "One of them is the last, with n = N_A:",
                follows(logic_or({eq(N(), 2 * N_A()), eq(N(), 2 * N_A() - 1)}),
                        {linear(imp(lt(N(), 2 * N_A()), eq(N(), 2 * N_A() - 1)), {shares}),
                         linear(le(N(), 2 * N_A()), {shares})}));
  below_V(book, tautology(end_Q.conclusion(),
                          {at_N_A(2 * N_A(), end_Q), at_N_A(2 * N_A() - 1, end_P), last}));
  // (N_A - 1/2) psi < pi <= (N_A + 1/2) psi, so cosines of half of both have the signs of a_t <= 0.
  const Expr up = (N_A() + rational(1, 2)) * (psi() / 2),
             down = (N_A() - rational(1, 2)) * (psi() / 2);
  const Theorem cos_up = linear(le(0, -cos(up)), {cosine_falls(linear(le(pi() / 2, up)))});
  const Theorem as_product = chain(a_is, at(book["power.a_product"], {{n, N_A()}}));
  book.show(
      "a_recoils", "A does not go on forward:",
      linear(le(a_t(), 0), {as_product, product_of({positive(book["power.V_CM"]),
                                                    positive((1 + alpha) * cos(down)), cos_up})}));
}
}  // namespace derivation
