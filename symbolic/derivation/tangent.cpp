// SPDX-License-Identifier: GPL-2.0-or-later
// Velocities and encounters from one sine and one cosine, with t = tan(psi/4).
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;

Tangent tangent(Kernel& kernel, const Rotation& rotation, const Power& power, const Times& times) {
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

  // With one root and no quotient but its own: t S and cot(psi/2) S serve all four.
  kernel.rewriting({.id = "tangent.root",
                    .statement = {cotangent, 1 / sqrt(alpha * (2 + alpha))},
                    .words = "the cotangent as the reciprocal of one root"},
                   {half, quarter});
  kernel.rewriting({.id = "tangent.tan_from_root",
                    .statement = {t, alpha * cotangent},
                    .words = "and the tangent from it"},
                   {half});
  kernel.rewriting({.id = "tangent.psi",
                    .statement = {psi, 4 * atan(t)},
                    .words = "psi from the tangent of its quarter"},
                   {rotation.psi_half_angle, quarter});
  velocity("tangent.b_product", b(n), 2 * V * (t * S) * (cotangent * S + C), power.b, 0);

  // As sums of two products, which need no more digits than the results: C moves to and fro about a mean.
  const ex chord = symbol("chord"), mean = symbol("ball_mean"), swing = symbol("ball_swing");
  const Indices cycles{{"n", 0}};
  kernel.definition({.id = "tangent.chord",
                     .statement = {chord, cotangent * S},
                     .words = "the sine over the tangent of a half of psi",
                     .indices = cycles});
  kernel.definition({.id = "tangent.ball_mean",
                     .statement = {mean, alpha * pow(chord, 2)},
                     .words = "a quarter of c_n + c'_n, in units of V",
                     .indices = cycles});
  kernel.definition({.id = "tangent.ball_swing",
                     .statement = {swing, chord * C},
                     .words = "a quarter of their difference",
                     .indices = cycles});
  velocity("tangent.a_sum", a(n), V * (pow(C, 2) - alpha * mean), power.a, 0);
  velocity("tangent.b_sum", b(n), 2 * V * (mean + alpha * swing), power.b, 0);
  velocity("tangent.c_sum", c(n), 2 * V * (mean + swing), power.c, 1);
  velocity("tangent.c_prime_sum", c_prime(n), 2 * V * (mean - swing), power.c_prime, 0);

  // The first collisions, all there are beyond alpha = 1, in the same shape: S is 1, and C and cot(psi/2) are 1/(1 + alpha).
  const ex q = 1 / (1 + alpha);
  const auto first = [&](const std::string& id, const Theorem& general, const ex& form) {
    const GiNaC::lst at{n == 1, j == 1};
    const ex& index = general.lhs().has(n) ? n : j;
    const Theorem at_one =
        kernel.instance({.id = id + "_at_1",
                         .statement = {general.lhs().subs(at), general.rhs().subs(at)},
                         .words = "at the first"},
                        general, {{index, 1}});
    kernel.rewriting(
        {.id = id, .statement = {at_one.lhs(), form}, .words = "the same products without roots"},
        {at_one});
    return at_one;
  };
  const Theorem first_a = first("tangent.first_a", power.a, V * (q - alpha * q) * (q + alpha * q));
  const Theorem first_b = first("tangent.first_b", power.b, 2 * V * (alpha * q) * (q + q));
  first("tangent.first_c", power.c, 2 * V * q * (q + alpha * q));
  const Theorem first_c_prime =
      first("tangent.first_c_prime", power.c_prime, -2 * V * q * (q - alpha * q));

  // In cos(psi/2) = 1/(1 + alpha) alone.
  const ex cosine = symbol("cos_half");
  const Theorem share = kernel.definition({.id = "tangent.cos_half",
                                           .statement = {cosine, q},
                                           .words = "the cosine of a half of psi, by name"});
  const auto of_cosine = [&](const char* id, const Theorem& at_one, const ex& form) {
    kernel.rewriting(
        {.id = id, .statement = {at_one.lhs(), form}, .words = "from that cosine alone"},
        {share, at_one});
  };
  of_cosine("tangent.first_a_of_cosine", first_a, V * (2 * cosine - 1));
  of_cosine("tangent.first_b_of_cosine", first_b,
            2 * V * cosine + 2 * V * cosine * (1 - 2 * cosine));
  of_cosine("tangent.first_c_prime_of_cosine", first_c_prime, 2 * V * cosine * (1 - 2 * cosine));

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
  // The same through the root alone.
  encounter("tangent.t_product", proof::t(j),
            L / V * (1 + alpha) * cotangent * S_j / (cotangent * S_j + C_j), times.t);
  encounter("tangent.s_product", s(j), L / (cotangent * S_j + C_j), times.s);
  first("tangent.first_t", times.t, L / V * (1 + alpha) * q / (q + q));
  first("tangent.first_s", times.s, L / (q + q));
  return {quarter, half, a_n, b_n, c_n, c_prime_n, t_j, s_j};
}

}  // namespace magicmass::derivation
