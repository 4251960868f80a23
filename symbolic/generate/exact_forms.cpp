// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/exact_forms.hpp"

#include "derivation/symbols.hpp"

namespace generate {
namespace {
using namespace derivation;
const Expr m = integer("m");
Expr T(Expr index) { return fun("T_", {alpha, index}); }
Expr angle(Expr index) { return index * psi() / 2; }

class Cosines {
public:
  explicit Cosines(const Book& book)
      : cos_half(book["rotation.cos_half_psi"]),
        definition(define("T_", {alpha, m}, cos(angle(m)), 1)) {}
  /// |- T_index = cos(term)
  Theorem at(Expr index, Expr term) const {
    return restate(eq(T(index), cos(term)),
                   instantiate(definition, {{kernel::integer("m"), index}}));
  }
  codegen::Doubling doubling() const {
    const Theorem zero = chain(at(0, 0), axiom("cos 0"));
    const Theorem one = chain(at(1, psi() / 2), cos_half);
    const Theorems names{at(m, angle(m)), at(m + 1, angle(m + 1)), at(2 * m, angle(2 * m)),
                         at(2 * m + 1, angle(2 * m + 1)), at(1, psi() / 2)};
    const Exprs cosines{cos(angle(m + 1)), cos(angle(2 * m)), cos(angle(2 * m + 1))};
    const Theorems rules = names + angles(cosines, {angle(m), psi() / 2});
    return {zero, one, equation(T(2 * m), 2 * power(T(m), 2) - 1, rules),
            equation(T(2 * m + 1), 2 * T(m) * T(m + 1) - T(1), rules)};
  }
  Theorem cos_half, definition;
};
}  // namespace

ExactForms exact_forms(Source& source) {
  const Book& book = source.book;
  const Cosines cosines(book);
  const Theorem mass = assume(alpha_positive);
  const Theorem p1 = positive(1 + alpha, {mass});
  const Theorem cos_positive =
      linear(lt(0, cos(psi() / 2)), {cosines.cos_half, positive(1 / (1 + alpha), {p1})});
  const Expr d = 1 + alpha, last = n + rational(1, 2);
  const auto by_T = [&](Expr l, Expr r, const Theorems& rules) {
    return cancel(eq(l, r), {}, rules + Theorems{cosines.cos_half}, {p1, cos_positive});
  };
  const Theorem T_even = cosines.at(2 * n, n * psi()), T_odd = cosines.at(2 * n + 1, last * psi());
  const Theorem a_n = by_T(a(n), V_CM() * (1 + d * T(2 * n)), {book["power.a"], T_even});
  const Theorem b_n = by_T(b(n), V_CM() * (1 - d * T(2 * n + 1)), {book["power.b"], T_odd});
  // c from momentum.
  const Theorem c_prime_n = equation(
      c_prime(n), (V - a(n) - b(n)) / alpha,
      {linear(eq(a(n), V - b(n) - alpha * c_prime(n)), {book["terminal.momentum_Q"]})}, {mass});
  const Theorem before = define("b_before", {alpha, V, n}, b(n - 1));
  const Expr earlier = before.conclusion().arg(0);
  const Theorem c_n = equation(
      c(n), (V - a(n) - earlier) / alpha,
      {before, linear(eq(a(n), V - b(n - 1) - alpha * c(n)), {book["terminal.momentum_P"]})},
      {mass});
  const Theorem b_earlier = use(discharge(le(0, n), book["power.b"]), {{n, n - 1}},
                                {linear(le(0, n - 1), {assume(le(1, n))})});
  const Expr down = (n - 1 + rational(1, 2)) * psi();
  const Theorem earlier_is =
      by_T(earlier, V_CM() * (1 - 2 * T(2 * n) + d * T(2 * n + 1)),
           Theorems{before, b_earlier, T_even, T_odd} +
               angles({cos(down), cos(last * psi())}, {n * psi(), psi() / 2}));
  const auto from_counts = [&](const std::string& id, Expr left, Expr right, const Theorem& is) {
    return cancel(eq(left, right), {}, {book[id], is, book["power.V_CM"]},
                  {p1, positive(2 + alpha, {mass})});
  };
  const Theorem a_t =
      from_counts("terminal.a", fun("a_t", {alpha, V}), V_CM() * (1 + d * T(2 * N_A())),
                  cosines.at(2 * N_A(), N_A() * psi()));
  const Theorem b_t =
      from_counts("terminal.b", fun("b_t", {alpha, V}), V_CM() * (1 - d * T(2 * N_B() + 1)),
                  cosines.at(2 * N_B() + 1, (N_B() + rational(1, 2)) * psi()));
  const codegen::Doubling all = cosines.doubling();
  const auto taken = [&](const char* id, const Theorem& t) { return source.taken(id, t); };
  return {{taken("exact.T_0", all.at_0), taken("exact.T_1", all.at_1),
           taken("exact.T_even", all.even), taken("exact.T_odd", all.odd)},
          taken("exact.b_before", earlier_is),
          {taken("exact.a", a_n), taken("exact.b", b_n), taken("exact.c", c_n),
           taken("exact.c_prime", c_prime_n)},
          {source.part("cycle.start_vector", 0), source.part("cycle.start_vector", 1),
           source["cycle.c_start"], source.part("cycle.start_vector", 2)},
          {taken("exact.a_t", a_t), taken("exact.b_t", b_t), source.part("terminal.definitions", 2),
           source["evaluators_end.def_rho"]}};
}
}  // namespace generate
