// SPDX-License-Identifier: GPL-2.0-or-later
// The wedge theorem's special cases: equal blocks, elastic contacts between them, and a wall.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "derivation/wedge.hpp"
#include "proof/families.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::Pi;

namespace {

ex put_in(const ex& e, const Kernel::Values& values) {
  GiNaC::exmap replacements;
  for (const auto& [name, value] : values) replacements[name] = value;
  return e.subs(replacements);
}

EqualBlocks equal_blocks(Kernel& kernel, const Wedge& wedge, const Paper& paper) {
  const ex n = symbol("n"), e = symbol("e"), alpha = symbol("alpha"), M = symbol("M"),
           h = symbol("h_e"), V = symbol("V"), V_CM = symbol("V_CM"), L = symbol("L");
  const ex share = 1 / (1 + alpha);
  const Kernel::Values blocks{{symbol("mu_A"), share},
                              {symbol("mu_B"), share},
                              {symbol("M_A"), M},
                              {symbol("M_B"), M},
                              {symbol("m"), alpha * M}};
  const std::vector<Statement> assuming{
      {4 * e * pow(1 + alpha, 2), Relation::greater, pow(1 + e, 2)}};
  const auto law = [&](const std::string& name, const Theorem& general, const ex& scale) {
    const std::string label = "sec:result, inelastic " + name;
    std::string id = "special_cases.equal_" + name;
    for (char& character : id)
      if (character == ' ') character = '_';
    const Theorem special = kernel.instance(
        {.id = id + "_shares",
         .statement = {put_in(general.lhs(), blocks), put_in(general.rhs(), blocks)},
         .words = "between equal blocks",
         .indices = from_one},
        general, blocks);
    kernel.consequence({.id = id,
                        .statement = paper.at(label),
                        .words = "as the paper writes it",
                        .label = label,
                        .indices = from_one},
                       {{special, scale}});
  };
  law("P momentum", wedge.events.momentum_P, 1 + alpha);
  law("P restitution", wedge.events.restitution_P, -1);
  law("Q momentum", wedge.events.momentum_Q, 1 + alpha);
  law("Q restitution", wedge.events.restitution_Q, 1);

  const Theorem angle = kernel.definition({.id = "special_cases.h_e",
                                           .statement = {h, put_in(wedge.theorem.h.rhs(), blocks)},
                                           .words = "the angle of the wedge for equal blocks",
                                           .assuming = assuming});
  kernel.identity({.id = "special_cases.cos_h_e",
                   .statement = {cos(h), (1 + e) / (2 * sqrt(e) * (1 + alpha))},
                   .words = "its cosine",
                   .assuming = assuming});
  const auto special = [&](const std::string& name, const Theorem& general, const ex& form,
                           const Indices& indices, const char* words) {
    return kernel.instance({.id = "special_cases." + name,
                            .statement = {put_in(general.lhs(), blocks), form},
                            .words = words,
                            .indices = indices,
                            .assuming = assuming},
                           general, blocks);
  };
  const auto sine = [&](const ex& multiple) { return sin(multiple * h) / sin(h); };
  const ex y = pow(e, n) * sine(2 * n + 1), x = pow(e, n) * sqrt(e) * sine(2 * n);
  const ex y_before = pow(e, n) * sine(2 * n - 1), unit = L / (V * sqrt(e));
  const ex growth = pow(e, n - 1);
  const char* const words = "equal blocks, any restitution for which the collisions end";
  const Theorem of_A =
      special("a_e", wedge.velocities.v_A, V_CM * (1 + (1 + alpha) * y - x), from_zero, words);
  const Theorem of_B =
      special("b_e", wedge.velocities.v_B, V_CM * (1 + (1 + alpha) * x - y), from_zero, words);
  const Theorem of_C =
      special("c_e", wedge.velocities.v_C,
              V_CM * (1 + (1 + alpha) * y - x + (2 + alpha) * y_before), from_one, words);
  const Theorem of_C_prime =
      special("c_prime_e", wedge.velocities.v_C_prime, V_CM * (1 - y - x), from_zero, words);
  const Theorem count = special("N_e", wedge.theorem.N_C, ceiling(Pi / h) - 1, {}, words);
  const Theorem tau_P_n =
      special("tau_P_e", wedge.solution.tau_P, unit * sin((2 * n - 2) * h) / sin((2 * n - 1) * h),
              from_one, words);
  const Theorem tau_Q_n = special("tau_Q_e", wedge.solution.tau_Q,
                                  unit * sin((2 * n - 1) * h) / sin(2 * n * h), from_one, words);
  const Theorem d_P_n =
      special("d_P_e", wedge.solution.d_P, L * growth / sine(2 * n - 1), from_one, words);
  const Theorem d_Q_n =
      special("d_Q_e", wedge.solution.d_Q, L * growth * sqrt(e) / sine(2 * n), from_one, words);
  return {angle, of_A, of_B, of_C, of_C_prime, count, tau_P_n, tau_Q_n, d_P_n, d_Q_n};
}

void elastic(Kernel& kernel, const EqualBlocks& equal, const Power& power, const Counting& counting,
             const Times& times) {
  const ex n = symbol("n"), e = symbol("e"), psi = symbol("psi"), h = symbol("h_e");
  const Kernel::Values one{{e, ex(1)}};
  const ex angle_there = put_in(equal.h.rhs(), one);
  const Theorem half_psi = kernel.equal_angles({.id = "special_cases.h_elastic",
                                                .statement = {angle_there, psi / 2},
                                                .words = "at e = 1 the wedge has the angle psi/2"});
  const auto same = [&](const std::string& name, const Theorem& general, const Theorem& known,
                        const ex& element, const Indices& indices) {
    const ex left = put_in(general.lhs(), one);
    const Theorem there =
        kernel.instance({.id = "special_cases." + name + "_at_one",
                         .statement = {left, put_in(general.rhs().subs(h == equal.h.rhs()), one)},
                         .words = "at e = 1",
                         .indices = indices},
                        general, one);
    kernel.rewriting({.id = "special_cases." + name + "_elastic",
                      .statement = {left, element},
                      .words = "what elastic contacts gave",
                      .indices = indices},
                     {there, half_psi, known});
  };
  same("a", equal.a, power.a, a(n), from_zero);
  same("b", equal.b, power.b, b(n), from_zero);
  same("c", equal.c, power.c, c(n), from_one);
  same("c_prime", equal.c_prime, power.c_prime, c_prime(n), from_zero);
  same("N", equal.N_C, counting.N, symbol("N"), {});
  same("t_P", equal.tau_P, times.t_P, t_P(n), from_one);
  same("t_Q", equal.tau_Q, times.t_Q, t_Q(n), from_one);
  same("s_P", equal.d_P, times.s_P, s_P(n), from_one);
  same("s_Q", equal.d_Q, times.s_Q, s_Q(n), from_one);
}

void wall(Kernel& kernel, const Wedge& wedge, const Restitution& contact) {
  const ex n = symbol("n"), k = symbol("k"), e = symbol("e"), p = symbol("p");
  const ex M_1 = symbol("M_1"), M_A = symbol("M_A"), M_B = symbol("M_B"), m = symbol("m");
  const ex mu_A = symbol("mu_A"), mu_B = symbol("mu_B"), h = symbol("h_w"), V = symbol("V");
  const ex u_1 = symbol("u_1"), u_2 = symbol("u_2"), v_2 = symbol("v_2");

  // A block that grows without bound is a wall.
  const auto limit = [&](const char* id, const ex& f, const ex& mass, const ex& value,
                         const char* words) {
    kernel.limit({.id = id, .statement = {limit_at_infinity(f, mass), value}, .words = words},
                 std::nullopt, f.subs(mass == 1 / p), p, 1 / mass);
  };
  const Theorem off_wall = kernel.consequence({.id = "special_cases.off_wall",
                                               .statement = {v_2, u_1 + e * (u_1 - u_2)},
                                               .words = "off a wall, which does not move",
                                               .indices = {}},
                                              {{contact.restitution, 1}, {wedge.events.wall, 1}});
  limit("special_cases.heavy_block", contact.v_1.rhs(), M_1, wedge.events.wall.rhs(),
        "a block that grows without bound stays as it is");
  limit("special_cases.off_heavy_block", contact.v_2.rhs(), M_1, off_wall.rhs(),
        "and the ball leaves it as it leaves a wall");
  limit("special_cases.share_of_heavy_block", M_B / (M_B + m), M_B, 1,
        "its share is that of a wall");

  const Kernel::Values still{{mu_B, ex(1)}};
  const std::vector<Statement> assuming{{4 * e, Relation::greater, pow(1 + e, 2) * mu_A}};
  const Theorem angle = kernel.definition({.id = "special_cases.h_w",
                                           .statement = {h, put_in(wedge.theorem.h.rhs(), still)},
                                           .words = "the angle of the wedge with a wall",
                                           .assuming = assuming});
  const auto at_wall = [&](const std::string& name, const Theorem& general, const ex& form,
                           const Indices& indices, const char* words) {
    return kernel.instance({.id = "special_cases." + name,
                            .statement = {put_in(general.lhs(), still), form},
                            .words = words,
                            .indices = indices,
                            .assuming = assuming},
                           general, still);
  };
  const auto sine = [&](const ex& multiple) { return sin(multiple * h) / sin(h); };
  const ex out = V * pow(e, n) * sqrt(e * mu_A) * sine(2 * n);  // g = 1/sqrt(mu_A)
  at_wall("wall_B", wedge.velocities.v_B, 0, from_zero, "the wall is where it was");
  at_wall("wall_A", wedge.velocities.v_A, V * pow(e, n) * sine(2 * n + 1) - out, from_zero,
          "the block in front of it");
  at_wall("wall_C_prime", wedge.velocities.v_C_prime, -out, from_zero, "the ball after Q_n");
  at_wall("wall_C", wedge.velocities.v_C, out / e, from_one, "the ball after P_n");
  const Theorem count = at_wall("wall_N", wedge.theorem.N_C, ceiling(Pi / h) - 1, {},
                                "collisions with the block and the wall");

  // Elastic, M_A = 100^k m: the digits of pi.
  const Kernel::Values elastic_masses{{e, ex(1)}, {mu_A, M_A / (M_A + m)}};
  const ex written = put_in(angle.rhs(), elastic_masses);
  const Theorem plain = kernel.instance(
      {.id = "special_cases.wall_N_elastic_angle",
       .statement = {put_in(count.lhs(), elastic_masses), ceiling(Pi / written) - 1},
       .words = "elastic contacts"},
      count, elastic_masses);
  const Theorem slope = kernel.equal_angles({.id = "special_cases.wall_angle",
                                             .statement = {written, atan(sqrt(m / M_A))},
                                             .words = "its tangent is sqrt(m/M_A)"});
  const Theorem elastic_count =
      kernel.rewriting({.id = "special_cases.wall_N_elastic",
                        .statement = {plain.lhs(), ceiling(Pi / atan(sqrt(m / M_A))) - 1},
                        .words = "collisions of a ball between a block and a wall"},
                       {plain, slope});
  const ex ten = ex(10);
  const Kernel::Values digits{{M_A, pow(ten, 2 * k) * m}};
  kernel.instance(
      {.id = "special_cases.digits_of_pi",
       .statement = {put_in(elastic_count.lhs(), digits), ceiling(Pi / atan(pow(ten, -k))) - 1},
       .words = "with a block of 100^k times the ball's mass these are digits of pi",
       .indices = {{"k", 0}}},
      elastic_count, digits);
}

}  // namespace

EqualBlocks special_cases(Kernel& kernel, const Wedge& wedge, const Restitution& contact,
                          const Power& power, const Counting& counting, const Times& times,
                          const Paper& paper) {
  const EqualBlocks equal = equal_blocks(kernel, wedge, paper);
  elastic(kernel, equal, power, counting, times);
  wall(kernel, wedge, contact);
  return equal;
}

}  // namespace magicmass::derivation
