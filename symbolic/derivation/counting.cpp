// SPDX-License-Identifier: GPL-2.0-or-later
// What happens: a collision takes place as long as its two bodies approach. How many there are.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr half_angle(Expr count) { return count * psi() / 2; }

/// |- pi <= x implies (x <= 2 pi implies sin(x) <= 0)
Theorem sine_not_positive() {
  const Theorem from_pi = assume(le(pi(), x));
  const Theorem to_end = assume(le(x, 2 * pi()));
  const Theorem shifted = equation(
      sin(x), -sin(x - pi()),
      angles({sin(x)}, {x - pi(), pi()}, false) + Theorems{axiom("cos pi"), axiom("sin pi")});
  const Theorem back =
      sine_not_negative(linear(le(0, x - pi()), {from_pi}), linear(le(x - pi(), pi()), {to_end}));
  return discharge(from_pi.conclusion(),
                   discharge(to_end.conclusion(), linear(le(sin(x), 0), {shifted, back})));
}

/// The approach speed before collision j, for both kinds alike.
Theorem approach_speed(Book& book) {
  const Expr P = (1 + turn(j)) / 2, Q = (1 - turn(j)) / 2;
  const Theorem definition =
      define("approach", {alpha, V, j}, P * (A(j) - C(j)) + Q * (C(j) - B(j)), 2);
  restrict_domain("approach", {alpha, V, j}, logic_and({alpha_positive, le(0, j)}));
  book.show("approach", "", "Before collision j its two bodies approach with the speed",
            under({alpha_positive, le(0, j)}, definition));
  const Theorem n_from_0 = assume(le(0, n));
  const Theorem turns = book["cycle.turns"];
  const auto named = [&](std::size_t i) { return turned(part(book["cycle.names"], i)); };
  const Theorem next_from_1 = linear(le(1, n + 1), {n_from_0});
  const auto in_next_cycle = [&](const std::string& id) {
    return use(discharge(le(1, n), book[id]), {{n, n + 1}}, {next_from_1});
  };
  const Theorem even = book.show(
      "approach_P", "", "that is, before P_(n+1)",
      equation(approach(2 * n), a(n) - c_prime(n),
               {instantiate(definition, {{j, 2 * n}}), part(turns, 0), named(0), named(2)}));
  const Theorem c_next = restate(eq(C(2 * n + 1), c(n + 1)), turned(in_next_cycle("cycle.name_c")));
  const Theorem waits = restate(eq(B(2 * n + 1), b(n)), in_next_cycle("cycle.B_waits"));
  const Theorem odd = book.show(
      "approach_Q", "", "and before Q_(n+1)",
      equation(approach(2 * n + 1), c(n + 1) - b(n),
               {instantiate(definition, {{j, 2 * n + 1}}), part(turns, 1), c_next, waits}));
  const auto value = [&](Expr i) { return V * sin(half_angle(i + 1)) / sin(psi() / 2); };

  // Every j is 2m or 2m + 1, m = ceil((j - 1)/2).
  const Expr m = ceil((j - 1) / 2);
  const Theorem ceiling = use("ceiling", {{x, (j - 1) / 2}});
  const Theorem j_from_0 = assume(le(0, j));
  const Theorem m_from_0 =
      linear(le(0, m), {next_integer(linear(lt(-1, m), {part(ceiling, 0), j_from_0}))});
  const Theorem two_m = next_integer(linear(lt(2 * m, j + 1), {part(ceiling, 1)}));
  const auto here = [&](const Theorem& t, Expr place) {
    const Theorem at_m = use(discharge(le(0, n), t), {{n, m}}, {m_from_0});
    const Theorem is_j = assume(eq(j, place));
    const Expr speed = V * sin((1 + place) * psi() / 2) / sin(psi() / 2);
    const Theorem at_place = restate(eq(approach(place), speed), at_m);
    return discharge(is_j.conclusion(),
                     restate(eq(approach(j), value(j)), rewrite(turned(is_j), at_place)));
  };
  const Theorem less = assume(lt(2 * m, j));
  const Theorem last = linear(eq(j, 2 * m + 1), {next_integer(less), part(ceiling, 0)});
  const Theorem order = use("equal or less or greater", {{x, j}, {y, 2 * m}});
  return book.show(
      "speed", "", "For both kinds it is the same sine:",
      tautology(eq(approach(j), value(j)),
                {here(chain(even, book["power.before_P"]), 2 * m),
                 here(chain(odd, book["power.before_Q"]), 2 * m + 1),
                 discharge(less.conclusion(), last), order, linear(le(2 * m, j), {two_m})}));
}

/// |- N = ceil(2 pi/psi) - 1, the least number of collisions after which there is no approach.
void number_of_collisions(Book& book, const Theorem& speed) {
  const Theorem V_above_0 = assume(V_positive);
  const Theorem psi_positive = part(book["rotation.psi_range"], 0);
  const Theorem psi_below = part(book["rotation.psi_range"], 1);
  const Theorem j_from_0 = assume(le(0, j));
  const Expr sine = sin(half_angle(j + 1));
  const Theorem sin_half = part(book["rotation.half_signs"], 0);
  const Theorem factor = times(V_above_0, positive(1 / sin(psi() / 2), {sin_half}));
  const Theorem goes_on = assume(lt(0, sine));
  const Theorem ends = assume(le(sine, 0));
  const Theorem sign = book.show(
      "takes_place", "",
      "Collision j takes place if and only if its bodies approach before it, so if "
      "and only if the sine is positive:",
      tautology(iff(lt(0, approach(j)), lt(0, sine)),
                {discharge(goes_on.conclusion(),
                           linear(lt(0, approach(j)), {speed, times(factor, goes_on)})),
                 discharge(ends.conclusion(),
                           linear(le(approach(j), 0),
                                  {speed, times(factor, linear(le(0, -sine), {ends}))}))}));
  const Theorem signs = discharge(le(0, j), sign);
  const Expr none = le(approach(j), 0);
  const Theorem least = define_least("N", {alpha, V}, j, 0, none);
  restrict_domain("N", {alpha, V}, logic_and({alpha_positive, V_positive}));
  book.show("N_least", "", "N is the least number of collisions after which there is no approach:",
            under({alpha_positive, V_positive}, least));

  const Expr z = 2 * pi() / psi();
  const Expr K = ceil(z) - 1;
  const Theorem ceiling = use("ceiling", {{x, z}});
  const Theorem per = equation(psi() * z, 2 * pi(), {}, {psi_positive});
  const Theorem reached =
      linear(le(pi(), half_angle(K + 1)),
             {times(linear(le(0, ceil(z) - z), {part(ceiling, 0)}), psi_positive), per});
  const Theorem within =
      linear(le(half_angle(K + 1), 2 * pi()),
             {times(linear(lt(0, z + 1 - ceil(z)), {part(ceiling, 1)}), psi_positive), per,
              psi_below, positive(pi())});
  Certificate c;
  c.multipliers = {psi_positive};
  c.products = {{2, {reached}, {}}, {2, {positive(pi())}, {}}};
  const Theorem K_from_0 = linear(le(0, K), {next_integer(arithmetic(lt(0, ceil(z)), c))});
  const Theorem sine_end =
      tautology(le(sin(half_angle(K + 1)), 0),
                {use(sine_not_positive(), {{x, half_angle(K + 1)}}, {reached}), reached, within});
  const Theorem at_K =
      tautology(substitute(none, {{j, K}}), {use(signs, {{j, K}}, {K_from_0}), sine_end});
  const Theorem found = use(least, {{j, K}}, {K_from_0, at_K});
  const Theorem N_from_0 = part(found, 0);
  know(N_from_0);
  const auto before = [&](Expr i, const Theorem& i_from_0, const Theorem& below) {  // i < K
    const Theorem room = linear(lt(0, z - 1 - i), {next_integer(below), part(ceiling, 1)});
    const Theorem less = linear(lt(half_angle(i + 1), pi()), {times(room, psi_positive), per});
    const Theorem more = positive(half_angle(i + 1), {positive(i + 1, {i_from_0}), psi_positive});
    return tautology(lt(0, approach(i)),
                     {use(signs, {{j, i}}, {i_from_0}),
                      use("sin positive", {{x, half_angle(i + 1)}}, {more, less})});
  };
  const Theorem early = assume(lt(N(), K));
  const Theorem lower = tautology(
      le(K, N()), {discharge(early.conclusion(), before(N(), N_from_0, early)), part(found, 1)});
  const Theorem number = book.show("N", "", "So the number of all collisions is",
                                   linear(eq(N(), K), {lower, part(found, 2)}));
  const Theorem j_below = assume(lt(j, N()));
  book.show("happens", "",
            "They are collisions 0 to N - 1, and no body approaches another after the "
            "last:",
            both({discharge(j_below.conclusion(),
                            before(j, j_from_0, linear(lt(j, K), {j_below, number}))),
                  part(found, 1)}));
}

/// N_A = ceil(pi/psi - 1/2), N_B = ceil(pi/psi - 1) from N_A = ceil(N/2), N_B = N - N_A.
void shares(Book& book) {
  const Theorem def_A = define("N_A", {alpha, V}, ceil(N() / 2));
  const Theorem def_B = define("N_B", {alpha, V}, N() - N_A());
  for (const char* name : {"N_A", "N_B"})
    restrict_domain(name, {alpha, V}, logic_and({alpha_positive, V_positive}));
  // 2 < 2 pi/psi, so there are two collisions or more, one of each block.
  const Theorem psi_from = part(book["rotation.psi_range"], 0);
  Certificate above_2;
  above_2.multipliers = {psi_from};
  above_2.nonzero = {psi_from};
  above_2.products = {{2, {part(book["rotation.psi_range"], 1)}, {}}};
  const Expr turns = 2 * pi() / psi();
  const Theorem enough = arithmetic(lt(2, turns), above_2);
  const Theorem turns_up = part(use("ceiling", {{x, turns}}), 0);
  const Theorem three = next_integer(linear(lt(2, ceil(turns)), {enough, turns_up}));
  const Theorem N_from_2 = linear(le(2, N()), {three, book["counting.N"]});
  const Theorem rounded = use("ceiling", {{x, N() / 2}});
  const Theorem N_A_from_1 = linear(le(1, N_A()), {def_A, part(rounded, 0), N_from_2});
  const Theorem N_B_above = linear(lt(0, N_B()), {def_A, def_B, part(rounded, 1), N_from_2});
  const Theorem N_B_from_1 = linear(le(1, N_B()), {next_integer(N_B_above)});
  book.show("shares", "", "A takes part in the first, the third, and so on, B in the others:",
            under({alpha_positive, V_positive}, both({def_A, def_B})));
  know(both({N_A_from_1, N_B_from_1}));
  book.show("at_least", "", "each at least once:", both({N_A_from_1, N_B_from_1}));
  const Expr z = pi() / psi();
  const Theorem psi_positive = psi_from;
  const Theorem number = book["counting.N"];
  const Theorem twice = equation(2 * pi() / psi(), 2 * z, {}, {psi_positive});
  const Theorem N_up =
      linear(le(2 * z - 1, N()), {number, twice, part(use("ceiling", {{x, 2 * pi() / psi()}}), 0)});
  const Theorem N_down =
      linear(lt(N(), 2 * z), {number, twice, part(use("ceiling", {{x, 2 * pi() / psi()}}), 1)});
  const auto ceiling_of = [](Expr t) { return use("ceiling", {{x, t}}); };
  // K = ceil(z - 1/2): 2K - 2 < N < 2K + 1, so K - 1 < N/2 <= K.
  const Expr K = ceil(z - rational(1, 2));
  const Theorem of_K = ceiling_of(z - rational(1, 2));
  const Theorem above = linear(lt(K - 1, N() / 2), {N_up, part(of_K, 1)});
  const Theorem below =
      linear(le(N() / 2, K), {next_integer(linear(lt(N(), 2 * K + 1), {N_down, part(of_K, 0)}))});
  const Theorem share_A = tautology(
      eq(ceil(N() / 2), K), {instantiate(ceiling_is(), {{x, N() / 2}, {k, K}}), above, below});
  book.show("N_A", "eq:NA-ans", "that is, for A", chain(def_A, share_A));
  // L = ceil(z - 1): 2L - 1 < N < 2L + 2. If N = 2L then N_A = L, if N = 2L + 1 then N_A = L + 1.
  const Expr L = ceil(z - 1);
  const Theorem of_L = ceiling_of(z - 1);
  const Theorem N_from = next_integer(linear(lt(2 * L - 1, N()), {N_up, part(of_L, 1)}));
  const Theorem N_to = next_integer(linear(lt(N(), 2 * L + 2), {N_down, part(of_L, 0)}));
  const auto with_N = [&](Expr value, Expr share) {
    const Theorem is = assume(eq(N(), value));
    const Theorem ceiling =
        tautology(eq(ceil(N() / 2), share),
                  {instantiate(ceiling_is(), {{x, N() / 2}, {k, share}}),
                   linear(lt(share - 1, N() / 2), {is}), linear(le(N() / 2, share), {is})});
    return discharge(is.conclusion(), linear(eq(N_B(), L), {def_A, def_B, is, ceiling}));
  };
  const Theorem more = assume(lt(2 * L, N()));
  const Theorem odd =
      discharge(more.conclusion(), linear(eq(N(), 2 * L + 1), {next_integer(more), N_to}));
  book.show("N_B", "eq:NB-ans", "and for B",
            tautology(eq(N_B(), L), {with_N(2 * L, L), with_N(2 * L + 1, L + 1), odd,
                                     use("equal or less or greater", {{x, N()}, {y, 2 * L}}),
                                     linear(le(2 * L, N()), {N_from})}));
}
}  // namespace

Theorem ceiling_is() {
  static const Theorem result = [] {
    const Theorem ceiling = axiom("ceiling");
    const Theorem is = assume(eq(ceil(x), k));
    const Theorem above = assume(lt(k - 1, x));
    const Theorem below = assume(le(x, k));
    const Theorem forth =
        discharge(is.conclusion(), both({linear(lt(k - 1, x), {is, part(ceiling, 1)}),
                                         linear(le(x, k), {is, part(ceiling, 0)})}));
    const Theorem low = next_integer(linear(lt(k - 1, ceil(x)), {above, part(ceiling, 0)}));
    const Theorem high = next_integer(linear(lt(ceil(x), k + 1), {below, part(ceiling, 1)}));
    const Theorem back = discharge(
        above.conclusion(), discharge(below.conclusion(), linear(is.conclusion(), {low, high})));
    return tautology(iff(is.conclusion(), logic_and({above.conclusion(), below.conclusion()})),
                     {forth, back});
  }();
  return result;
}

void counting(Book& book) {
  book.chapter("counting", "The number of collisions", {alpha_positive, V_positive, le(0, j)});
  book.show("ceiling", "def:ceil", "Rounding up:", ceiling_is());
  book.show("sine_past_pi", "", "The sine from pi to 2 pi:", sine_not_positive());
  number_of_collisions(book, approach_speed(book));
  shares(book);
}
}  // namespace derivation
