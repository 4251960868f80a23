// Cosines and sines of n x as sums of powers, and of (n + r) x: by Pascal's rule.
#include "derivation/symbols.hpp"

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

struct Sums {
  Theorem pow_next(Expr base, Expr e) const { return at(powers[1], {{y, base}, {j, e}}); }
  Theorem choose_next(Expr of, Expr e) const { return at(coefficients[1], {{n, of}, {j, e}}); }
  /// 0 <= j |- choose(n + 1, j + 1) = choose(n, j + 1) + choose(n, j)
  Theorem pascal() const {
    return by_induction(
        j, eq(choose(n + 1, j + 1), choose(n, j + 1) + choose(n, j)),
        {choose_next(n + 1, 0), choose_next(n, 0), at(coefficients[0], {{n, n + 1}}),
         coefficients[0]},
        {choose_next(n + 1, j + 1), choose_next(n, j + 1), choose_next(n, j), assume(j_from_0)});
  }
  /// 0 <= of, of < e |- choose(of, e) = 0
  Theorem none(Expr of, Expr e, const Theorems& facts = {}) const {
    const Theorem beyond = by_induction(j, eq(choose(n, n + 1 + j), 0), {choose_next(n, n)},
                                        {choose_next(n, n + 1 + j)});
    return at(beyond, {{n, of}, {j, e - of - 1}}, facts);
  }
  /// 0 <= n, 0 <= i |- choose(n, i) cos(x)^(n + 1 - i) = choose(n, i) cos(x) cos(x)^(n - i)
  Theorem one_more_cosine() const {
    const Expr l = choose(n, i) * pow(c_x, n + 1 - i), r = choose(n, i) * c_x * pow(c_x, n - i);
    const auto inside = [&](const Theorem& t) {
      return equation(l, r, {at(powers[1], {{y, c_x}, {j, n - i}}, {t})});
    };
    const auto outside = [&](const Theorem& t) { return equation(l, r, {none(n, i, {t})}); };
    return tautology(eq(l, r), {given(le(i, n), inside), given(lt(n, i), outside)});
  }
  const Theorems powers = defined_by_recursion(
      {"pow"}, {y}, j, {j_from_0}, {1}, [](const Exprs& before) { return Exprs{y * before[0]}; });
  const Theorems coefficients = defined_by_recursion(
      {"choose"}, {n}, j, {j_from_0}, {1},
      [](const Exprs& before) { return Exprs{before[0] * (n - j) / (j + 1)}; });
  const Theorems sums =
      defined_by_recursion({"cos_sum", "sin_sum"}, {x, n}, j, {le(0, n), j_from_0},
                           {even(n, 0), odd(n, 0)}, [](const Exprs& before) {
                             return Exprs{before[0] + even(n, j + 1), before[1] + odd(n, j + 1)};
                           });
};

/// 0 <= n, 0 <= j |- the sums for n + 1 from those for n, as the sum of two angles has it.
Theorem one_more_angle(const Sums& s, const Theorem& pascal) {
  const auto coefficient = [&](Expr e) { return at(pascal, {{j, e}}); };
  const Theorem one_more = s.one_more_cosine();
  const auto cosine = [&](Expr e) { return at(one_more, {{i, e}}); };
  const auto sine = [&](Expr e) { return s.pow_next(s_x, e); };
  const Theorem even_term =
      equation(even(n + 1, j + 1), c_x * even(n, j + 1) - s_x * odd(n, j),
               {s.pow_next(-1, j), sine(2 * j + 1), coefficient(2 * j + 1), cosine(2 * j + 2)});
  const Theorem odd_term = equation(odd(n + 1, j), s_x * even(n, j) + c_x * odd(n, j),
                                    {sine(2 * j), coefficient(2 * j), cosine(2 * j + 1)});
  const Theorem even_0 =
      equation(even(n + 1, 0), c_x * even(n, 0),
               {s.pow_next(c_x, n), at(s.coefficients[0], {{n, n + 1}}), s.coefficients[0]});
  Theorems starts{even_0, at(odd_term, {{j, 0}})}, nexts{even_term, at(odd_term, {{j, j + 1}})};
  for (const Expr& of : {n + 1, n})
    for (const std::size_t which : {0U, 1U}) {
      starts.push_back(at(s.sums[which], {{n, of}}));
      nexts.push_back(at(s.sums[which + 2], {{n, of}}));
    }
  return by_induction(
      j,
      logic_and({eq(cos_sum(n + 1, j), c_x * cos_sum(n, j) - s_x * (sin_sum(n, j) - odd(n, j))),
                 eq(sin_sum(n + 1, j), s_x * cos_sum(n, j) + c_x * sin_sum(n, j))}),
      starts, nexts);
}

/// 0 <= n, 0 <= m |- n <= 2m + 1 implies cos(n x) and sin(n x) are the sums up to m.
Theorem sums_are(const Sums& s, const Theorem& one_more) {
  const auto of_0 = [](const Theorem& t) { return at(t, {{n, 0}}); };
  Theorems first{of_0(s.sums[0]), of_0(s.sums[1]), of_0(s.coefficients[0]), s.none(0, 1)};
  for (const Expr& base : {Expr(-1), s_x, c_x}) first.push_back(at(s.powers[0], {{y, base}}));
  const Theorem nothing =
      by_induction(j, logic_and({eq(cos_sum(0, j), 1), eq(sin_sum(0, j), 0)}), first,
                   {of_0(s.sums[2]), of_0(s.sums[3]), s.none(0, 2 * j + 2), s.none(0, 2 * j + 3)});
  const Known m_from_0({assume(le(0, m))});
  const auto at_m = [&](const Theorem& t) { return at(t, {{j, m}}); };
  const auto equal = [](Expr e) {
    return logic_and({eq(cos(e * x), cos_sum(e, m)), eq(sin(e * x), sin_sum(e, m))});
  };
  const auto claim = [&](Expr e) { return imp(le(e, 2 * m + 1), equal(e)); };
  const Theorem base =
      tautology(claim(0), {equation(equal(0), {at_m(nothing), axiom("cos 0"), axiom("sin 0")})});
  return by_induction(n, claim(n), base, [&](const Theorem& known) {
    return given(le(n + 1, 2 * m + 1), [&](const Theorem& room) {
      const Theorem now = tautology(equal(n), {known, linear(le(n, 2 * m + 1), {room})});
      return equation(equal(n + 1), {now, at_m(one_more), s.none(n, 2 * m + 1, {room})},
                      {n * x, x});
    });
  });
}

// Forms without roots, for any field: all velocities from T_m = cos(m psi/2), by doubling m.

Expr T(Expr index) { return fun("T_", {alpha, index}); }
Expr angle(Expr index) { return index * psi() / 2; }
}  // namespace

void multiples(Book& book) {
  book.chapter("multiples", "Multiples of an angle", {le(0, n), le(0, j)});
  const Expr r = real("r");
  const Expr p = n * x, q = r * x;
  book.show("cos_more", "sec:nhx", "Sum of two angles:",
            equation(cos((n + r) * x), cos(p) * cos(q) - sin(p) * sin(q), {}, {p, q}));
  book.show("sin_more", "sec:nhx", "and",
            equation(sin((n + r) * x), sin(p) * cos(q) + cos(p) * sin(q), {}, {p, q}));
  const Sums s;
  book.show("pow", "Powers by recursion,", both(s.powers));
  book.show("choose", "binomial coefficients,", both(s.coefficients));
  book.show("cos_sum", "a sum with those of even index,",
            under({le(0, n), le(2 * j + 2, n)}, both({s.sums[0], s.sums[2]})));
  book.show("sin_sum", "and one with those of odd index.",
            under({le(1, n), le(2 * j + 3, n)}, both({s.sums[1], s.sums[3]})));
  const Theorem pascal = book.show("pascal", "Pascal's rule:", s.pascal());
  const Theorem are = sums_are(s, one_more_angle(s, pascal));
  // With floor(n/2) for the cosine, and floor((n - 1)/2) for the sine, as one more term is 0.
  const auto floor_of = [&](Expr t) { return at(book["constraints.floor"], {{x, t}}); };
  const Theorem half_is = floor_of(n / 2), less_is = floor_of((n - 1) / 2);
  const Expr half = left(half_is), less = left(less_is);
  know(linear(le(0, half), {half_is}));
  book.show("cos", "sec:nx", "The cosine of n x is the first sum, up to n/2,",
            part(at(are, {{m, half}}, {half_is}), 0));
  const Theorem from_1 = assume(n_from_1), from_0 = linear(le(0, n), {from_1});
  know(linear(le(0, less), {less_is, from_1}));
  const Theorem reaches = linear(le(n, 2 * less + 2), {less_is});
  const Theorem longer = part(at(are, {{m, less + 1}}, {reaches}), 1);
  const Theorem zero = cut(from_0, s.none(n, 2 * less + 3, {reaches}));
  const Theorem last = at(s.sums[3], {{j, less}});
  book.show("sin", "sec:nx", "and its sine the second one, up to (n - 1)/2:",
            equation(sin(n * x), sin_sum(n, less), {cut(from_0, longer), last, zero}));
}

void exact_forms(Book& book) {
  book.chapter("exact", "Exact forms", {alpha_positive, le(0, n)});
  const Theorem cos_half = book["rotation.cos_half_psi"];
  const Theorem definition =
      book.define("T_", {alpha, m}, cos(angle(m)), {alpha_positive}, "The cosine of m half-angles");
  const auto T_is = [&](Expr index, Expr term) {
    return restate(eq(T(index), cos(term)), at(definition, {{m, index}}));
  };
  const auto at_index = [&](Expr index) { return T_is(index, angle(index)); };
  const Theorem first = T_is(1, psi() / 2);
  book.show("T_0", "starts with", chain(T_is(0, 0), axiom("cos 0")));
  book.show("T_1", "and", chain(first, book["rotation.cos_half_psi"]));
  const Theorems rules{at_index(m), at_index(m + 1), at_index(2 * m), at_index(2 * m + 1), first};
  const Exprs bases{angle(m), psi() / 2};
  book.show("T_even", "and goes on to twice the index,",
            equation(T(2 * m), 2 * power(T(m), 2) - 1, rules, bases));
  book.show("T_odd",
            "and to one more:", equation(T(2 * m + 1), 2 * T(m) * T(m + 1) - T(1), rules, bases));
  const Expr d = 1 + alpha, last = n + rational(1, 2);
  const Theorem even = T_is(2 * n, n * psi()), odd = T_is(2 * n + 1, last * psi());
  book.show("a", "gives the velocities: of A,",
            equation(a(n), V_CM() * (1 + d * T(2 * n)), {book["power.a"], even, cos_half}));
  book.show("b", "of B,",
            equation(b(n), V_CM() * (1 - d * T(2 * n + 1)), {book["power.b"], odd, cos_half}));
  book.show("c_prime", "and of C, from momentum,",
            equation(c_prime(n), (V - a(n) - b(n)) / alpha,
                     {solved_for(a(n), book["terminal.momentum_Q"])}));
  // c_n needs b_(n-1), by a name of its own.
  const Theorem before = book.define("b_before", {alpha, V, n}, b(n - 1),
                                     {alpha_positive, le(1, n)}, "where before Q_n B has");
  const Expr earlier = left(before);
  book.show(
      "b_before", "that is,",
      equation(earlier, V_CM() * (1 - 2 * T(2 * n) + d * T(2 * n + 1)),
               {before, one_before(book["power.b"]), even, odd, cos_half}, {n * psi(), psi() / 2}));
  book.show("c", "and C after P_n",
            equation(c(n), (V - a(n) - earlier) / alpha,
                     {before, solved_for(a(n), book["terminal.momentum_P"])}));
  const auto at_end = [&](const std::string& name, Expr value, const Theorem& is) {
    book.show(name, name == "a_t" ? "At the end" : "and",
              equation(fun(name, {alpha, V}), value,
                       {book["terminal." + name.substr(0, 1)], is, book["power.V_CM"]}));
  };
  at_end("a_t", V_CM() * (1 + d * T(2 * N_A())), T_is(2 * N_A(), N_A() * psi()));
  at_end("b_t", V_CM() * (1 - d * T(2 * N_B() + 1)),
         T_is(2 * N_B() + 1, (N_B() + rational(1, 2)) * psi()));
}
}  // namespace derivation
