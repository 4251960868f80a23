// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 1: one contact, from the laws to the collision matrix Gamma.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

namespace {

const std::set<std::string> any_two_bodies{"M_1", "M_2", "u_1", "u_2", "v_1", "v_2"};

// The polynomial's factor that contains `sought`, divided by it; zero if there is none.
ex cofactor_in_factorisation(const ex& polynomial, const ex& sought) {
  ex quotient;
  const bool divides = GiNaC::divide(polynomial.expand(), sought.expand(), quotient);
  return divides ? GiNaC::factor(quotient) : ex(0);
}

}  // namespace

Theorem read_off_angle(Kernel& kernel, const std::string& id, const ex& name, const ex& cosine,
                       const ex& sine, const std::string& words) {
  kernel.identity({.id = id + ".circle",
                   .statement = {pow(cosine, 2) + pow(sine, 2), 1},
                   .words = "the two entries are the cosine and the sine of one angle"});
  kernel.positivity({.id = id + ".side",
                     .statement = {sine, Relation::greater, 0},
                     .words = "its sine is positive: the angle lies between 0 and pi"});
  const ex tangent_of_half = kernel.simplified(sine / (1 + cosine));
  return kernel.definition(
      {.id = id, .statement = {name, 2 * atan(tangent_of_half)}, .words = words});
}

Contact contact(Kernel& kernel, const Laws& laws, const Paper& paper) {
  const ex n = symbol("n"), alpha = symbol("alpha"), M = symbol("M");
  const ex M_1 = symbol("M_1"), M_2 = symbol("M_2");
  const ex u_1 = symbol("u_1"), u_2 = symbol("u_2"), v_1 = symbol("v_1"), v_2 = symbol("v_2");

  const Theorem momentum = kernel.law({.id = "contact.momentum",
                                       .statement = laws.momentum,
                                       .words = "momentum is conserved in a contact of two bodies",
                                       .schematic = any_two_bodies});
  const Theorem energy = kernel.law({.id = "contact.energy",
                                     .statement = laws.energy,
                                     .words = "kinetic energy is conserved (both sides times two)",
                                     .schematic = any_two_bodies});
  const Theorem changes = kernel.law({.id = "contact.changes",
                                      .statement = laws.contact,
                                      .words = "a collision changes the velocity of who takes part",
                                      .schematic = any_two_bodies});

  // Energy: M_1 (u_1 - v_1)(u_1 + v_1) = M_2 (v_2 - u_2)(v_2 + u_2). Momentum: M_1 (u_1 - v_1) = M_2 (v_2 - u_2).
  const ex combined =
      (energy.lhs() - energy.rhs()) - (u_2 + v_2) * (momentum.lhs() - momentum.rhs());
  const ex other_factor = cofactor_in_factorisation(combined, M_1 * (u_1 - v_1));
  const Theorem factored =
      kernel.consequence({.id = "contact.factored",
                          .statement = {M_1 * (u_1 - v_1) * other_factor, 0},
                          .words = "energy minus (u_2 + v_2) times momentum, factored"},
                         {{energy, 1}, {momentum, -(u_2 + v_2)}});
  const Theorem relative = kernel.cancellation(
      {.id = "contact.relative",
       .statement = {other_factor, 0},
       .words = "divide by M_1 (u_1 - v_1): a contact turns the relative velocity round"},
      factored, M_1 * (u_1 - v_1), changes);

  const LinearSolution solution =
      solve_linear({momentum.statement(), relative.statement()}, {v_1, v_2});
  const auto solve_for = [&](const char* id, size_t which, const ex& unknown) {
    return kernel.consequence(
        {.id = id,
         .statement = {unknown, collected(solution.values[which], {u_1, u_2})},
         .words = "two linear equations, solved for the velocities after"},
        {{momentum, solution.cofactors[which][0]}, {relative, solution.cofactors[which][1]}});
  };
  const Theorem after_1 = solve_for("contact.v_1", 0, v_1);
  const Theorem after_2 = solve_for("contact.v_2", 1, v_2);

  // At P_n the block is A and the ball comes with c'_(n-1); at Q_n the block is B and it comes with c_n.
  const Kernel::Values at_P{{M_1, M},    {M_2, alpha * M}, {u_1, a(n - 1)}, {u_2, c_prime(n - 1)},
                            {v_1, a(n)}, {v_2, c(n)}};
  const Kernel::Values at_Q{{M_1, M},    {M_2, alpha * M}, {u_1, b(n - 1)},
                            {u_2, c(n)}, {v_1, b(n)},      {v_2, c_prime(n)}};
  const auto replaced = [](const Statement& statement, const Kernel::Values& values,
                           const ex& scale) {
    GiNaC::exmap replacements;
    for (const auto& [name, value] : values) replacements[name] = value;
    return Statement((statement.lhs().subs(replacements) / scale).expand(),
                     (statement.rhs().subs(replacements) / scale).expand());
  };
  const auto at = [&](const std::string& id, const Theorem& general, const Kernel::Values& values,
                      const std::string& label, const char* where) {
    const Statement with_mass = replaced(general.statement(), values, 1);
    const Theorem special = kernel.instance({.id = id + ".with_mass",
                                             .statement = with_mass,
                                             .words = std::string("at ") + where,
                                             .indices = from_one},
                                            general, values);
    return kernel.consequence({.id = id,
                               .statement = paper.at(label),
                               .words = "divided by M",
                               .label = label,
                               .indices = from_one},
                              {{special, 1 / M}});
  };
  const Theorem momentum_P = at("contact.momentum_P", momentum, at_P, "eq:ac", "P_n");
  const Theorem energy_P = at("contact.energy_P", energy, at_P, "eq:Euc-Pn", "P_n");
  const Theorem momentum_Q = at("contact.momentum_Q", momentum, at_Q, "eq:bcp", "Q_n");
  const Theorem energy_Q = at("contact.energy_Q", energy, at_Q, "eq:Euc-Qn", "Q_n");
  kernel.consequence({.id = "contact.energy_cycle",
                      .statement = paper.at("eq:energy-conservation-PnQn"),
                      .words = "the sum of the two energy laws",
                      .label = "eq:energy-conservation-PnQn",
                      .indices = from_one},
                     {{energy_P, 1}, {energy_Q, 1}});

  const auto linear = [&](const std::string& id, const Kernel::Values& values,
                          const std::string& label) {
    const Theorem special = kernel.instance({.id = id + ".zero",
                                             .statement = replaced(relative.statement(), values, 1),
                                             .words = "the relative velocity turns round, here",
                                             .indices = from_one},
                                            relative, values);
    kernel.consequence({.id = id,
                        .statement = paper.at(label),
                        .words = "rearranged",
                        .label = label,
                        .indices = from_one},
                       {{special, 1}});
  };
  linear("contact.relative_P", at_P, "eq:Euc-Pn-linear");
  linear("contact.relative_Q", at_Q, "eq:Euc-Qn-linear");

  const auto after = [&](const std::string& id, const Theorem& general,
                         const Kernel::Values& values, const ex& unknown) {
    const ex value = kernel.simplified(replaced(general.statement(), values, 1).rhs(), from_one);
    const std::vector<ex> before{a(n - 1), b(n - 1), c_prime(n - 1), c(n)};
    return kernel.instance({.id = id,
                            .statement = {unknown, collected(value, before)},
                            .words = "the solution, here",
                            .indices = from_one},
                           general, values);
  };
  const Theorem a_n = after("contact.a", after_1, at_P, a(n));
  const Theorem c_n = after("contact.c", after_2, at_P, c(n));
  const Theorem b_n = after("contact.b", after_1, at_Q, b(n));
  const Theorem c_prime_n = after("contact.c_prime", after_2, at_Q, c_prime(n));

  // Gamma acts on (block, sqrt(alpha) ball); its entries are the coefficients of the solution.
  const ex root = sqrt(alpha);
  const auto coefficient = [&](const Theorem& solved, const ex& before, const ex& scale) {
    return kernel.simplified(solved.rhs().expand().coeff(before, 1) * scale, from_one);
  };
  const matrix derived{{coefficient(a_n, a(n - 1), 1), coefficient(a_n, c_prime(n - 1), 1 / root)},
                       {coefficient(c_n, a(n - 1), root), coefficient(c_n, c_prime(n - 1), 1)}};
  const Theorem Gamma = kernel.definition(
      {.id = "contact.Gamma",
       .statement = {symbol("Gamma"), derived},
       .words = "the coefficients of the solution, the ball's velocity times sqrt(alpha)"});
  kernel.rewriting({.id = "contact.at_P",
                    .statement = {matrix{{a(n)}, {root * c(n)}},
                                  (derived * matrix{{a(n - 1)}, {root * c_prime(n - 1)}}).evalm()},
                    .words = "(a_n, sqrt(alpha) c_n) = Gamma (a_(n-1), sqrt(alpha) c'_(n-1))",
                    .label = "eq:abc-n",
                    .indices = from_one,
                    .shown_rhs = "Gamma [[a(n - 1)], [sqrt(alpha)*c'(n - 1)]]"},
                   {a_n, c_n});
  kernel.rewriting({.id = "contact.at_Q",
                    .statement = {matrix{{b(n)}, {root * c_prime(n)}},
                                  (derived * matrix{{b(n - 1)}, {root * c(n)}}).evalm()},
                    .words = "(b_n, sqrt(alpha) c'_n) = Gamma (b_(n-1), sqrt(alpha) c_n)",
                    .label = "eq:abcp-n",
                    .indices = from_one,
                    .shown_rhs = "Gamma [[b(n - 1)], [sqrt(alpha)*c(n)]]"},
                   {b_n, c_prime_n});
  kernel.identity({.id = "contact.Gamma_paper",
                   .statement = paper.at("eq:Gamma"),
                   .words = "as the paper writes it",
                   .label = "eq:Gamma"});
  kernel.identity({.id = "contact.Gamma_orthogonal",
                   .statement = {(transpose(derived) * derived).evalm(), unit(2)},
                   .words = "Gamma^T Gamma = 1: lengths are kept",
                   .shown_lhs = "Gamma^T Gamma",
                   .shown_rhs = "1"});
  kernel.identity({.id = "contact.Gamma_determinant",
                   .statement = {determinant(derived), -1},
                   .words = "det Gamma = -1: a reflection is in it",
                   .shown_lhs = "det Gamma"});
  const Theorem theta = read_off_angle(kernel, "contact.theta", symbol("theta"), derived(0, 0),
                                       derived(0, 1), "the angle of Gamma");
  kernel.equal_angles({.id = "contact.theta_paper",
                       .statement = paper.at("def:theta"),
                       .words = "as the paper writes it",
                       .label = "def:theta, theta-txt"});
  kernel.identity({.id = "contact.Gamma_rotation",
                   .statement = paper.at("def:gamma"),
                   .words = "Gamma = lambda(theta) P_2",
                   .label = "def:gamma",
                   .shown_rhs = "lambda(theta) P_2"});
  return {momentum_P, energy_P, momentum_Q, energy_Q, a_n,    c_n,     b_n,
          c_prime_n,  Gamma,    theta,      momentum, energy, after_1, after_2};
}

}  // namespace magicmass::derivation
