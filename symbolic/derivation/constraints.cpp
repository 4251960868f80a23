// What makes a block's last collision its last; both counts from the whole part of pi/psi and rest.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
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
