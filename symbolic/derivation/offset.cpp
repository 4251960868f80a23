// SPDX-License-Identifier: GPL-2.0-or-later
// Terminal velocities from how far the last cycle's angle is from a quarter turn.
#include <vector>

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

// What the last collision is, and the bounds on angles that then say 0 <= r_t and r_t <= psi/4.
struct Case {
  std::string name;
  Theorem counts;
  ex c_t;
  Theorem above_zero, up_to_quarter;
};

}  // namespace

void offset(Kernel& kernel, const Power& power, const Counting& counting,
            const Terminal& terminal) {
  const ex alpha = symbol("alpha"), psi = symbol("psi"), V = symbol("V"), V_CM = symbol("V_CM");
  const ex N_A = symbol("N_A"), N_B = symbol("N_B"), is_P = symbol("is_P"), r = symbol("r_t"),
           rho = symbol("rho");
  const ex t = symbol("tan_quarter"), cotangent = symbol("cot_half");
  const ex a_t = a(N_A), b_t = b(N_B);

  const Theorem which =
      kernel.definition({.id = "offset.is_P",
                         .statement = {is_P, N_A - N_B},
                         .words = "1 when the last collision is a P, 0 when it is a Q",
                         .indices = last_collisions});
  const Theorem meaning =
      kernel.definition({.id = "offset.r_t",
                         .statement = {r, (1 - 2 * is_P) * (Pi / 2 - N_A * psi / 2)},
                         .words = "from N_A psi/2 to a quarter turn, or back from there",
                         .indices = last_collisions});
  const Theorem turn =
      kernel.definition({.id = "offset.turn",
                         .statement = {symbol("turn"), 1 - 2 * is_P},
                         .words = "1 when the last collision is a Q, -1 when it is a P",
                         .indices = last_collisions});
  kernel.rewriting({.id = "offset.r_from_turn",
                    .statement = {r, symbol("turn") * (Pi / 2 - N_A * psi / 2)},
                    .words = "the offset with its sign",
                    .indices = last_collisions},
                   {meaning, turn});
  kernel.definition({.id = "offset.rho",
                     .statement = {rho, pow(b_t / V, 2)},
                     .words = "the fraction of the energy that B takes",
                     .indices = last_collisions});

  const ex S = sin(r), C = cos(r);
  // a_t, and the ball's part of the momentum: without a quotient, and the blocks' part is what it leaves.
  const ex velocity_of_A = symbol("velocity_A"), momentum_of_C = symbol("momentum_C");
  const Theorem of_A =
      kernel.definition({.id = "offset.velocity_A",
                         .statement = {velocity_of_A, V * (S - t * C) * (S + t * C)},
                         .words = "from the sine and the cosine of the offset",
                         .indices = last_collisions});
  const Theorem of_C = kernel.definition({.id = "offset.momentum_C",
                                          .statement = {momentum_of_C, 2 * V * t * C * (t * C - S)},
                                          .words = "alpha times a velocity, as will be seen",
                                          .indices = last_collisions});
  for (const Case& at_last :
       {Case{"after_Q", counting.equal, c_prime(N_B), terminal.not_before, terminal.A_reached},
        Case{"after_P", counting.one_more_above_half, c(N_A), terminal.reached,
             terminal.A_not_before},
        Case{"after_P_whole", counting.one_more_at_zero, c(N_A), terminal.reached,
             terminal.A_not_before}}) {
    const auto velocity = [&](const std::string& name, const ex& element, const ex& form,
                              const Theorem& closed, std::vector<Theorem> from = {}) {
      from.insert(from.end(), {meaning, which, at_last.counts, closed});
      kernel.rewriting({.id = "offset." + name + "_" + at_last.name,
                        .statement = {element, form},
                        .words = "from the sine and the cosine of the offset",
                        .indices = last_collisions},
                       from);
    };
    velocity("a", a_t, V * (S - t * C) * (S + t * C), power.a);
    velocity("b", b_t, 2 * C * (V_CM * C + V * t * S), power.b);
    velocity("b_product", b_t, 2 * V * (t * C) * (cotangent * C + S), power.b);
    const Theorem& of_c = at_last.name == "after_Q" ? power.c_prime : power.c;
    velocity("c", at_last.c_t, 2 * V * cotangent * C * (t * C - S), of_c);
    velocity("b_from_momentum", b_t, V - velocity_of_A - momentum_of_C, power.b, {of_A, of_C});
    velocity("b_from_square", b_t, V * (1 - pow(t * C - S, 2)), power.b);
    velocity("c_from_momentum", at_last.c_t, momentum_of_C / alpha, of_c, {of_C});
    const auto bound = [&](const std::string& name, const Statement& statement,
                           const Theorem& angles, const char* words) {
      kernel.ordering({.id = "offset." + name + "_" + at_last.name,
                       .statement = statement,
                       .words = words,
                       .indices = last_collisions},
                      {{numeric(1, 2), {angles}, 1}}, {meaning, which, at_last.counts});
    };
    bound("not_negative", {0, Relation::less_equal, r}, at_last.above_zero,
          "the counts see to its sign");
    bound("at_most", {r, Relation::less_equal, psi / 4}, at_last.up_to_quarter,
          "and it is a quarter of psi at most");
  }
}

}  // namespace magicmass::derivation
