// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 4: Lambda^n, and with it every velocity in closed form.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;
using GiNaC::numeric;

Power power(Kernel& kernel, const Laws& laws, const Contact& contact, const Cycle& cycle,
            const Rotation& rotation, const Paper& paper) {
  const ex n = symbol("n"), alpha = symbol("alpha"), V = symbol("V"), psi = symbol("psi"),
           V_CM = symbol("V_CM");
  const ex root = sqrt(alpha);

  const ex R = rotation.R.rhs();
  const ex Lambda_n = (R * rotation_3(n * psi) * transpose(R)).evalm();
  const Theorem Lambda_power = kernel.matrix_power(
      {.id = "power.Lambda_n",
       .statement = {GiNaC::power(cycle.Lambda.lhs(), n), kernel.simplified(Lambda_n, from_zero)},
       .words = "by induction: another cycle turns by psi once more",
       .indices = from_zero},
      cycle.Lambda, n);
  kernel.rewriting({.id = "power.Lambda_n_paper",
                    .statement = paper.at("eq:Lambda-n-final"),
                    .words = "Lambda^n = R lambda_3(n psi) R^T",
                    .label = "eq:Lambda-n-final, eq:Lambda-n-final-txt",
                    .indices = from_zero,
                    .shown_rhs = "R lambda_3(n*psi) R^T"},
                   {Lambda_power});

  const Theorem a_0 = kernel.law(
      {.id = "power.a_0", .statement = laws.a_initial, .words = "A comes with velocity V"});
  const Theorem b_0 =
      kernel.law({.id = "power.b_0", .statement = laws.b_initial, .words = "B is at rest"});
  const Theorem c_0 =
      kernel.law({.id = "power.c_0", .statement = laws.c_initial, .words = "so is C"});

  // V_n = Lambda^n V_0 with V_0 = (V, 0, 0).
  const matrix V_0{{a_0.rhs()}, {b_0.rhs()}, {root * c_0.rhs()}};
  const ex V_n = (Lambda_power.rhs() * V_0).evalm();
  const matrix formulas{{kernel.simplified(V_n.op(0), from_zero)},
                        {kernel.simplified(V_n.op(1), from_zero)},
                        {kernel.simplified(V_n.op(2) / root, from_zero)}};
  const matrix velocities{{a(n)}, {b(n)}, {c_prime(n)}};
  const Theorem derived =
      kernel.induction({.id = "power.V_n",
                        .statement = {velocities, formulas},
                        .words = "V_n = Lambda^n V_0, by induction from V_n = Lambda V_(n-1)",
                        .label = "eq:V-n-0, eq:V-n-0-app",
                        .indices = from_zero},
                       {a_0, b_0, c_0}, {cycle.a, cycle.b, cycle.c_prime}, n);

  const Theorem centre =
      kernel.definition({.id = "power.V_CM",
                         .statement = {V_CM, V / (2 + alpha)},
                         .words = "the velocity of the centre of mass: (2 M + m) V_CM = M V"});
  kernel.identity({.id = "power.V_CM_paper",
                   .statement = paper.at("sec:result, V_CM"),
                   .words = "in terms of psi",
                   .label = "sec:result, V_CM"});

  const auto component = [&](const std::string& id, unsigned row, const std::string& label) {
    const Theorem plain = kernel.component({.id = id + "_derived",
                                            .statement = {velocities(row, 0), formulas(row, 0)},
                                            .words = "a component of V_n",
                                            .indices = from_zero},
                                           derived, row);
    return kernel.rewriting({.id = id,
                             .statement = paper.at(label),
                             .words = "with V_CM in front, as the paper writes it",
                             .label = label,
                             .indices = from_zero},
                            {plain});
  };
  const Theorem a_n = component("power.a", 0, "eq:a-final");
  const Theorem b_n = component("power.b", 1, "eq:b-final");
  const Theorem c_prime_n = component("power.c_prime", 2, "eq:c'-final");

  // c_n from momentum at P_n: alpha c_n = a_(n-1) + alpha c'_(n-1) - a_n.
  const Theorem c_from =
      kernel.consequence({.id = "power.c_from_momentum",
                          .statement = {c(n), (a(n - 1) + alpha * c_prime(n - 1) - a(n)) / alpha},
                          .words = "momentum at P_n, solved for c_n",
                          .indices = from_one},
                         {{contact.momentum_P, -1 / alpha}});
  const Theorem c_n = kernel.rewriting({.id = "power.c",
                                        .statement = paper.at("eq:c-final"),
                                        .words = "with a_n, a_(n-1) and c'_(n-1) put in",
                                        .label = "eq:c-final",
                                        .indices = from_one},
                                       {c_from, a_n, c_prime_n});

  // Products of sines and cosines of multiples of h = psi/2: no difference of nearly equal numbers is left.
  const ex h = psi / 2;
  const ex front = 2 * V_CM * (1 + alpha);
  const ex front_of_ball = 2 * V_CM / sin(h / 2);
  const auto product = [&](const char* id, const ex& element, const ex& form, const Theorem& closed,
                           const Indices& indices) {
    return kernel.rewriting({.id = id,
                             .statement = {element, form},
                             .words = "sums of cosines and sines as products",
                             .indices = indices},
                            {closed});
  };
  return {a_0,
          b_0,
          c_0,
          centre,
          a_n,
          b_n,
          c_prime_n,
          c_n,
          product("power.a_product", a(n),
                  front * cos((n + one_half) * h) * cos((n - one_half) * h), a_n, from_zero),
          product("power.b_product", b(n), front * sin((n + 1) * h) * sin(n * h), b_n, from_zero),
          product("power.c_product", c(n), front_of_ball * sin(n * h) * cos((n - one_half) * h),
                  c_n, from_one),
          product("power.c_prime_product", c_prime(n),
                  -front_of_ball * sin(n * h) * cos((n + one_half) * h), c_prime_n, from_zero)};
}

}  // namespace magicmass::derivation
