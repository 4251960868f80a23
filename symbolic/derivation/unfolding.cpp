// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 11, the other way: instead of reflecting the ball at a wall, reflect the wedge. The motion is then
// one straight line across the rays at angles h, 2 h, 3 h, ..., h = psi/2; when and where follow.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

namespace {

// What the first collisions did to the velocities is undone by reflecting back: the same straight motion.
void reflections(Kernel& kernel, const Cycle& cycle, const Mapping& mapping,
                 const std::vector<Theorem>& at_P, const std::vector<Theorem>& at_Q) {
  const ex n = symbol("n"), alpha = symbol("alpha"), psi = symbol("psi"), V = symbol("V");
  const ex root = sqrt(alpha), scale = sqrt((1 + alpha) / (2 + alpha));
  const ex &d_B = mapping.along_B.rhs(), &n_B = mapping.across_B.rhs();
  // The plane across the axis, seen along and across wall B. There wall A is the ray at psi/2.
  const ex plane = columns({d_B, n_B});
  const auto seen = [&](const ex& column) { return (transpose(plane) * column).evalm(); };
  const auto mirror = [](const ex& angle) {  // in the ray at angle/2
    return ex(matrix{{cos(angle), sin(angle)}, {sin(angle), -cos(angle)}});
  };
  const auto in_plane = [&](const char* id, const Theorem& collision, const ex& matrix_there,
                            const char* shown, const char* words) {
    kernel.identity(
        {.id = id,
         .statement = {(collision.rhs() * plane).evalm(), (plane * matrix_there).evalm()},
         .words = words,
         .label = "sec:comparison",
         .shown_lhs = shown});
  };
  in_plane("unfolding.mirror_A", cycle.Gamma_A, mirror(psi), "Gamma_A (d_B n_B)",
           "the collision of A and C is the reflection in the ray at psi/2");
  in_plane("unfolding.mirror_B", cycle.Gamma_B, mirror(0), "Gamma_B (d_B n_B)",
           "that of C and B the one in the ray at 0");
  // Undone in turn, the last one first: before P_n there were n - 1 pairs, before Q_n also that at P_n.
  const ex before_P = plane_rotation((n - 1) * psi), before_Q = mirror(n * psi);
  kernel.identity({.id = "unfolding.pair",
                   .statement = {(mirror(psi) * mirror(0)).evalm(), plane_rotation(psi)},
                   .words = "a pair, undone, turns by psi; so n - 1 pairs turn by (n - 1) psi",
                   .shown_rhs = "lambda(psi)"});
  kernel.identity(
      {.id = "unfolding.and_one",
       .statement = {(before_P * mirror(psi)).evalm(), before_Q},
       .words = "and with P_n undone first",
       .indices = from_one,
       .shown_lhs = "lambda((n - 1)*psi) [[cos(psi), sin(psi)], [sin(psi), -cos(psi)]]"});
  const ex start = seen(matrix{{V}, {0}, {0}});
  kernel.identity({.id = "unfolding.parallel",
                   .statement = {start, (scale * matrix{{-V}, {0}}).evalm()},
                   .words = "C and B start at rest to each other: along wall B, towards its end",
                   .label = "sec:comparison",
                   .shown_lhs = "(d_B n_B)^T [[V], [0], [0]]"});
  const auto turned = [&](const char* id, const ex& back, const ex& velocities, const char* shown,
                          const std::vector<Theorem>& closed, const Indices& indices) {
    kernel.rewriting(
        {.id = id,
         .statement = {seen(velocities), (scale * transpose(back) * matrix{{-V}, {0}}).evalm()},
         .words = "it is that at the start, reflected: undone, the motion is a straight line",
         .label = "sec:comparison",
         .indices = indices,
         .shown_lhs = shown},
        closed);
  };
  turned("unfolding.velocity_P", before_P, matrix{{a(n - 1)}, {b(n - 1)}, {root * c_prime(n - 1)}},
         "(d_B n_B)^T [[a(n - 1)], [b(n - 1)], [sqrt(alpha)*c'(n - 1)]]", at_P, from_two);
  turned("unfolding.velocity_Q", before_Q, matrix{{a(n)}, {b(n - 1)}, {root * c(n)}},
         "(d_B n_B)^T [[a(n)], [b(n - 1)], [sqrt(alpha)*c(n)]]", at_Q, from_one);
  const auto point = [&](const char* id, const ex& back, const ex& position, const ex& distance,
                         const ex& angle, const char* shown, const char* words) {
    kernel.identity({.id = id,
                     .statement = {(back * seen(position)).evalm(),
                                   (scale * distance * matrix{{cos(angle)}, {sin(angle)}}).evalm()},
                     .words = words,
                     .indices = from_one,
                     .shown_lhs = shown});
  };
  point("unfolding.point_P", before_P, matrix{{0}, {s_P(n)}, {0}}, s_P(n), (2 * n - 1) * psi / 2,
        "unfolded: A and C together, B s_P(n) ahead",
        "P_n is on the ray at (2 n - 1) psi/2, as far out as A and B are apart");
  point("unfolding.point_Q", before_Q, matrix{{-s_Q(n)}, {0}, {0}}, s_Q(n), n * psi,
        "unfolded: C and B together, A s_Q(n) behind", "and Q_n on the ray at n psi");
}

}  // namespace

Unfolding unfolding(Kernel& kernel, const Cycle& cycle, const Power& power, const Mapping& mapping,
                    const Times& times) {
  const ex n = symbol("n"), j = symbol("j"), psi = symbol("psi"), L = symbol("L"), V = symbol("V");
  // The ball's velocities from the approach speeds.
  const Theorem c_n = kernel.consequence({.id = "unfolding.c",
                                          .statement = {c(n), b(n - 1) + times.towards_B.rhs()},
                                          .words = "the ball's velocity towards B",
                                          .indices = from_one},
                                         {{times.towards_B, 1}});
  const Theorem c_prime_n =
      kernel.consequence({.id = "unfolding.c_prime",
                          .statement = {c_prime(n - 1), a(n - 1) - times.towards_A.rhs()},
                          .words = "and towards A",
                          .indices = from_two},
                         {{times.towards_A, -1}});
  const std::vector<Theorem> at_Q{c_n, power.a, power.b}, at_P{c_prime_n, power.a, power.b};
  reflections(kernel, cycle, mapping, at_P, at_Q);
  const auto angle_P = [&](const ex& index) { return (2 * index - 1) * psi / 2; };
  const auto angle_Q = [&](const ex& index) { return index * psi; };

  // Each flight, from uniform motion alone: the distances are relative speeds times its duration.
  const auto leg = [&](const std::string& id, const Theorem& crossing, const Theorem& gap,
                       const ex& s_before, const ex& s_after, const ex& angle_before,
                       const ex& angle_after, const ex& departure, const ex& arrival,
                       const std::vector<Theorem>& closed, const Indices& indices) {
    const ex duration = arrival - departure;
    const ex start = crossing.lhs(), end = start + gap.rhs();
    const ex start_speed = start / duration, end_speed = start_speed + gap.rhs() / duration;
    const Theorem first = kernel.consequence({.id = id + "_start",
                                              .statement = {s_before, start},
                                              .words = "the ball crosses this distance",
                                              .indices = indices},
                                             {{crossing, -1}});
    const Theorem second = kernel.consequence({.id = id + "_end",
                                               .statement = {s_after, end},
                                               .words = "and this one is left",
                                               .indices = indices},
                                              {{gap, 1}, {first, 1}});
    const auto coordinate = [&](const char* name, const ex& speed, const ex& part_before,
                                const ex& part_after, const char* words) {
      const Theorem moved = kernel.rewriting(
          {.id = id + name + "_speeds",
           .statement = {end_speed * part_after + speed, start_speed * part_before},
           .words = "with the velocities put in",
           .indices = indices},
          closed);
      return kernel.consequence({.id = id + name,
                                 .statement = {s_after * part_after + speed * arrival,
                                               s_before * part_before + speed * departure},
                                 .words = words,
                                 .indices = indices},
                                {{second, part_after}, {first, -part_before}, {moved, duration}});
    };
    return std::pair{
        coordinate("_along", V, cos(angle_before), cos(angle_after),
                   "along the line: the point has moved by V times the duration"),
        coordinate("_across", 0, sin(angle_before), sin(angle_after), "across it: not at all")};
  };
  const auto to_Q = leg("unfolding.PQ", times.to_B, times.gap_Q, s_P(n), s_Q(n), angle_P(n),
                        angle_Q(n), t_P(n), t_Q(n), at_Q, from_one);
  const auto to_P = leg("unfolding.QP", times.to_A, times.gap_P, s_Q(n - 1), s_P(n), angle_Q(n - 1),
                        angle_P(n), t_Q(n - 1), t_P(n), at_P, from_two);

  // The line: X_P and Y_P never change.
  const auto line = [&](const std::string& name, const ex& element, const ex& meaning,
                        const Theorem& out, const Theorem& back, const Theorem& start_s,
                        const Theorem& start_t) {
    const std::string id = "unfolding." + name;
    const Theorem named = kernel.definition({.id = id,
                                             .statement = {element, meaning},
                                             .words = "the line's coordinate, as seen at P_n",
                                             .indices = from_one});
    const auto earlier = [&](const Theorem& general, const char* suffix) {
      return kernel.instance(
          {.id = id + suffix,
           .statement = {general.lhs().subs(n == n - 1), general.rhs().subs(n == n - 1)},
           .words = "one cycle earlier",
           .indices = from_two},
          general, {{n, n - 1}});
    };
    const Theorem before = earlier(named, "_before"), out_before = earlier(out, "_out");
    const Theorem next = kernel.consequence({.id = id + "_next",
                                             .statement = {element, before.lhs()},
                                             .words = "out to B and back: the same line",
                                             .indices = from_two},
                                            {{named, 1}, {before, -1}, {back, 1}, {out_before, 1}});
    const Theorem first = kernel.rewriting(
        {
            .id = id + "_1",
            .statement = {element.subs(n == 1),
                          meaning.subs(n == 1).subs(GiNaC::lst{start_s.lhs() == start_s.rhs(),
                                                               start_t.lhs() == start_t.rhs()})},
            .words = "at the first collision",
        },
        {named, start_s, start_t});
    return std::tuple{named, first, next};
  };
  const auto [X, X_1, X_next] = line("X", X_P(n), s_P(n) * cos(angle_P(n)) + V * t_P(n), to_Q.first,
                                     to_P.first, times.s_1, times.t_1);
  const auto [Y, Y_1, Y_next] =
      line("Y", Y_P(n), s_P(n) * sin(angle_P(n)), to_Q.second, to_P.second, times.s_1, times.t_1);
  const Theorem line_n = kernel.induction(
      {.id = "unfolding.line",
       .statement = {matrix{{X_P(n)}, {Y_P(n)}}, matrix{{L * cos(psi / 2)}, {L * sin(psi / 2)}}},
       .words = "by induction: one straight line, L sin(psi/2) from the edge",
       .indices = from_one},
      {X_1, Y_1}, {X_next, Y_next}, n);
  const Theorem X_n = kernel.component({.id = "unfolding.X_n",
                                        .statement = {X_P(n), L * cos(psi / 2)},
                                        .words = "along",
                                        .indices = from_one},
                                       line_n, 0);
  const Theorem Y_n = kernel.component({.id = "unfolding.Y_n",
                                        .statement = {Y_P(n), L * sin(psi / 2)},
                                        .words = "across",
                                        .indices = from_one},
                                       line_n, 1);

  // A line that is L sin(h) from the edge meets the ray at (j + 1) h there and then:
  const ex r = symbol("r"), tau = symbol("tau"), ray = (j + 1) * psi / 2;
  const Theorem across = kernel.hypothesis({.id = "unfolding.on_ray_across",
                                            .statement = {r * sin(ray), L * sin(psi / 2)},
                                            .words = "a point of the line on that ray, r out",
                                            .indices = j_from_zero});
  const Theorem along = kernel.hypothesis({.id = "unfolding.on_ray_along",
                                           .statement = {r * cos(ray) + V * tau, L * cos(psi / 2)},
                                           .words = "reached at time tau",
                                           .indices = j_from_zero});
  kernel.rewriting({.id = "unfolding.where",
                    .statement = {r, s(j)},
                    .words = "the distance from the edge is s_j",
                    .indices = j_from_zero},
                   {kernel.consequence({.id = "unfolding.where_solved",
                                        .statement = {r, L * sin(psi / 2) / sin(ray)},
                                        .words = "solved for r",
                                        .indices = j_from_zero},
                                       {{across, 1 / sin(ray)}}),
                    times.s});
  kernel.rewriting(
      {.id = "unfolding.when",
       .statement = {tau, t(j)},
       .words = "and the time is t_j",
       .indices = j_from_zero},
      {kernel.consequence(
           {.id = "unfolding.when_solved",
            .statement = {tau, L / V * (cos(psi / 2) - sin(psi / 2) * cos(ray) / sin(ray))},
            .words = "solved for tau",
            .indices = j_from_zero},
           {{along, 1 / V}, {across, -cos(ray) / (V * sin(ray))}}),
       times.t});
  // The collisions are such points: the ray of P_n has j = 2 n - 2 and that of Q_n has j = 2 n - 1.
  const auto found = [&](const char* id, const ex& element, const ex& counted, const ex& angle,
                         const Kernel::Combination& premises, const ex& scale,
                         const Theorem& general) {
    Kernel::Combination scaled;
    for (const auto& [premise, cofactor] : premises)
      scaled.emplace_back(premise, cofactor * scale / sin(angle));
    const ex solved = general.rhs().subs(j == counted);
    const Theorem line_meets = kernel.consequence({.id = std::string(id) + "_solved",
                                                   .statement = {element, solved},
                                                   .words = "from the straight line",
                                                   .indices = from_one},
                                                  scaled);
    kernel.rewriting({.id = id,
                      .statement = {element, general.lhs().subs(j == counted)},
                      .words = "the collision's, without the recurrence over the collisions",
                      .indices = from_one},
                     {line_meets, general});
    return line_meets;
  };
  const ex P = angle_P(n), Q = angle_Q(n);
  found("unfolding.s_of_P", s_P(n), 2 * n - 2, P, {{Y_n, 1}, {Y, -1}}, 1, times.s);
  found("unfolding.t_of_P", t_P(n), 2 * n - 2, P,
        {{X_n, sin(P)}, {X, -sin(P)}, {Y_n, -cos(P)}, {Y, cos(P)}}, 1 / V, times.t);
  const Theorem s_of_Q = found("unfolding.s_of_Q", s_Q(n), 2 * n - 1, Q,
                               {{Y_n, 1}, {Y, -1}, {to_Q.second, 1}}, 1, times.s);
  const Theorem t_of_Q = found("unfolding.t_of_Q", t_Q(n), 2 * n - 1, Q,
                               {{X_n, sin(Q)},
                                {X, -sin(Q)},
                                {to_Q.first, sin(Q)},
                                {Y_n, -cos(Q)},
                                {Y, cos(Q)},
                                {to_Q.second, -cos(Q)}},
                               1 / V, times.t);
  return {t_of_Q, s_of_Q};
}

}  // namespace magicmass::derivation
