// Forms without roots, for any field: all velocities from T_m = cos(m psi/2), by doubling m.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
const Expr m = integer("m");
Expr T(Expr index) { return fun("T_", {alpha, index}); }
Expr angle(Expr index) { return index * psi() / 2; }
}  // namespace

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
