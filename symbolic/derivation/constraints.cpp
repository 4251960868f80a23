// SPDX-License-Identifier: GPL-2.0-or-later
// What makes the last collision of a block its last one; both counts from the whole part of pi/psi
// and the rest.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr floor(Expr t) { return fun("floor", {t}); }
Expr sawtooth(Expr t) { return fun("sawtooth", {t}); }
Expr quotient() { return pi() / psi(); }

/// The last collision of a block, of which there are `count` = ceil(pi/psi - shift).
struct Last {
  std::string name, label, approach;
  Expr count, shift, before, after;  // angles before and after it, in units of psi
  Expr faster_before, slower_before, faster_after, slower_after;
};
void last_collision(Book& book, const Last& last) {
  const Theorem number = book["counting." + last.name];
  const Theorem rounded = use("ceiling", {{x, quotient() - last.shift}});
  const Theorem psi_positive = part(book["rotation.psi_range"], 0);
  const Theorem psi_below = part(book["rotation.psi_range"], 1);
  const Theorem per = equation(psi() * quotient(), pi(), {}, {psi_positive});
  const auto scaled = [&](Expr goal, const Theorem& relation) {
    return linear(goal, {times(relation, psi_positive), per});
  };
  const Expr early = last.before * psi(), late = last.after * psi();
  const Theorem below =
      scaled(lt(early, pi()), linear(lt(0, quotient() - last.before), {part(rounded, 1), number}));
  const Theorem reached =
      scaled(le(pi(), late), linear(le(0, last.after - quotient()), {part(rounded, 0), number}));
  book.show(
      last.name + "_angle", "",
      last.name == "N_A" ? "pi lies between two angles near N_A psi," : "For B it is N_B psi:",
      both({below, reached}));
  const Theorem count_from_1 = part(book["counting.at_least"], last.name == "N_A" ? 0 : 1);
  const Theorem above_0 = scaled(lt(0, early), linear(lt(0, last.before), {count_from_1}));
  const Theorem to_end = linear(le(late, 2 * pi()), {below, psi_below, positive(pi())});
  const Theorem sine_before = use("sin positive", {{x, early}}, {above_0, below});
  const Theorem sine_after = tautology(
      le(sin(late), 0), {instantiate(book["counting.sine_past_pi"], {{x, late}}), reached, to_end});
  book.show(last.name + "_sines", last.label + "-simple", "where the sines have different signs,",
            both({sine_before, sine_after}));
  const auto speed = [&](Expr cycles) {
    return use(discharge(le(0, n), book["power." + last.approach]), {{n, cycles}},
               {linear(le(0, cycles), {count_from_1})});
  };
  const Theorem sine_half = part(book["rotation.half_signs"], 0);
  const Theorem factor = times(assume(V_positive), positive(1 / sin(psi() / 2), {sine_half}));
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
  const Theorem def_floor = define("floor", {x}, -ceil(-x), 0);
  book.show("floor", "", "Rounding down:", def_floor);
  const Theorem ceiling = instantiate(ceiling_is(), {{x, -x}, {k, -k}});
  const Expr is_k = eq(floor(x), k), upper = lt(x, k + 1), lower = le(k, x);
  const auto same = [](Expr f, Expr g) {
    return both({discharge(f, linear(g, {assume(f)})), discharge(g, linear(f, {assume(g)}))});
  };
  const auto same_by_floor = [&](Expr f, Expr g) {
    return both({discharge(f, linear(g, {assume(f), def_floor})),
                 discharge(g, linear(f, {assume(g), def_floor}))});
  };
  const Expr meaning = ceiling.conclusion().arg(1);
  book.show("floor_is", "def:floor", "so that",
            tautology(iff(is_k, logic_and({lower, upper})),
                      {ceiling, same_by_floor(is_k, ceiling.conclusion().arg(0)),
                       same(upper, meaning.arg(0)), same(lower, meaning.arg(1))}));
  const Theorem rest = define("sawtooth", {x}, x - floor(x), 0);
  book.show("sawtooth", "def:sawtooth", "What is left over is the sawtooth function,", rest);
  const Theorem rounded = use("ceiling", {{x, -x}});
  book.show("sawtooth_range", "def:sawtooth", "which lies between 0 and 1:",
            both({linear(le(0, sawtooth(x)), {rest, def_floor, part(rounded, 0)}),
                  linear(lt(sawtooth(x), 1), {rest, def_floor, part(rounded, 1)})}));
}

/// With m = floor(pi/psi): the counts are m and m where 0 < sawtooth <= 1/2, else ...
void two_cases(Book& book) {
  const Expr z = quotient(), m = floor(z), rest = sawtooth(z);
  const auto at_z = [&](const std::string& id) { return instantiate(book[id], {{x, z}}); };
  const Theorem split = at_z("constraints.sawtooth");
  const Theorem range = at_z("constraints.sawtooth_range");
  const Theorem from_0 = part(range, 0), below_1 = part(range, 1);
  const auto ceiling = [&](Expr shift, Expr value, const Theorems& facts) {  // ceil(z - shift)
    const Expr t = shift == Expr(0) ? z : z - shift;
    return tautology(eq(ceil(t), value), {instantiate(ceiling_is(), {{x, t}, {k, value}}),
                                          linear(lt(value - 1, t), Theorems{split} + facts),
                                          linear(le(t, value), Theorems{split} + facts)});
  };
  const Expr small = logic_and({lt(0, rest), le(rest, rational(1, 2))});
  const Theorem near = assume(small);
  const Theorems near_facts{part(near, 0), part(near, 1), below_1};
  const Theorem A_near = chain(book["counting.N_A"], ceiling(rational(1, 2), m, near_facts));
  const Theorem B_near = chain(book["counting.N_B"], ceiling(1, m, near_facts));
  const Theorem up_near = ceiling(0, m + 1, near_facts);
  book.show("N_A_near", "eq:NANB-ans eq:NANB-ans-txt",
            "If pi/psi is more than a whole number, by one half at most, the counts are equal,",
            both({linear(eq(N_A(), N_B()), {A_near, B_near}),
                  linear(eq(N_B(), ceil(z) - 1), {B_near, up_near})}));
  const Expr claim = logic_and({eq(N_A(), N_B() + 1), eq(N_B() + 1, ceil(z))});
  const auto far = [&](const Theorem& facts, Expr top) {
    const Theorems all{facts, from_0, below_1};
    const Theorem A_far = chain(book["counting.N_A"], ceiling(rational(1, 2), top, all));
    const Theorem B_far = chain(book["counting.N_B"], ceiling(1, top - 1, all));
    return discharge(facts.conclusion(),
                     both({linear(claim.arg(0), {A_far, B_far}),
                           linear(claim.arg(1), {B_far, ceiling(0, top, all)})}));
  };
  const Theorem none = assume(eq(rest, 0)), much = assume(lt(rational(1, 2), rest));
  book.show("N_A_far", "eq:NANB-ans eq:NANB-ans-txt", "and otherwise A has one more:",
            tautology(claim, {assume(logic_not(small)), far(none, m), far(much, m + 1), from_0,
                              use("equal or less or greater", {{x, 0}, {y, rest}}),
                              discharge(eq(0, rest), turned(assume(eq(0, rest))))}));
}
}  // namespace

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
