// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 2: one cycle, a collision at P_n and one at Q_n, as the matrix Lambda.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

Cycle cycle(Kernel& kernel, const Contact& contact, const Paper& paper) {
  const ex n = symbol("n"), alpha = symbol("alpha");
  const ex root = sqrt(alpha);
  const matrix Gamma = GiNaC::ex_to<matrix>(contact.Gamma.rhs());

  const Theorem Gamma_A = kernel.definition(
      {.id = "cycle.Gamma_A",
       .statement = {symbol("Gamma_A"),
                     matrix{
                         {Gamma(0, 0), 0, Gamma(0, 1)}, {0, 1, 0}, {Gamma(1, 0), 0, Gamma(1, 1)}}},
       .words = "the collision at P_n on (a, b, sqrt(alpha) c'): B keeps its velocity"});
  const Theorem Gamma_B =
      kernel.definition({.id = "cycle.Gamma_B",
                         .statement = {symbol("Gamma_B"), matrix{{1, 0, 0},
                                                                 {0, Gamma(0, 0), Gamma(0, 1)},
                                                                 {0, Gamma(1, 0), Gamma(1, 1)}}},
                         .words = "the collision at Q_n: A keeps its velocity"});
  for (const auto& [name, Gamma_i] :
       {std::pair{"Gamma_A", Gamma_A}, std::pair{"Gamma_B", Gamma_B}}) {
    const std::string id = std::string("cycle.") + name;
    const std::string label = std::string("app:Vn, ") + name;
    kernel.identity({.id = id + "_rotation",
                     .statement = paper.at(label),
                     .words = "a rotation times the reflection P_3",
                     .label = label,
                     .shown_rhs = name == std::string("Gamma_A") ? "lambda_2(-theta) P_3"
                                                                 : "lambda_1(theta) P_3"});
    kernel.identity({.id = id + "_determinant",
                     .statement = {determinant(Gamma_i.rhs()), -1},
                     .words = "its determinant",
                     .shown_lhs = std::string("det ") + name});
    kernel.identity({.id = id + "_orthogonal",
                     .statement = {(transpose(Gamma_i.rhs()) * Gamma_i.rhs()).evalm(), unit(3)},
                     .words = "it keeps lengths",
                     .shown_lhs = std::string(name) + "^T " + name,
                     .shown_rhs = "1"});
  }

  const ex derived = kernel.simplified(Gamma_B.rhs() * Gamma_A.rhs());
  const Theorem Lambda =
      kernel.definition({.id = "cycle.Lambda",
                         .statement = {symbol("Lambda"), derived},
                         .words = "Lambda = Gamma_B Gamma_A, first P_n, then Q_n"});
  kernel.identity({.id = "cycle.Lambda_product",
                   .statement = {symbol("Lambda"), (Gamma_B.rhs() * Gamma_A.rhs()).evalm()},
                   .words = "Lambda = Gamma_B Gamma_A",
                   .label = "eq:Lam-G-G, Lam-GAM",
                   .shown_rhs = "Gamma_B Gamma_A"});
  kernel.identity({.id = "cycle.Lambda_paper",
                   .statement = paper.at("eq:Lambda"),
                   .words = "as the paper writes it",
                   .label = "eq:Lambda"});
  kernel.identity({.id = "cycle.Lambda_theta",
                   .statement = paper.at("eq:Lambda-app"),
                   .words = "in terms of theta",
                   .label = "eq:Lambda-app"});
  kernel.identity({.id = "cycle.Lambda_orthogonal",
                   .statement = {(transpose(derived) * derived).evalm(), unit(3)},
                   .words = "Lambda^T Lambda = 1",
                   .shown_lhs = "Lambda^T Lambda",
                   .shown_rhs = "1"});
  kernel.identity({.id = "cycle.Lambda_determinant",
                   .statement = {determinant(derived), 1},
                   .words = "det Lambda = 1: a pure rotation",
                   .shown_lhs = "det Lambda"});

  // Eliminate c_n: b and c' after Q_n, where c_n comes from P_n.
  const matrix before{{a(n - 1)}, {b(n - 1)}, {root * c_prime(n - 1)}};
  const matrix after{{a(n)}, {b(n)}, {root * c_prime(n)}};
  const ex turned = (derived * before).evalm();
  kernel.rewriting({.id = "cycle.V",
                    .statement = {after, turned},
                    .words = "V_n = Lambda V_(n-1): c_n eliminated",
                    .label = "eq:V-n, eq:V-n-app",
                    .indices = from_one,
                    .shown_rhs = "Lambda [[a(n - 1)], [b(n - 1)], [sqrt(alpha)*c'(n - 1)]]"},
                   {contact.c_prime, contact.b, contact.a, contact.c});
  const auto component = [&](const char* id, unsigned row, const ex& element, const ex& scale) {
    const ex value = kernel.simplified(turned.op(row) / scale, from_one);
    return kernel.rewriting(
        {.id = id,
         .statement = {element, collected(value, {a(n - 1), b(n - 1), c_prime(n - 1)})},
         .words = "a component of V_n = Lambda V_(n-1)",
         .indices = from_one},
        {contact.c_prime, contact.b, contact.a, contact.c});
  };
  const Theorem a_n = component("cycle.a", 0, a(n), 1);
  const Theorem b_n = component("cycle.b", 1, b(n), 1);
  const Theorem c_prime_n = component("cycle.c_prime", 2, c_prime(n), root);
  kernel.rewriting({.id = "cycle.V_squared",
                    .statement = paper.at("eq:V2"),
                    .words = "the length of V_n never changes",
                    .label = "eq:V2",
                    .indices = from_one},
                   {a_n, b_n, c_prime_n});
  return {Gamma_A, Gamma_B, Lambda, a_n, b_n, c_prime_n};
}

}  // namespace magicmass::derivation
