// What happens: a collision takes place as long as its two bodies approach. How many there are.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr half_angle(Expr count) { return count * psi() / 2; }

/// The approach speed before collision j, for both kinds alike.
Theorem approach_speed(Book& book) {
  const Theorem definition = book.name(
      "approach", {alpha, V, j}, is_P(j) * (A(j) - C(j)) + is_Q(j) * (C(j) - B(j)),
      {alpha_positive, le(0, j)}, "Before collision j its two bodies approach with the speed");
  const Known n_from_0({assume(le(0, n))});
  const Theorem turns = book["cycle.turns"];
  const Theorems names = parts({book["cycle.names"]});
  const auto in_next_cycle = [&](const std::string& id) { return at(book[id], {{n, n + 1}}); };
  const Theorem even = book.show(
      "approach_P", "that is, before P_(n+1)",
      equation(approach(2 * n), a(n) - c_prime(n),
               {at(definition, {{j, 2 * n}}), part(turns, 0), turned(names[0]), turned(names[2])}));
  const Theorem c_next = restate(eq(C(2 * n + 1), c(n + 1)), turned(in_next_cycle("cycle.name_c")));
  const Theorem waits = restate(eq(B(2 * n + 1), b(n)), in_next_cycle("cycle.B_waits"));
  const Theorem odd =
      book.show("approach_Q", "and before Q_(n+1)",
                equation(approach(2 * n + 1), c(n + 1) - b(n),
                         {at(definition, {{j, 2 * n + 1}}), part(turns, 1), c_next, waits}));

  // Every j is 2m or 2m + 1, m = ceil((j - 1)/2).
  const Expr m = ceil((j - 1) / 2);
  const Expr claim = eq(approach(j), V * sin(half_angle(j + 1)) / sin(psi() / 2));
  const auto here = [&](const Theorem& t, Expr place) {
    return where_equal(j, place, claim, at(t, {{n, m}}));
  };
  const Theorem last = linear(imp(lt(2 * m, j), eq(j, 2 * m + 1)));
  return book.show("speed", "For both kinds it is the same sine:",
                   follows(claim, {here(chain(even, book["power.before_P"]), 2 * m),
                                   here(chain(odd, book["power.before_Q"]), 2 * m + 1), last,
                                   linear(le(2 * m, j))}));
}
/// Collision j takes place as long as its bodies approach: these are j < N.
void takes_place(Book& book) {
  const Expr up_to_j = logic_and({le(0, k), le(k, j)}), before_N = lt(j, N());
  const Theorem is =
      define("takes_place", {alpha, V, j}, all(k, imp(up_to_j, lt(0, approach(k)))), 2);
  book.show("def_takes_place",
            "Collision j takes place if and only if the bodies of each collision up to it approach "
            "before it:",
            under({alpha_positive, V_positive, le(0, j)}, is));
  const Theorem happens = book["counting.happens"], approached = assume(right(is));
  const Theorem early = given(up_to_j, [&](const Theorem& t) {
    return at(part(happens, 0), {{j, k}}, {t, linear(lt(k, N()), {t, assume(before_N)})});
  });
  const Theorem late = given(le(N(), j), [&](const Theorem& t) {
    return at(specialize(approached, N()), {}, {linear(logic_and({le(0, N()), le(N(), j)}), {t})});
  });
  book.show("takes_place", "So collision j takes place if and only if it is one of the first N:",
            tautology(iff(left(is), before_N), {is, discharge(before_N, generalize(k, early)),
                                                discharge(right(is), late), part(happens, 1)}));
}

/// N_A = ceil(pi/psi - 1/2), N_B = ceil(pi/psi - 1) from N_A = ceil(N/2), N_B = N - N_A.
void shares(Book& book) {
  const Exprs domain{alpha_positive, V_positive};
  const Theorem def_A = defined("N_A", {alpha, V}, ceil(N() / 2), domain);
  const Theorem def_B = defined("N_B", {alpha, V}, N() - N_A(), domain);
  book.show("shares", "A takes part in the first, the third, and so on, B in the others:",
            under(domain, both({def_A, def_B})));
  // 1 < pi/psi, so there are two collisions or more, one of each block.
  const Expr z = pi() / psi();
  const Theorem number = book["counting.N"];
  const Theorem enough = scaled(lt(1, z), lt(psi(), pi()), 1 / psi());
  know_for_good(book.show("at_least", "each at least once:",
                          linear(logic_and({le(1, N_A()), le(1, N_B())}),
                                 {def_A, def_B, linear(le(2, N()), {enough, number})})));
  const Theorem N_up = linear(le(2 * z - 1, N()), {number});
  const Theorem N_down = linear(lt(N(), 2 * z), {number});
  // K = ceil(z - 1/2): 2K - 2 < N < 2K + 1, so K - 1 < N/2 <= K.
  const Expr K = ceil(z - rational(1, 2)), L = ceil(z - 1);
  book.show("N_A", "eq:NA-ans", "that is, for A",
            linear(eq(N_A(), K), {def_A, linear(logic_and({le(2 * K - 1, N()), le(N(), 2 * K)}),
                                                {N_up, N_down})}));
  // L = ceil(z - 1): 2L - 1 < N < 2L + 2. If N = 2L then N_A = L, if N = 2L + 1 then N_A = L + 1.
  const Theorem around = linear(logic_and({le(2 * L, N()), le(N(), 2 * L + 1)}), {N_up, N_down});
  book.show("N_B", "eq:NB-ans", "and for B", linear(eq(N_B(), L), {def_A, def_B, around}));
}

// What makes a block's last collision its last; both counts from the whole part of pi/psi and rest.

Expr floor(Expr t) { return fun("floor", {t}); }
Expr sawtooth(Expr t) { return fun("sawtooth", {t}); }

/// The last collision of a block, of which there are `count` = ceil(pi/psi - shift).
struct Last {
  std::string name, label, approach;
  Expr count, shift, before, after;  // angles before and after it, in units of psi
  Expr faster_before, slower_before, faster_after, slower_after;
};
void last_collision(Book& book, const Last& last) {
  const Theorem number = book["counting." + last.name];
  const Expr early = last.before * psi(), late = last.after * psi(), z = pi() / psi();
  know_for_good(book.show(
      last.name + "_angle",
      last.name == "N_A" ? "pi lies between two angles near N_A psi," : "For B it is N_B psi:",
      both({scaled(lt(early, pi()), lt(last.before, z), psi(), {number}),
            scaled(le(pi(), late), le(z, last.after), psi(), {number})})));
  const Theorem sine_before = positive(sin(early));
  const Theorem sine_after = at(at(book["counting.sine_past_pi"], {{x, late}}));
  book.show(last.name + "_sines", last.label + "-simple", "where the sines have different signs,",
            both({sine_before, sine_after}));
  const auto speed = [&](Expr cycles) { return at(book["power." + last.approach], {{n, cycles}}); };
  const Theorem factor = positive(V / sin(psi() / 2));
  book.show(
      last.name + "_last", last.label,
      "so the two bodies approach before the last collision and not after it:",
      both({linear(lt(last.slower_before, last.faster_before),
                   {speed(last.count - 1), times(factor, sine_before)}),
            linear(le(last.faster_after, last.slower_after),
                   {speed(last.count), times(factor, linear(le(0, -sin(late)), {sine_after}))})}));
}

/// floor(x) <= x < floor(x) + 1, and what is left.
void whole_part(Book& book) {
  const Theorem def_floor = book.name("floor", {x}, -ceil(-x), {}, "Rounding down:");
  const Expr bounds = logic_and({le(k, x), lt(x, k + 1)});
  book.show("floor_is", "def:floor", "so that", linear(iff(eq(floor(x), k), bounds), {def_floor}));
  const Theorem rest = book.name("sawtooth", {x}, x - floor(x), {},
                                 "What is left over is the sawtooth function,", "def:sawtooth");
  book.show("sawtooth_range", "def:sawtooth", "which lies between 0 and 1:",
            linear(logic_and({le(0, sawtooth(x)), lt(sawtooth(x), 1)}), {rest, def_floor}));
}

/// With m = floor(pi/psi): the counts are m and m where 0 < sawtooth <= 1/2, else ...
void two_cases(Book& book) {
  const Expr z = pi() / psi(), rest = sawtooth(z);
  const auto at_z = [&](const std::string& id) { return at(book[id], {{x, z}}); };
  const Expr m = floor(z), half = rational(1, 2);
  const Theorems around_z{at_z("constraints.sawtooth"), at_z("constraints.sawtooth_range")};
  const auto rounded = [&](Expr up, Expr value, const Theorem& where) {  // up is ceil(z - shift)
    return linear(eq(up, value), around_z + Theorems{where});
  };
  const auto counts = [&](Expr claim, Expr top, Expr of_A, const Theorem& where) {
    return linear(claim, {book["counting.N_A"], book["counting.N_B"],
                          rounded(ceil(z - half), of_A, where), rounded(ceil(z), top, where)});
  };
  const Expr small = logic_and({lt(0, rest), le(rest, half)});
  book.show("N_A_near", "eq:NANB-ans eq:NANB-ans-txt",
            "If pi/psi is more than a whole number, by one half at most, the counts are equal,",
            counts(logic_and({eq(N_A(), N_B()), eq(N_B(), ceil(z) - 1)}), m + 1, m, assume(small)));
  const Expr claim = logic_and({eq(N_A(), N_B() + 1), eq(N_B() + 1, ceil(z))});
  const auto far = [&](Expr where, Expr top) {
    return given(where, [&](const Theorem& t) { return counts(claim, top, top, t); });
  };
  book.show("N_A_far", "eq:NANB-ans eq:NANB-ans-txt", "and otherwise A has one more:",
            follows(claim, {assume(logic_not(small)), far(eq(rest, 0), m),
                            far(lt(half, rest), m + 1), part(around_z[1], 0)}));
}
}  // namespace

void count(Book& book, const Count& c) {
  const Expr none = le(c.speed(j), 0);
  const Theorem least = define_least(c.name, c.params, j, 0, none);
  restrict_domain(c.name, c.params, logic_and(c.domain));
  book.show("N_least", "N is the least number of collisions after which there is no approach:",
            under(c.domain, least));
  const Expr N = fun(c.name, c.params), K = ceil(c.turns) - 1, end = c.angle(K + 1);
  const Theorem reached = scaled(le(pi(), end), le(0, ceil(c.turns) - c.turns), c.step);
  const Theorem within = scaled(le(end, 2 * pi()), lt(0, c.turns + 1 - ceil(c.turns)), c.step);
  const Theorem K_from_0 = linear(le(0, K), {positive(c.turns)});
  const Theorem at_end = at(at(book["counting.sine_past_pi"], {{x, end}}, {reached}), {}, {within});
  const Theorem at_K =
      tautology(substitute(none, {{j, K}}), {at(c.sign, {{j, K}}, {K_from_0}), at_end});
  const Theorem found = at(least, {{j, K}}, {K_from_0, at_K});
  know(part(found, 0));
  const auto before = [&](Expr i, const Theorem& below) {  // i < K
    const Theorem room = times(linear(lt(0, c.turns - 1 - i), {below}), c.step);
    const Theorem more = positive(c.angle(i + 1));
    return tautology(lt(0, c.speed(i)),
                     {at(c.sign, {{j, i}}), positive(sin(c.angle(i + 1)), {room, more})});
  };
  const Theorem lower = tautology(
      le(K, N),
      {given(lt(N, K), [&](const Theorem& early) { return before(N, early); }), part(found, 1)});
  const Theorem number = book.show("N", "So the number of all collisions is",
                                   linear(eq(N, K), {lower, part(found, 2)}));
  const auto goes_on = [&](const Theorem& below) {
    return before(j, linear(lt(j, K), {below, number}));
  };
  book.show("happens",
            "They are collisions 0 to N - 1, and no body approaches another after the last:",
            both({given(lt(j, N), goes_on), part(found, 1)}));
}
void counting(Book& book) {
  book.chapter("counting", "The number of collisions", {alpha_positive, V_positive, le(0, j)});
  book.show("ceiling", "def:ceil",
            "Rounding up:", linear(iff(eq(ceil(x), k), logic_and({lt(k - 1, x), le(x, k)}))));
  const Theorem from_pi = assume(le(pi(), x)), to_end = assume(le(x, 2 * pi()));
  const Theorem back = equation(sin(x), -sin(x - pi()), {}, {x - pi(), pi()});
  const Theorem past_pi =
      linear(le(sin(x), 0), {back, sine_not_negative(x - pi(), {from_pi, to_end})});
  book.show("sine_past_pi", "The sine from pi to 2 pi:",
            discharge(from_pi.conclusion(), discharge(to_end.conclusion(), past_pi)));
  const Theorem speed = approach_speed(book);
  const Expr sine = sin(half_angle(j + 1));
  const Theorem sign =
      book.show("approaches", "So they approach if and only if a sine is positive:",
                same_sign(iff(lt(0, approach(j)), lt(0, sine)), V / sin(psi() / 2), {speed}));
  const Exprs domain{alpha_positive, V_positive};
  count(book, {"N", {alpha, V}, domain, approach, half_angle, psi(), 2 * pi() / psi(), sign});
  takes_place(book);
  shares(book);
}

void constraints(Book& book) {
  book.chapter("constraints", "The last collisions", {alpha_positive, V_positive});
  const Expr half = rational(1, 2);
  last_collision(book, {"N_A", "eq:NA-constraint", "before_P", N_A(), half, N_A() - half,
                        N_A() + half, a(N_A() - 1), c_prime(N_A() - 1), a(N_A()), c_prime(N_A())});
  last_collision(book, {"N_B", "eq:NB-constraint", "before_Q", N_B(), 1, N_B(), N_B() + 1, c(N_B()),
                        b(N_B() - 1), c(N_B() + 1), b(N_B())});
  whole_part(book);
  two_cases(book);
}
}  // namespace derivation
