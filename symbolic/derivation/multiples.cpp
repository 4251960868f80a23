// SPDX-License-Identifier: GPL-2.0-or-later
// Cosines and sines of n x as sums of powers, and of (n + r) x: by Pascal's rule.
#include "derivation/symbols.hpp"
#include "kernel/polynomial.hpp"

namespace derivation {
namespace {
const Expr i = integer("i"), m = integer("m");
const Expr c_x = cos(x), s_x = sin(x);
Expr pow(Expr base, Expr e) { return fun("pow", {base, e}); }
Expr choose(Expr of, Expr e) { return fun("choose", {of, e}); }
Expr cos_sum(Expr of, Expr last) { return fun("cos_sum", {x, of, last}); }
Expr sin_sum(Expr of, Expr last) { return fun("sin_sum", {x, of, last}); }
Expr term(Expr of, Expr index, Expr sign_of) {
  const Expr e = kernel::canonical(index), rest = kernel::canonical(of - index);
  return pow(-1, sign_of) * choose(of, e) * pow(s_x, e) * pow(c_x, rest);
}
Expr even(Expr of, Expr e) { return term(of, 2 * e, e); }
Expr odd(Expr of, Expr e) { return term(of, 2 * e + 1, e); }

/// Both equations of a conjunction.
Theorem each(Expr f, const Theorems& rules) {
  return both({equation(f.arg(0), rules), equation(f.arg(1), rules)});
}
class Sums {
public:
  explicit Sums(Book& the_book) : book(the_book) {}
  void show_definitions() {
    book.show("pow", "Powers by recursion,", both(powers));
    book.show("choose", "binomial coefficients,", both(coefficients));
    const auto start = [&](std::size_t which) { return sums[which]; };
    book.show("cos_sum", "a sum with those of even index,",
              under({le(0, n), le(2 * j + 2, n)}, both({start(0), start(2)})));
    book.show("sin_sum", "and one with those of odd index.",
              under({le(1, n), le(2 * j + 3, n)}, both({start(1), start(3)})));
  }
  Theorem pow_next(Expr base, Expr e, const Theorem& e_from_0) const {
    return use(powers[1], {{y, base}, {j, e}}, {e_from_0});
  }
  Theorem choose_next(Expr of, Expr e, const Theorem& e_from_0) const {
    return use(coefficients[1], {{n, of}, {j, e}}, {e_from_0});
  }
  /// 0 <= j |- choose(n + 1, j + 1) = choose(n, j + 1) + choose(n, j)
  Theorem pascal() const {
    const auto claim = [](Expr e) {
      return eq(choose(n + 1, e + 1), choose(n, e + 1) + choose(n, e));
    };
    const Theorem zero = linear(le(0, 0), {});
    const auto at_0 = [&](Expr of) { return instantiate(coefficients[0], {{n, of}}); };
    const Theorem base = equation(
        claim(0), {choose_next(n + 1, 0, zero), choose_next(n, 0, zero), at_0(n + 1), at_0(n)});
    return by_induction(j, claim(j), base, [&](const Theorem& from, const Theorem& known) {
      return equation(claim(j + 1), {choose_next(n + 1, j + 1, from), choose_next(n, j + 1, from),
                                     known, choose_next(n, j, from), from});
    });
  }
  /// 0 <= n |- n + 1 <= j implies choose(n, j) = 0
  Theorem none() const {
    const Expr claim = eq(choose(n, j), 0), first = n + 1,
               premise = logic_and({le(first, j), claim});
    const Theorem n_from_0 = assume(le(0, n)), known = assume(premise);
    const Theorem base = equation(choose(n, first), 0, {choose_next(n, n, n_from_0)});
    const Theorem from = linear(le(0, j), {n_from_0, part(known, 0)});
    const Theorem next = equation(choose(n, j + 1), 0, {choose_next(n, j, from), part(known, 1)});
    return induction(j, first, claim, base, discharge(premise, next));
  }
  /// 0 <= n, 0 <= i |- choose(n, i) cos(x)^(n + 1 - i) = choose(n, i) cos(x) cos(x)^(n - i)
  Theorem one_more_cosine(const Theorem& vanishes) const {
    const Expr l = choose(n, i) * pow(c_x, n + 1 - i), r = choose(n, i) * c_x * pow(c_x, n - i);
    const Theorem inside = assume(le(i, n)), outside = assume(lt(n, i));
    const Theorem power_step = pow_next(c_x, n - i, linear(le(0, n - i), {inside}));
    const Theorem zero = use(vanishes, {{j, i}}, {next_integer(outside)});
    return tautology(eq(l, r), {discharge(inside.conclusion(), equation(l, r, {power_step})),
                                discharge(outside.conclusion(), equation(l, r, {zero}))});
  }
  Book& book;
  const Expr from_0 = le(0, j);
  const Theorems powers = defined_by_recursion(
      {"pow"}, {y}, j, {from_0}, {1}, [](const Exprs& before) { return Exprs{y * before[0]}; });
  const Theorems coefficients = defined_by_recursion(
      {"choose"}, {n}, j, {from_0}, {1},
      [](const Exprs& before) { return Exprs{before[0] * (n - j) / (j + 1)}; });
  const Theorems sums =
      defined_by_recursion({"cos_sum", "sin_sum"}, {x, n}, j, {le(0, n), from_0},
                           {even(n, 0), odd(n, 0)}, [](const Exprs& before) {
                             return Exprs{before[0] + even(n, j + 1), before[1] + odd(n, j + 1)};
                           });
};

/// 0 <= n, 0 <= j |- the sums for n + 1 from those for n, as the sum of two angles has it.
Theorem one_more_angle(const Sums& s, const Theorem& pascal, const Theorem& vanishes) {
  const Theorem from = assume(le(0, j)), n_from_0 = assume(le(0, n));
  const Theorem one_more = s.one_more_cosine(vanishes);
  const auto coefficient = [&](Expr e) { return at(pascal, {{j, e}}, {from}); };
  const auto cosine = [&](Expr e) { return at(one_more, {{i, e}}, {from}); };
  const auto sine = [&](Expr e) { return s.pow_next(s_x, e, from); };
  const Theorem even_term = equation(
      even(n + 1, j + 1), c_x * even(n, j + 1) - s_x * odd(n, j),
      {s.pow_next(-1, j, from), sine(2 * j + 1), coefficient(2 * j + 1), cosine(2 * j + 2)});
  const Theorem odd_term = equation(odd(n + 1, j), s_x * even(n, j) + c_x * odd(n, j),
                                    {sine(2 * j), coefficient(2 * j), cosine(2 * j + 1)});
  const auto claim = [](Expr e) {
    return logic_and(
        {eq(cos_sum(n + 1, e), c_x * cos_sum(n, e) - s_x * (sin_sum(n, e) - odd(n, e))),
         eq(sin_sum(n + 1, e), s_x * cos_sum(n, e) + c_x * sin_sum(n, e))});
  };
  const auto start = [&](std::size_t which, Expr of) {
    return instantiate(s.sums[which], {{n, of}});
  };
  const auto next = [&](std::size_t which, Expr of) {
    return use(s.sums[which + 2], {{n, of}}, {from});
  };
  const Theorems starts{start(0, n + 1), start(0, n), start(1, n + 1), start(1, n)};
  const Theorem even_0 =
      equation(even(n + 1, 0), c_x * even(n, 0),
               {s.pow_next(c_x, n, n_from_0), instantiate(s.coefficients[0], {{n, n + 1}}),
                s.coefficients[0]});
  const Theorem base = each(claim(0), starts + Theorems{even_0, at(odd_term, {{j, 0}})});
  return by_induction(j, claim(j), base, [&](const Theorem&, const Theorem& known) {
    const Theorem odd_next = at(odd_term, {{j, j + 1}}, {from});
    const Theorems rules{next(0, n + 1), next(1, n + 1), next(0, n), next(1, n),
                         known,          even_term,      odd_next};
    return each(claim(j + 1), rules);
  });
}

/// 0 <= n, 0 <= m |- n <= 2m + 1 implies cos(n x) and sin(n x) are the sums up to m.
Theorem sums_are(const Sums& s, const Theorem& one_more, const Theorem& vanishes) {
  const auto none = [&](Expr of, Expr e, const Theorems& facts, const Theorem& of_from_0) {
    return use(at(vanishes, {{n, of}, {j, e}}, {of_from_0}), {}, facts + Theorems{of_from_0});
  };
  const Theorem zero = linear(le(0, 0), {});
  const auto at_none = [](Expr e) {
    return logic_and({eq(cos_sum(0, e), 1), eq(sin_sum(0, e), 0)});
  };
  Theorems first{instantiate(s.sums[0], {{n, 0}}), instantiate(s.sums[1], {{n, 0}}),
                 instantiate(s.coefficients[0], {{n, 0}}), none(0, 1, {}, zero)};
  for (const Expr& base : {Expr(-1), s_x, c_x})
    first.push_back(instantiate(s.powers[0], {{y, base}}));
  const Theorem nothing = by_induction(j, at_none(j), each(at_none(0), first),
                                       [&](const Theorem& from, const Theorem& known) {
                                         const Theorems rules{use(s.sums[2], {{n, 0}}, {from}),
                                                              use(s.sums[3], {{n, 0}}, {from}),
                                                              part(known, 0),
                                                              part(known, 1),
                                                              none(0, 2 * j + 2, {from}, zero),
                                                              none(0, 2 * j + 3, {from}, zero)};
                                         return each(at_none(j + 1), rules);
                                       });
  const Theorem m_from_0 = assume(le(0, m));
  const auto at_m = [&](const Theorem& t) { return at(t, {{j, m}}, {m_from_0}); };
  const auto equal = [](Expr e) {
    return logic_and({eq(cos(e * x), cos_sum(e, m)), eq(sin(e * x), sin_sum(e, m))});
  };
  const auto claim = [&](Expr e) { return imp(le(e, 2 * m + 1), equal(e)); };
  const Theorem none_at_m = at_m(nothing);
  const Theorem base =
      tautology(claim(0), {each(equal(0), {none_at_m, axiom("cos 0"), axiom("sin 0")})});
  return by_induction(n, claim(n), base, [&](const Theorem& from, const Theorem& known) {
    const Theorem room = assume(le(n + 1, 2 * m + 1));
    const Theorem now = tautology(equal(n), {known, linear(le(n, 2 * m + 1), {room})});
    const Theorem next = at_m(one_more);
    const Theorems rules = angles({cos((n + 1) * x), sin((n + 1) * x)}, {n * x, x}, false) +
                           Theorems{now, next, none(n, 2 * m + 1, {room}, from)};
    return discharge(room.conclusion(), each(equal(n + 1), rules));
  });
}
}  // namespace

void multiples(Book& book) {
  book.chapter("multiples", "Multiples of an angle", {le(0, n), le(0, j)});
  const Expr r = real("r");
  book.show("cos_more", "sec:nhx", "Sum of two angles:",
            equation(cos((n + r) * x), cos(n * x) * cos(r * x) - sin(n * x) * sin(r * x), {},
                     {n * x, r * x}));
  book.show("sin_more", "sec:nhx", "and",
            equation(sin((n + r) * x), sin(n * x) * cos(r * x) + cos(n * x) * sin(r * x), {},
                     {n * x, r * x}));
  Sums s(book);
  s.show_definitions();
  const Theorem pascal = book.show("pascal", "Pascal's rule:", s.pascal());
  const Theorem vanishes = s.none();
  const Theorem are = sums_are(s, one_more_angle(s, pascal, vanishes), vanishes);
  // With floor(n/2) for the cosine, and floor((n - 1)/2) for the sine, as one more term is 0.
  const auto up_to = [&](Expr last, const Theorem& last_from_0, const Theorems& facts) {
    return use(at(are, {{m, last}}, {last_from_0}), {}, facts);
  };
  const auto floor_of = [&](Expr t) { return instantiate(book["constraints.floor"], {{x, t}}); };
  const Theorem half_is = floor_of(n / 2), less_is = floor_of((n - 1) / 2);
  const Theorem from_0 = assume(le(0, n)), from_1 = assume(le(1, n));
  const Expr half = left(half_is), less = left(less_is);
  const Theorem half_from_0 = linear(le(0, half), {half_is, from_0});
  know(half_from_0);
  book.show("cos", "sec:nx", "The cosine of n x is the first sum, up to n/2,",
            part(up_to(half, half_from_0, {half_is}), 0));
  const Theorem less_from_0 = linear(le(0, less), {less_is, from_1});
  const Theorem reaches = linear(le(n, 2 * less + 2), {less_is});
  const Theorem n_from_0 = linear(le(0, n), {from_1});
  const Theorem longer = part(up_to(less + 1, less_from_0, {reaches}), 1);
  const Theorem zero = use(cut(n_from_0, vanishes), {{j, 2 * less + 3}}, {reaches});
  const Theorem last = use(s.sums[3], {{j, less}}, {less_from_0});
  know(less_from_0);
  book.show("sin", "sec:nx", "and its sine the second one, up to (n - 1)/2:",
            equation(sin(n * x), sin_sum(n, less), {cut(n_from_0, longer), last, zero}));
}
}  // namespace derivation
