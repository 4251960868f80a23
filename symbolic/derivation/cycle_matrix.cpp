// SPDX-License-Identifier: GPL-2.0-or-later
// What each collision keeps, and the matrix Lambda of a cycle: V_n = Lambda V_(n-1).
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
const Expr M = real("M"), M_1 = real("M_1"), M_2 = real("M_2");
const Expr u_1 = real("u_1"), u_2 = real("u_2");

void conservation(Book& book, const Theorems& steps) {
  const Expr s = sqrt(alpha);
  const auto proved = [&](Expr goal) { return equation(goal, steps); };
  const auto energy = [&](Expr block, Expr ball) { return power(block, 2) + power(s * ball, 2); };
  book.show("momentum_P", "eq:conservation eq:ac", "P_n keeps momentum (over M)",
            proved(eq(a(n - 1) + alpha * c_prime(n - 1), a(n) + alpha * c(n))));
  const Theorem energy_P =
      book.show("energy_P", "eq:Euc-Pn", "and energy (over M/2);",
                proved(eq(energy(a(n - 1), c_prime(n - 1)), energy(a(n), c(n)))));
  book.show("momentum_Q", "eq:bcp", "Q_n keeps momentum",
            proved(eq(b(n - 1) + alpha * c(n), b(n) + alpha * c_prime(n))));
  const Theorem energy_Q = book.show("energy_Q", "eq:Euc-Qn", "and energy,",
                                     proved(eq(energy(b(n - 1), c(n)), energy(b(n), c_prime(n)))));
  book.show("energy", "eq:energy-conservation-PnQn", "and so does the whole cycle:",
            linear(eq(power(a(n - 1), 2) + power(b(n - 1), 2) + power(s * c_prime(n - 1), 2),
                      power(a(n), 2) + power(b(n), 2) + power(s * c_prime(n), 2)),
                   {energy_P, energy_Q}));
  book.show("relative_P", "eq:Euc-Pn-linear", "The relative velocity turns round at P_n",
            proved(eq(a(n - 1) - c_prime(n - 1), -a(n) + c(n))));
  book.show("relative_Q", "eq:Euc-Qn-linear",
            "and at Q_n:", proved(eq(b(n - 1) - c(n), -b(n) + c_prime(n))));
}

/// No other motion obeys the law: velocities v that a collision of the kind leads to are the next
/// ones.
void uniqueness(Book& book) {
  const Theorem general = both({book["contact.v_1"], book["contact.v_2"]});
  const Theorem block = assume(lt(0, M));
  const Theorem ball = positive(alpha * M, {block});
  const auto only = [&](Expr u, Expr w, const Theorem& next) {
    const Theorem special =
        cut(ball, instantiate(general, {{M_1, M}, {M_2, alpha * M}, {u_1, u}, {u_2, w}}));
    const auto same = [&](std::size_t i) {
      const Theorem t = part(special, i);
      const Theorem value = part(next, i);
      return chain(t, equation(right(t), left(value), {value, block}));
    };
    return both({same(0), same(1)});
  };
  book.show("only_P", "The law allows no other velocities after P_n",
            only(a(n - 1), c_prime(n - 1), book["cycle.P"]));
  book.show("only_Q", "or after Q_n:", only(b(n - 1), c(n), book["cycle.Q"]));
}
}  // namespace

void cycle_matrix(Book& book) {
  const Expr s = sqrt(alpha);
  const Theorems steps{book["cycle.P"], book["cycle.Q"]};
  conservation(book, parts(steps));
  uniqueness(book);

  const Theorem gamma = book["ball.Gamma"];
  const Theorems moved = steps + Theorems{gamma};
  const auto entry_of_gamma = [](int row, int col) { return entry(Gamma(), row, col); };
  book.show("at_P", "eq:abc-n", "In terms of Gamma,",
            matrix_equation(column({a(n), s * c(n)}),
                            times(Gamma(), column({a(n - 1), s * c_prime(n - 1)})), moved));
  book.show("at_Q", "eq:abcp-n", "and",
            matrix_equation(column({b(n), s * c_prime(n)}),
                            times(Gamma(), column({b(n - 1), s * c(n)})), moved));
  const Exprs domain{alpha_positive};
  const Theorem of_P =
      book.name("Gamma_A", {alpha},
                matrix(3, {entry_of_gamma(0, 0), 0, entry_of_gamma(0, 1), 0, 1, 0,
                           entry_of_gamma(1, 0), 0, entry_of_gamma(1, 1)}),
                domain, "For all three velocities the collision at P_n leaves B alone,");
  const Theorem of_Q = book.name("Gamma_B", {alpha},
                                 matrix(3, {1, 0, 0, 0, entry_of_gamma(0, 0), entry_of_gamma(0, 1),
                                            0, entry_of_gamma(1, 0), entry_of_gamma(1, 1)}),
                                 domain, "and that at Q_n leaves A alone:");
  const Expr whole = simplified(times(right(of_Q), right(of_P)));
  Expr in_alpha = whole;
  for (int row = 0; row < 2; ++row)
    for (int col = 0; col < 2; ++col)
      in_alpha = replace(in_alpha, entry_of_gamma(row, col), entry(right(gamma), row, col));
  const Theorem of_cycle =
      book.name("Lambda", {alpha}, simplified(in_alpha), domain, "Multiplied out, a cycle is");
  const Theorems all_rules{of_cycle, of_P, of_Q, gamma};
  book.show("Lambda_product", "eq:Lam-G-G Lam-GAM", "the product of both,",
            matrix_equation(Lambda(), times(Gamma_B(), Gamma_A()), all_rules));
  const Expr d = 1 + alpha, less = 1 - alpha, d2 = power(1 + alpha, 2);
  book.show("Lambda_paper", "eq:Lambda", "as the paper writes it:",
            matrix_equation(
                Lambda(),
                matrix(3, {less / d, 0, 2 * s / d, 4 * alpha / d2, less / d, -2 * less * s / d2,
                           -2 * less * s / d2, 2 * s / d, power(less, 2) / d2}),
                all_rules));
  const Expr ct = cos(theta()), st = sin(theta());
  book.show(
      "Lambda_theta", "eq:Lambda-app", "In terms of theta,",
      matrix_equation(
          Lambda(), matrix(3, {ct, 0, st, power(st, 2), ct, -st * ct, -st * ct, st, power(ct, 2)}),
          all_rules + Theorems{book["ball.cos_theta"], book["ball.sin_theta"]}));
  const Theorem vector =
      book.name("V_", {alpha, V, n}, column({a(n), b(n), s * c_prime(n)}),
                {alpha_positive, le(0, n)}, "The velocities as a vector:", "def:Vn", "vector");
  const Theorems vectors{vector, instantiate(vector, {{n, n - 1}})};
  const Theorem recurrence = book.show(
      "recurrence", "eq:V-n eq:V-n-app", "A cycle takes it to the next:",
      matrix_equation(V_vector(n), times(Lambda(), V_vector(n - 1)), vectors + steps + all_rules));
  book.show("Lambda_orthogonal", "Lambda is orthogonal,",
            matrix_equation(times(Lambda(), transpose(Lambda())), identity(3), all_rules));
  for (const auto& [name, matrix_term, value] : {std::tuple{"Gamma_A_determinant", Gamma_A(), -1},
                                                 std::tuple{"Gamma_B_determinant", Gamma_B(), -1},
                                                 std::tuple{"Lambda_determinant", Lambda(), 1}})
    book.show(name, "its determinant:", equation(det(matrix_term), value, all_rules));
  book.show(
      "V_squared", "eq:V2", "so the length of V_n is kept:",
      matrix_equation(times(transpose(V_vector(n)), V_vector(n)),
                      times(transpose(V_vector(n - 1)), V_vector(n - 1)), {recurrence, of_cycle}));
}
}  // namespace derivation
