// SPDX-License-Identifier: GPL-2.0-or-later
// Forms without roots, for any field: all velocities from T_m = cos(m psi/2), which is found by
// doubling the index.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
const Expr m = integer("m");
Expr T(Expr index) { return fun("T_", {alpha, index}); }
Expr angle(Expr index) { return index * psi() / 2; }

/// |- T_index = cos(term)
Theorem cosine_at(const Theorem& definition, Expr index, Expr term) {
  return restate(eq(T(index), cos(term)), instantiate(definition, {{m, index}}));
}
void doubling(Book& book, const Theorem& definition) {
  const auto at = [&](Expr index) { return cosine_at(definition, index, angle(index)); };
  const Theorem first = cosine_at(definition, 1, psi() / 2);
  book.show("T_0", "", "starts with",
            under({alpha_positive}, chain(cosine_at(definition, 0, 0), axiom("cos 0"))));
  book.show("T_1", "", "and", chain(first, book["rotation.cos_half_psi"]));
  const Exprs cosines{cos(angle(m + 1)), cos(angle(2 * m)), cos(angle(2 * m + 1))};
  const Theorems rules{at(m), at(m + 1), at(2 * m), at(2 * m + 1), first};
  const Theorems all_rules = rules + angles(cosines, {angle(m), psi() / 2});
  const Exprs domain{alpha_positive};
  book.show("T_even", "", "and goes on to twice the index,",
            under(domain, equation(T(2 * m), 2 * power(T(m), 2) - 1, all_rules)));
  book.show("T_odd", "", "and to one more:",
            under(domain, equation(T(2 * m + 1), 2 * T(m) * T(m + 1) - T(1), all_rules)));
}
}  // namespace

void exact_forms(Book& book) {
  book.chapter("exact", "Exact forms", {alpha_positive, le(0, n)});
  const Theorem mass = assume(alpha_positive);
  const Theorem p1 = positive(1 + alpha, {mass});
  const Theorem cos_half = book["rotation.cos_half_psi"];
  const Theorem definition = define("T_", {alpha, m}, cos(angle(m)), 1);
  restrict_domain("T_", {alpha, m}, alpha_positive);
  book.show("def_T_", "", "The cosine of m half-angles", under({alpha_positive}, definition));
  doubling(book, definition);

  const Theorem cos_positive =
      linear(lt(0, cos(psi() / 2)), {cos_half, positive(1 / (1 + alpha), {p1})});
  const Expr d = 1 + alpha;
  const Expr last = n + rational(1, 2);
  const auto by_T = [&](Expr l, Expr r, const Theorems& rules) {
    return equation(l, r, rules + Theorems{cos_half}, {p1, cos_positive});
  };
  const auto T_is = [&](Expr index, Expr term) { return cosine_at(definition, index, term); };
  const Theorem even = T_is(2 * n, n * psi());
  const Theorem odd = T_is(2 * n + 1, last * psi());
  book.show("a", "", "gives the velocities: of A,",
            by_T(a(n), V_CM() * (1 + d * T(2 * n)), {book["power.a"], even}));
  book.show("b", "", "of B,", by_T(b(n), V_CM() * (1 - d * T(2 * n + 1)), {book["power.b"], odd}));
  book.show(
      "c_prime", "", "and of C, from momentum,",
      equation(c_prime(n), (V - a(n) - b(n)) / alpha,
               {linear(eq(a(n), V - b(n) - alpha * c_prime(n)), {book["terminal.momentum_Q"]})},
               {mass}));
  // c_n needs b_(n-1), by a name of its own.
  const Theorem before = define("b_before", {alpha, V, n}, b(n - 1), 2);
  const Exprs domain{alpha_positive, le(1, n)};
  restrict_domain("b_before", {alpha, V, n}, logic_and(domain));
  book.show("def_b_before", "", "where before Q_n B has", under(domain, before));
  const Expr earlier = before.conclusion().arg(0);
  const Theorem b_earlier = use(discharge(le(0, n), book["power.b"]), {{n, n - 1}},
                                {linear(le(0, n - 1), {assume(le(1, n))})});
  const Expr down = (n - 1 + rational(1, 2)) * psi();
  book.show("b_before", "", "that is,",
            by_T(earlier, V_CM() * (1 - 2 * T(2 * n) + d * T(2 * n + 1)),
                 Theorems{before, b_earlier, even, odd} +
                     angles({cos(down), cos(last * psi())}, {n * psi(), psi() / 2})));
  book.show("c", "", "and C after P_n",
            equation(c(n), (V - a(n) - earlier) / alpha,
                     {before,
                      linear(eq(a(n), V - b(n - 1) - alpha * c(n)), {book["terminal.momentum_P"]})},
                     {mass}));
  const auto at_end = [&](const std::string& name, Expr right, const Theorem& is) {
    book.show(name, "", name == "a_t" ? "At the end" : "and",
              equation(fun(name, {alpha, V}), right,
                       {book["terminal." + name.substr(0, 1)], is, book["power.V_CM"]},
                       {p1, positive(2 + alpha, {mass})}));
  };
  at_end("a_t", V_CM() * (1 + d * T(2 * N_A())), T_is(2 * N_A(), N_A() * psi()));
  at_end("b_t", V_CM() * (1 - d * T(2 * N_B() + 1)),
         T_is(2 * N_B() + 1, (N_B() + rational(1, 2)) * psi()));
}
}  // namespace derivation
