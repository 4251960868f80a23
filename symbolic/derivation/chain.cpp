// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 13: a chain of equal blocks A_1, A_2, ... with a ball of some magic mass ratio between each two. What comes
// in at one end arrives at the other, and returns from a wall.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;

namespace {

const Indices j_from_one{{"j", 1}}, K_from_one{{"K", 1}}, both_from_one{{"j", 1}, {"k", 1}};

// How long a run lasts and how far B gets in it: what lies ahead must be at least that far away.
Theorem room(Kernel& kernel, const Ratios& ratios, const Unfolding& unfolding) {
  const ex k = symbol("k"), alpha = symbol("alpha"), L = symbol("L"), V = symbol("V");
  const ex x_B = symbol("x_B"), d = symbol("d");
  const std::vector<Theorem> at_magic{unfolding.t_Q, unfolding.s_Q, ratios.magic.angle,
                                      ratios.magic.ratio};
  const Theorem lasts = kernel.rewriting({.id = "chain.duration",
                                          .statement = {t_Q(k), 2 * L / (V * (1 + alpha))},
                                          .words = "when the last collision, Q_k, happens",
                                          .indices = k_from_one},
                                         at_magic);
  const Theorem apart = kernel.rewriting({.id = "chain.apart",
                                          .statement = {s_Q(k), L},
                                          .words = "A and B are as far apart as they were at P_1",
                                          .indices = k_from_one},
                                         at_magic);
  const Theorem centre = kernel.hypothesis(
      {.id = "chain.centre",
       .statement = {(x_B - s_Q(k)) + x_B + alpha * x_B, L + V * t_Q(k)},
       .words = "B and C are at x_B, A is behind: the centre of mass has moved uniformly",
       .indices = k_from_one});
  kernel.consequence(
      {.id = "chain.room",
       .statement = {x_B - L, L * (1 - alpha) / (1 + alpha)},
       .words = "how far B has moved before the run is over",
       .indices = k_from_one},
      {{centre, 1 / (2 + alpha)}, {lasts, V / (2 + alpha)}, {apart, 1 / (2 + alpha)}});
  return kernel.hypothesis(
      {.id = "chain.one_at_a_time",
       .statement = {L * (1 - alpha) / (1 + alpha), Relation::less_equal, d},
       .words = "the next ball is d away from B, which does not reach it before"});
}

// One run, in which the block that comes in is the A of the earlier chapters and the next block their B.
Theorem run(Kernel& kernel, const std::string& id, const ex& incoming, const ex& outgoing, int sign,
            const Ratios& ratios, const char* words) {
  const ex k = symbol("k"), V = symbol("V");
  const Theorem comes = kernel.hypothesis({.id = id + "_comes",
                                           .statement = {incoming, sign * V},
                                           .words = words,
                                           .indices = j_from_one});
  const Theorem goes =
      kernel.hypothesis({.id = id + "_goes",
                         .statement = {outgoing, sign * b(k)},
                         .words = "the next block goes on with what B has after Q_k",
                         .indices = both_from_one});
  return kernel.consequence({.id = id + "_step",
                             .statement = {outgoing, incoming},
                             .words = "A and C stop, and the next block has it all: a(k) = c'(k) = "
                                      "0, b(k) = V, whatever k is",
                             .indices = both_from_one},
                            {{goes, 1}, {ratios.magic_b, sign}, {comes, -1}});
}

}  // namespace

void chain(Kernel& kernel, const Contact& contact, const Ratios& ratios,
           const Unfolding& unfolding) {
  const ex j = symbol("j"), K = symbol("K"), M = symbol("M");
  const Theorem one_at_a_time = room(kernel, ratios, unfolding);
  const auto through = [&](const std::string& id, const Theorem& step, const ex& element,
                           const char* words) {
    const Theorem all = kernel.unchanged_through_runs(
        {.id = id,
         .statement = {element, element.subs(j == 1)},
         .words = "block by block, each with a magic ratio of its own",
         .label = "sec:result",
         .indices = j_from_one},
        step, j, {one_at_a_time});
    return kernel.instance({.id = id + "_last",
                            .statement = {element.subs(j == K), element.subs(j == 1)},
                            .words = words,
                            .label = "sec:result",
                            .indices = K_from_one},
                           all, {{j, K}});
  };
  const Theorem there =
      through("chain.there",
              run(kernel, "chain.there", v(j), v(j + 1), 1, ratios,
                  "block A_j comes in with v(j), all ahead of it at rest: a run with V = v(j)"),
              v(j), "the last of K blocks has the velocity of the first");
  kernel.consequence({.id = "chain.momentum",
                      .statement = {M * v(K), M * v(1)},
                      .words = "all momentum arrives",
                      .label = "sec:result",
                      .indices = K_from_one},
                     {{there, M}});
  kernel.consequence({.id = "chain.energy",
                      .statement = {M * pow(v(K), 2) / 2, M * pow(v(1), 2) / 2},
                      .words = "and all energy",
                      .label = "sec:result",
                      .indices = K_from_one},
                     {{there, M * (v(K) + v(1)) / 2}});

  // At an elastic wall.
  const Theorem energy = kernel.hypothesis({.id = "chain.wall_energy",
                                            .statement = {pow(w(1), 2), pow(v(K), 2)},
                                            .words = "a wall at rest keeps the energy",
                                            .indices = K_from_one});
  const Theorem changes = kernel.hypothesis({.id = "chain.wall_changes",
                                             .statement = {w(1), Relation::not_equal, v(K)},
                                             .words = "and the block bounces",
                                             .indices = K_from_one});
  const Theorem wall =
      kernel.cancellation({.id = "chain.wall",
                           .statement = {w(1), -v(K)},
                           .words = "so the velocity turns round",
                           .indices = K_from_one},
                          kernel.consequence({.id = "chain.wall_product",
                                              .statement = {(w(1) - v(K)) * (w(1) + v(K)), 0},
                                              .words = "the energy, factored",
                                              .indices = K_from_one},
                                             {{energy, 1}}),
                          w(1) - v(K), changes);

  // Back: the laws are the same in a mirror.
  const auto mirrored = [&](const char* id, const Theorem& law, int sign, const char* words) {
    GiNaC::exmap negated;
    for (const char* name : {"u_1", "u_2", "v_1", "v_2"}) negated[symbol(name)] = -symbol(name);
    kernel.consequence(
        {.id = id, .statement = {law.lhs().subs(negated), law.rhs().subs(negated)}, .words = words},
        {{law, sign}});
  };
  mirrored("chain.mirror_momentum", contact.momentum, -1,
           "all velocities turned round, momentum is conserved as well");
  mirrored("chain.mirror_energy", contact.energy, 1, "and so is energy");
  const Theorem back = through(
      "chain.back",
      run(kernel, "chain.back", w(j), w(j + 1), -1, ratios,
          "the way back is the mirror image: blocks counted from the wall, a run with V = -w(j)"),
      w(j), "the first block has what came from the wall");
  kernel.consequence({.id = "chain.round_trip",
                      .statement = {w(K), -v(1)},
                      .words = "after the round trip A_1 has its velocity back, turned round",
                      .label = "sec:result",
                      .indices = K_from_one},
                     {{back, 1}, {wall, 1}, {there, -1}});
}

}  // namespace magicmass::derivation
