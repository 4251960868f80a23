// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 7, the rest: every beta_k is a strict local minimum of b_t, without calculus.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

const Indices k_and_last{{"k", 1}, {"N_B", 1}};

// b_n where psi/2 = h: what B lacks is a squared ratio of cosines.
ex velocity_of_B(const ex& n, const ex& h) {
  return symbol("V") * (1 - pow(cos((n + one_half) * h) / cos(h / 2), 2));
}

// For h_1 < h_2 <= pi/(2 n + 1) the ratio cos((n + 1/2) h)/cos(h/2) falls, so the velocity rises.
Theorem rise(Kernel& kernel) {
  const ex n = symbol("n"), h_1 = symbol("h_1"), h_2 = symbol("h_2"), V = symbol("V");
  const auto hypothesis = [&](const char* id, const Statement& statement, const char* words) {
    return kernel.hypothesis(
        {.id = id, .statement = statement, .words = words, .indices = from_one});
  };
  const Theorem later =
      hypothesis("minima.later", {h_2, Relation::greater, h_1}, "take two half-angles psi/2 ...");
  const Theorem early = hypothesis("minima.early", {(2 * n + 1) * h_2, Relation::less_equal, Pi},
                                   "... before B has everything");
  const auto angle = [&](const char* id, const Statement& statement,
                         const std::vector<Kernel::NonnegativeTerm>& terms) {
    return kernel.ordering({.id = id,
                            .statement = statement,
                            .words = "what the two conditions say of the angles below",
                            .indices = from_one},
                           terms);
  };
  const Theorem mean_below_pi =
      angle("minima.mean_below_pi", {Pi, Relation::greater, (n + 1) * (h_1 + h_2) / 2},
            {{(n + 1) / (2 * n + 1), {early}, 1},
             {(n + 1) / 2, {later}, 1},
             {n * Pi / (2 * n + 1), {}, 1}});
  const auto sine = [&](const char* id, const ex& x, const std::vector<Theorem>& bounds) {
    return kernel.sine_sign({.id = id,
                             .statement = {sin(x), Relation::greater, 0},
                             .words = "a sine between 0 and pi",
                             .indices = from_one},
                            bounds);
  };
  const auto apart = [&](const char* id, const ex& multiple) {
    return angle(id, {multiple * (h_2 - h_1) / 2, Relation::greater, 0},
                 {{multiple / 2, {later}, 1}});
  };
  const Theorem apart_n = apart("minima.apart_n", n);
  const Theorem apart_next = apart("minima.apart_next", n + 1);
  const Theorem sum_next = sine("minima.sine_sum_next", (n + 1) * (h_1 + h_2) / 2, {mean_below_pi});
  const Theorem sum_n = sine("minima.sine_sum", n * (h_1 + h_2) / 2, {mean_below_pi});
  const Theorem difference_n =
      sine("minima.sine_difference", n * (h_2 - h_1) / 2, {apart_n, mean_below_pi});
  const Theorem difference_next =
      sine("minima.sine_difference_next", (n + 1) * (h_2 - h_1) / 2, {apart_next, mean_below_pi});

  const ex far_1 = cos((n + one_half) * h_1), far_2 = cos((n + one_half) * h_2);
  const ex near_1 = cos(h_1 / 2), near_2 = cos(h_2 / 2);
  const Theorem ratio_falls = kernel.ordering(
      {.id = "minima.ratio_falls",
       .statement = {far_1 * near_2, Relation::greater, far_2 * near_1},
       .words = "products of cosines as sums, their differences as products of sines",
       .indices = from_one},
      {{1, {sum_next, difference_n}, 1}, {1, {sum_n, difference_next}, 1}});

  const auto within = [&](const std::string& id, const Statement& statement,
                          const std::vector<Kernel::NonnegativeTerm>& terms) {
    return angle(id.c_str(), statement, terms);
  };
  const Theorem far_2_within =
      within("minima.far_2_within", {(n + one_half) * h_2, Relation::less_equal, Pi / 2},
             {{one_half, {early}, 1}});
  const Theorem far_1_within =
      within("minima.far_1_within", {Pi / 2, Relation::greater, (n + one_half) * h_1},
             {{n + one_half, {later}, 1}, {one_half, {early}, 1}});
  const auto cosine = [&](const char* id, const Statement& statement, const Theorem& bound) {
    return kernel.sine_sign(
        {.id = id, .statement = statement, .words = "a cosine up to pi/2", .indices = from_one},
        {bound});
  };
  const Theorem far_1_positive =
      cosine("minima.far_1_positive", {far_1, Relation::greater, 0}, far_1_within);
  const Theorem far_2_positive =
      cosine("minima.far_2_positive", {0, Relation::less_equal, far_2}, far_2_within);
  const Theorem near_2_within =
      within("minima.near_2_within", {Pi / 2, Relation::greater, h_2 / 2},
             {{1 / (2 * (2 * n + 1)), {early}, 1}, {n * Pi / (2 * n + 1), {}, 1}});
  const Theorem near_1_within = within("minima.near_1_within", {Pi / 2, Relation::greater, h_1 / 2},
                                       {{1, {near_2_within}, 1}, {one_half, {later}, 1}});
  const Theorem near_1_positive =
      cosine("minima.near_1_positive", {near_1, Relation::greater, 0}, near_1_within);
  const Theorem near_2_positive =
      cosine("minima.near_2_positive", {near_2, Relation::greater, 0}, near_2_within);

  const Statement rises{velocity_of_B(n, h_2), Relation::greater, velocity_of_B(n, h_1)};
  const ex below = 1 / (near_1 * near_2);
  const Theorem where_defined =
      kernel.ordering({.id = "minima.rises_where_defined",
                       .statement = rises,
                       .words = "a difference of squares",
                       .indices = from_one},
                      {{V, {ratio_falls, far_1_positive, near_2_positive}, below},
                       {V, {ratio_falls, far_2_positive, near_1_positive}, below}});
  return kernel.discharge({.id = "minima.rises",
                           .statement = rises,
                           .words = "with n collisions of B, b_n rises with psi up to pi/(n + 1/2)",
                           .indices = from_one},
                          where_defined, {near_1_positive, near_2_positive});
}

}  // namespace

void minima(Kernel& kernel, const Rotation& rotation, const Power& power, const Counting& counting,
            const Terminal& terminal) {
  const ex n = symbol("n"), k = symbol("k"), alpha = symbol("alpha"), psi = symbol("psi"),
           V = symbol("V"), V_CM = symbol("V_CM");
  const ex N_B = symbol("N_B"), alpha_k = symbol("alpha_k"), beta_k = symbol("beta_k");
  const Theorem form = kernel.rewriting({.id = "minima.b",
                                         .statement = {b(n), velocity_of_B(n, psi / 2)},
                                         .words = "what B lacks, as a square",
                                         .indices = {{"n", 0}}},
                                        {power.b, power.V_CM});

  // Everywhere b_t >= 2 V/(2 + alpha), which falls with alpha: so b_t is larger at smaller alpha.
  const auto halved = [&](const std::string& id, const Statement& statement, const Theorem& whole) {
    return kernel.ordering(
        {.id = id, .statement = statement, .words = "divided by two", .indices = {{"N_B", 1}}},
        {{one_half, {whole}, 1}});
  };
  const Theorem reached = halved(
      "minima.half_reached", {Pi / 2, Relation::less_equal, (N_B + 1) * psi / 2}, terminal.reached);
  const Theorem not_before = halved(
      "minima.half_not_before", {Pi / 2, Relation::greater, N_B * psi / 2}, terminal.not_before);
  const Theorem psi_below =
      halved("minima.half_psi", {Pi / 2, Relation::greater, psi / 2}, terminal.psi_below_pi);
  const Theorem within = kernel.ordering({.id = "minima.half_within",
                                          .statement = {Pi, Relation::greater, (N_B + 1) * psi / 2},
                                          .words = "less than one half-angle further",
                                          .indices = {{"N_B", 1}}},
                                         {{1, {not_before}, 1}, {1, {psi_below}, 1}});
  const auto cosine = [&](const char* id, const Statement& statement,
                          const std::vector<Theorem>& bounds) {
    return kernel.sine_sign({.id = id,
                             .statement = statement,
                             .words = "a cosine on that side of pi/2",
                             .indices = {{"N_B", 1}}},
                            bounds);
  };
  const Theorem after =
      cosine("minima.cosine_after", {cos((N_B + 1) * psi / 2), Relation::less_equal, 0},
             {reached, within});
  const Theorem before =
      cosine("minima.cosine_before", {cos(N_B * psi / 2), Relation::greater, 0}, {not_before});
  const Theorem least =
      kernel.ordering({.id = "minima.least",
                       .statement = {2 * V / (2 + alpha), Relation::less_equal, b(N_B)},
                       .words = "B gets at least what it would share with C at the same velocity",
                       .indices = {{"N_B", 1}}},
                      {{2 * V_CM * (1 + alpha), {before, after}, 1}}, {power.b, power.V_CM});
  const Theorem lighter = kernel.hypothesis({.id = "minima.lighter",
                                             .statement = {beta_k, Relation::greater, alpha},
                                             .words = "a ball lighter than at beta_k",
                                             .indices = k_from_one});
  kernel.ordering({.id = "minima.to_the_left",
                   .statement = {b(N_B), Relation::greater, 2 * V / (2 + beta_k)},
                   .words = "gives B more than b_t at beta_k: the minimum, from the left",
                   .label = "app:deficient",
                   .indices = k_and_last},
                  {{1, {least}, 1}, {2 * V / ((2 + alpha) * (2 + beta_k)), {lighter}, 1}});

  // beta_k < alpha <= alpha_k: psi/2 lies between the half-angles there, N_B stays k, and b_k rises.
  const Theorem heavier = kernel.hypothesis({.id = "minima.heavier",
                                             .statement = {alpha, Relation::greater, beta_k},
                                             .words = "a ball heavier than at beta_k ...",
                                             .indices = k_from_one});
  const Theorem not_magic_yet =
      kernel.hypothesis({.id = "minima.up_to_magic",
                         .statement = {alpha, Relation::less_equal, alpha_k},
                         .words = "... up to the magic ratio alpha_k",
                         .indices = k_from_one});
  const ex deficient_half = Pi / (2 * (k + 1)), magic_half = Pi / (2 * k + 1);
  const auto compared = [&](const std::string& id, const Statement& cosines,
                            const Statement& angles, const Theorem& ratio, const ex& other) {
    const Theorem smaller =
        kernel.ordering({.id = id + "_cosines",
                         .statement = cosines,
                         .words = "cos(psi/2) = 1/(1 + alpha) falls with alpha",
                         .indices = k_from_one},
                        {{1 / ((1 + alpha) * (1 + other)), {ratio}, 1}}, {rotation.cos_half_psi});
    return kernel.larger_angle({.id = id,
                                .statement = angles,
                                .words = "so the angles compare the other way round",
                                .indices = k_from_one},
                               smaller);
  };
  const Theorem above =
      compared("minima.above", {cos(deficient_half), Relation::greater, cos(psi / 2)},
               {psi / 2, Relation::greater, deficient_half}, heavier, beta_k);
  const Theorem at_most =
      compared("minima.at_most", {cos(magic_half), Relation::less_equal, cos(psi / 2)},
               {psi / 2, Relation::less_equal, magic_half}, not_magic_yet, alpha_k);
  const auto scaled = [&](const std::string& id, const Statement& statement,
                          const std::vector<Kernel::NonnegativeTerm>& terms) {
    return kernel.ordering(
        {.id = id, .statement = statement, .words = "the same, multiplied", .indices = k_from_one},
        terms);
  };
  const Theorem enough = scaled("minima.enough", {Pi, Relation::less_equal, (k + 1) * psi},
                                {{2 * (k + 1), {above}, 1}});
  const Theorem not_more = scaled("minima.not_more", {Pi, Relation::greater, k * psi},
                                  {{2 * k, {at_most}, 1}, {Pi / (2 * k + 1), {}, 1}});
  const Theorem early =
      scaled("minima.psi_early", {(2 * k + 1) * (psi / 2), Relation::less_equal, Pi},
             {{2 * k + 1, {at_most}, 1}});
  const Theorem count = kernel.ceiling_value({.id = "minima.N_B",
                                              .statement = {N_B, k},
                                              .words = "B is hit k times there",
                                              .indices = k_and_last},
                                             counting.N_B, enough, not_more);
  const Theorem general = rise(kernel);
  const Statement rises{velocity_of_B(k, psi / 2), Relation::greater,
                        velocity_of_B(k, deficient_half)};
  const Theorem special =
      kernel.instance({.id = "minima.rises_from_beta_k_if",
                       .statement = rises,
                       .words = "from the half-angle at beta_k to the present one",
                       .indices = k_from_one},
                      general, {{n, k}, {symbol("h_1"), deficient_half}, {symbol("h_2"), psi / 2}});
  const Theorem from_beta = kernel.discharge({.id = "minima.rises_from_beta_k",
                                              .statement = rises,
                                              .words = "which do lie in this order",
                                              .indices = k_from_one},
                                             special, {above, early});
  kernel.ordering({.id = "minima.to_the_right",
                   .statement = {b(N_B), Relation::greater, 2 * V / (2 + beta_k)},
                   .words = "more than b_t at beta_k: the minimum, from the right",
                   .label = "app:deficient",
                   .indices = k_and_last},
                  {{1, {from_beta}, 1}}, {count, form});
}

}  // namespace magicmass::derivation
