// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 10: one contact with restitution, and the matrices of a cycle between equal blocks.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

namespace {

// Gamma_A(e), Gamma_B(e) and their product on (a, b, sqrt(alpha) c'), from the contact's coefficients.
void matrices_of_a_cycle(Kernel& kernel, const Restitution& contact, const Cycle& elastic) {
  const ex alpha = symbol("alpha"), e = symbol("e"), M = symbol("M"), x = symbol("x");
  const ex root = sqrt(alpha);
  const auto coefficient = [&](const Theorem& solved, const char* before, const ex& scale) {
    const ex at_blocks =
        solved.rhs().subs(GiNaC::lst{symbol("M_1") == M, symbol("M_2") == alpha * M});
    return kernel.simplified(at_blocks.expand().coeff(symbol(before), 1) * scale);
  };
  const matrix Gamma{
      {coefficient(contact.v_1, "u_1", 1), coefficient(contact.v_1, "u_2", 1 / root)},
      {coefficient(contact.v_2, "u_1", root), coefficient(contact.v_2, "u_2", 1)}};
  const matrix at_P{{Gamma(0, 0), 0, Gamma(0, 1)}, {0, 1, 0}, {Gamma(1, 0), 0, Gamma(1, 1)}};
  const matrix at_Q{{1, 0, 0}, {0, Gamma(0, 0), Gamma(0, 1)}, {0, Gamma(1, 0), Gamma(1, 1)}};
  const ex cycle = kernel.simplified((ex(at_Q) * at_P).evalm());
  const struct {
    const char* id;
    const char* name;
    ex value;
    const char* words;
    const Theorem& at_one;
  } named[] = {
      {"restitution.Gamma_A", "Gamma_A_e", at_P, "the collision at P_n on (a, b, sqrt(alpha) c')",
       elastic.Gamma_A},
      {"restitution.Gamma_B", "Gamma_B_e", at_Q, "the collision at Q_n", elastic.Gamma_B},
      {"restitution.Lambda", "Lambda_e", cycle, "a cycle: first P_n, then Q_n", elastic.Lambda}};
  for (const auto& [id, name, value, words, at_one] : named) {
    kernel.definition({.id = id, .statement = {symbol(name), value}, .words = words});
    kernel.identity({.id = std::string(id) + "_elastic",
                     .statement = {value.subs(e == 1), at_one.lhs()},
                     .words = "at e = 1 it is the elastic one",
                     .shown_lhs = std::string(name) + " at e = 1"});
  }
  kernel.identity({.id = "restitution.Lambda_product",
                   .statement = {symbol("Lambda_e"), (ex(at_Q) * at_P).evalm()},
                   .words = "Lambda_e = Gamma_B_e Gamma_A_e",
                   .shown_rhs = "Gamma_B_e Gamma_A_e"});

  const matrix momentum{{1, 1, root}};
  kernel.identity({.id = "restitution.momentum_eigenvector",
                   .statement = {(ex(momentum) * cycle).evalm(), momentum},
                   .words = "total momentum is a left eigenvector with eigenvalue 1",
                   .shown_lhs = "[[1, 1, sqrt(alpha)]] Lambda_e"});
  const matrix Lambda = GiNaC::ex_to<matrix>(cycle);
  const ex whole_determinant = kernel.simplified(determinant(cycle));
  kernel.identity({.id = "restitution.determinant",
                   .statement = {determinant(cycle), pow(e, 2)},
                   .words = "so the other two eigenvalues have the product e^2",
                   .shown_lhs = "det Lambda_e"});
  const ex trace_of_rest = pow(1 + e, 2) / pow(1 + alpha, 2) - 2 * e;
  kernel.identity({.id = "restitution.trace",
                   .statement = {Lambda.trace() - 1, trace_of_rest},
                   .words = "and this sum",
                   .shown_lhs = "tr Lambda_e - 1"});
  kernel.identity({.id = "restitution.characteristic",
                   .statement = {determinant((Lambda - x * ex(unit(3))).evalm()),
                                 (1 - x) * (pow(x, 2) - trace_of_rest * x + whole_determinant)},
                   .words = "the characteristic polynomial",
                   .shown_lhs = "det(Lambda_e - x)"});
}

}  // namespace

Restitution restitution(Kernel& kernel, const Laws& laws, const Cycle& cycle) {
  const ex M_1 = symbol("M_1"), M_2 = symbol("M_2"), e = symbol("e");
  const ex u_1 = symbol("u_1"), u_2 = symbol("u_2"), v_1 = symbol("v_1"), v_2 = symbol("v_2");

  const Theorem momentum = kernel.law({.id = "restitution.momentum",
                                       .statement = laws.momentum,
                                       .words = "momentum is conserved, whether or not energy is"});
  const Theorem relative = kernel.law(
      {.id = "restitution.law",
       .statement = laws.restitution,
       .words = "a contact turns the relative velocity round and leaves e of it, 0 < e <= 1"});
  const LinearSolution solution =
      solve_linear({momentum.statement(), relative.statement()}, {v_1, v_2});
  const auto solve_for = [&](const char* id, size_t which, const ex& unknown) {
    return kernel.consequence(
        {.id = id,
         .statement = {unknown, kernel.simplified(solution.values[which])},
         .words = "two linear equations, solved for the velocities after"},
        {{momentum, solution.cofactors[which][0]}, {relative, solution.cofactors[which][1]}});
  };
  const Restitution contact{momentum, relative, solve_for("restitution.v_1", 0, v_1),
                            solve_for("restitution.v_2", 1, v_2)};

  const ex before = M_1 * pow(u_1, 2) + M_2 * pow(u_2, 2),
           after = M_1 * pow(v_1, 2) + M_2 * pow(v_2, 2);
  const ex lost = (1 - pow(e, 2)) * M_1 * M_2 / (M_1 + M_2) * pow(u_1 - u_2, 2);
  const Theorem energy =
      kernel.rewriting({.id = "restitution.energy_lost",
                        .statement = {before - after, lost},
                        .words = "1 - e^2 of the energy of the relative motion is lost (both "
                                 "sides times two)"},
                       {contact.v_1, contact.v_2});
  const Theorem nothing_lost = kernel.instance({.id = "restitution.nothing_lost",
                                                .statement = {before - after, 0},
                                                .words = "at e = 1 none is"},
                                               energy, {{e, ex(1)}});
  kernel.consequence({.id = "restitution.energy_conserved",
                      .statement = laws.energy,
                      .words = "so the energy law is the restitution law at e = 1"},
                     {{nothing_lost, 1}});
  matrices_of_a_cycle(kernel, contact, cycle);
  return contact;
}

}  // namespace magicmass::derivation
