// SPDX-License-Identifier: GPL-2.0-or-later
// Velocities and encounters from one sine and one cosine, with t = tan(psi/4).
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;

Tangent tangent(Kernel& kernel, const Power& power, const Times& times) {
  const ex n = symbol("n"), j = symbol("j"), alpha = symbol("alpha"), psi = symbol("psi");
  const ex V = symbol("V"), L = symbol("L"), V_CM = symbol("V_CM");
  const ex t = symbol("tan_quarter"), cotangent = symbol("cot_half");

  const Theorem quarter = kernel.definition({.id = "tangent.tan_quarter",
                                             .statement = {t, sqrt(alpha / (2 + alpha))},
                                             .words = "the tangent of a quarter of psi, by name"});
  kernel.identity({.id = "tangent.of_quarter",
                   .statement = {tan(psi / 4), t},
                   .words = "it is what its name says"});
  const Theorem half = kernel.definition({.id = "tangent.cot_half",
                                          .statement = {cotangent, t / alpha},
                                          .words = "the cotangent of a half of psi, by name"});
  kernel.identity({.id = "tangent.of_half",
                   .statement = {tan(psi / 2), 1 / cotangent},
                   .words = "its reciprocal is the tangent"});

  // (1 - t^2) V = 2 V_CM; cos((n + 1/2) psi/2) is C - t S times cos(psi/4), and so on.
  const auto velocity = [&](const char* id, const ex& element, const ex& form,
                            const Theorem& closed, long from) {
    return kernel.rewriting({.id = id,
                             .statement = {element, form},
                             .words = "from the sine and the cosine of n psi/2",
                             .indices = {{"n", from}}},
                            {closed});
  };
  const ex S = sin(n * psi / 2), C = cos(n * psi / 2);
  const Theorem a_n = velocity("tangent.a", a(n), V * (C - t * S) * (C + t * S), power.a, 0);
  const Theorem b_n = velocity("tangent.b", b(n), 2 * S * (V_CM * S + V * t * C), power.b, 0);
  const Theorem c_n = velocity("tangent.c", c(n), 2 * V * cotangent * S * (C + t * S), power.c, 1);
  const Theorem c_prime_n = velocity("tangent.c_prime", c_prime(n),
                                     -2 * V * cotangent * S * (C - t * S), power.c_prime, 0);

  const ex S_j = sin(j * psi / 2), C_j = cos(j * psi / 2), D = V_CM * S_j + V * t * C_j;
  const auto encounter = [&](const char* id, const ex& element, const ex& form,
                             const Theorem& closed) {
    return kernel.rewriting({.id = id,
                             .statement = {element, form},
                             .words = "from the sine and the cosine of j psi/2",
                             .indices = {{"j", 0}}},
                            {closed});
  };
  const Theorem t_j =
      encounter("tangent.t", proof::t(j), L / V * (1 + alpha) * V_CM * S_j / D, times.t);
  const Theorem s_j = encounter("tangent.s", s(j), L * V * t / D, times.s);
  return {quarter, half, a_n, b_n, c_n, c_prime_n, t_j, s_j};
}

}  // namespace magicmass::derivation
