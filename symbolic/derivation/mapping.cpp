// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 3, the comparison of sec:comparison: velocities times the square roots of the masses make a
// billiard ball's velocity, and collisions are its reflections. Masses are any.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

namespace {

ex product(const ex& x, const ex& y) { return (transpose(x) * y).evalm().op(0); }
ex reflection(const ex& normal) {
  return (unit(static_cast<unsigned>(normal.nops())) - 2 * (normal * transpose(normal))).evalm();
}

// Two bodies: what Redner asks for and what the covariant rule says are the same.
void two_bodies(Kernel& kernel, const Contact& contact, const Paper& paper) {
  const ex M_1 = symbol("M_1"), M_2 = symbol("M_2");
  const ex w_1 = symbol("w_1"), w_2 = symbol("w_2"), after_1 = symbol("w_1_after"),
           after_2 = symbol("w_2_after");
  const ex along_1 = sqrt(M_1), along_2 = sqrt(M_2), size = sqrt(M_1 + M_2);
  const matrix normal{{along_2 / size}, {-along_1 / size}};
  const ex rule = reflection(normal);
  const matrix before{{w_1}, {w_2}}, after{{after_1}, {after_2}};

  kernel.consequence({.id = "mapping.projection",
                      .statement = paper.at("sec:comparison, projection"),
                      .words = "momentum, in w_i = sqrt(m_i) v_i: the projection on the roots of "
                               "the masses is kept",
                      .label = "sec:comparison, projection",
                      .shown_lhs = "(sqrt(M_1), sqrt(M_2)) . (w_1, w_2)",
                      .shown_rhs = "(sqrt(M_1), sqrt(M_2)) . (w_1', w_2')"},
                     {{contact.momentum, 1}});
  kernel.identity(
      {.id = "mapping.normal",
       .statement = {product(normal, matrix{{along_1 * symbol("x_1")}, {along_2 * symbol("x_2")}}),
                     sqrt(M_1 * M_2 / (M_1 + M_2)) * (symbol("x_1") - symbol("x_2"))},
       .words = "positions sqrt(m_i) x_i: the bodies touch on the wall across n",
       .shown_lhs = "n . (sqrt(M_1)*x_1, sqrt(M_2)*x_2)"});
  kernel.rewriting(
      {.id = "mapping.collision",
       .statement = {matrix{{along_1 * contact.v_1.lhs()}, {along_2 * contact.v_2.lhs()}},
                     (rule * matrix{{along_1 * symbol("u_1")}, {along_2 * symbol("u_2")}}).evalm()},
       .words = "a collision is the reflection 1 - 2 n n^T in that wall",
       .label = "sec:comparison",
       .shown_rhs = "(1 - 2 n n^T) [[sqrt(M_1)*u_1], [sqrt(M_2)*u_2]]"},
      {contact.v_1, contact.v_2});

  // From the projection and the length to the reflection ...
  const Theorem projection = kernel.hypothesis(
      {.id = "mapping.projection_kept",
       .statement = {along_1 * w_1 + along_2 * w_2, along_1 * after_1 + along_2 * after_2},
       .words = "Redner's constraint: the projection is kept"});
  const Theorem length = kernel.hypothesis(
      {.id = "mapping.length_kept",
       .statement = {pow(w_1, 2) + pow(w_2, 2), pow(after_1, 2) + pow(after_2, 2)},
       .words = "and so is the length"});
  const Theorem changes = kernel.hypothesis({.id = "mapping.changes",
                                             .statement = {after_1, Relation::not_equal, w_1},
                                             .words = "the bodies do collide"});
  // n . w' = +-(n . w), as length^2 = projection^2/(M_1 + M_2) + (n . w)^2.
  const ex across = product(normal, before), across_after = product(normal, after);
  const ex sum_of_projections = along_1 * (w_1 + after_1) + along_2 * (w_2 + after_2);
  const Theorem squares = kernel.consequence(
      {.id = "mapping.across_squared",
       .statement = {(across_after - across) * (across_after + across), 0},
       .words = "so the component across the wall keeps its size: no change, or turned round",
       .shown_lhs = "(n.w' - n.w)*(n.w' + n.w)"},
      {{length, -1}, {projection, sum_of_projections / (M_1 + M_2)}});
  // Along the wall nothing changes: (w' - w) = (n.w' - n.w) n.
  const Theorem along =
      kernel.consequence({.id = "mapping.along",
                          .statement = {after_1 - w_1, (across_after - across) * normal.op(0)},
                          .words = "along the wall nothing changes",
                          .shown_rhs = "(n.w' - n.w)*n_1"},
                         {{projection, -along_1 / (M_1 + M_2)}});
  const Theorem turned = kernel.cancellation(
      {.id = "mapping.across",
       .statement = {across_after, -across},
       .words = "no change is no collision: it is turned round",
       .shown_lhs = "n.w'",
       .shown_rhs = "-n.w"},
      kernel.consequence({.id = "mapping.across_product",
                          .statement = {(after_1 - w_1) * (across_after + across), 0},
                          .words = "the same, times n_1",
                          .shown_lhs = "(w_1' - w_1)*(n.w' + n.w)"},
                         {{squares, normal.op(0)}, {along, across_after + across}}),
      after_1 - w_1, changes);
  const matrix reflected = GiNaC::ex_to<matrix>((rule * before).evalm());
  for (unsigned i = 0; i < 2; ++i) {
    const ex root = i == 0 ? along_1 : along_2;
    kernel.consequence({.id = "mapping.reflected_" + std::to_string(i + 1),
                        .statement = {after.op(i), reflected.op(i)},
                        .words = "which is the covariant rule",
                        .label = "sec:comparison",
                        .shown_rhs = "((1 - 2 n n^T) w)_" + std::to_string(i + 1)},
                       {{projection, -root / (M_1 + M_2)}, {turned, normal.op(i)}});
  }
  // ... and back.
  kernel.identity({.id = "mapping.projection_of_reflected",
                   .statement = {along_1 * reflected.op(0) + along_2 * reflected.op(1),
                                 along_1 * w_1 + along_2 * w_2},
                   .words = "the other way round: the reflection keeps the projection",
                   .label = "sec:comparison",
                   .shown_lhs = "(sqrt(M_1), sqrt(M_2)) . (1 - 2 n n^T) w"});
  kernel.identity(
      {.id = "mapping.length_of_reflected",
       .statement = {pow(reflected.op(0), 2) + pow(reflected.op(1), 2), pow(w_1, 2) + pow(w_2, 2)},
       .words = "and the length",
       .label = "sec:comparison",
       .shown_lhs = "|(1 - 2 n n^T) w|^2"});
}

}  // namespace

Mapping mapping(Kernel& kernel, const Contact& contact, const Cycle& cycle,
                const Rotation& rotation, const Paper& paper) {
  two_bodies(kernel, contact, paper);

  // Three bodies on (a, b, c): two walls that share the axis.
  const ex M_A = symbol("M_A"), M_B = symbol("M_B"), m = symbol("m"), M = symbol("M"),
           alpha = symbol("alpha");
  const ex total = M_A + M_B + m;
  const ex axis = matrix{{sqrt(M_A)}, {sqrt(M_B)}, {sqrt(m)}};
  const ex inward_A = (matrix{{-sqrt(m)}, {0}, {sqrt(M_A)}} / sqrt(M_A + m)).evalm();
  const ex inward_B = (matrix{{0}, {sqrt(m)}, {-sqrt(M_B)}} / sqrt(M_B + m)).evalm();
  const ex G_A = reflection(inward_A), G_B = reflection(inward_B);
  const Kernel::Values equal{{M_A, M}, {M_B, M}, {m, alpha * M}};
  const auto for_equal = [&](const ex& e) {
    GiNaC::exmap values;
    for (const auto& [name, value] : equal) values[name] = value;
    return e.subs(values, GiNaC::subs_options::no_pattern).evalm();
  };
  const auto kept = [&](const char* id, const ex& by, const char* shown, const char* words) {
    kernel.identity({.id = id,
                     .statement = {(by * axis).evalm(), axis},
                     .words = words,
                     .label = "sec:comparison",
                     .shown_lhs = std::string(shown) + " [[sqrt(M_A)], [sqrt(M_B)], [sqrt(m)]]"});
  };
  kept("mapping.axis_A", G_A, "(1 - 2 n_A n_A^T)", "the collision of A and C keeps this direction");
  kept("mapping.axis_B", G_B, "(1 - 2 n_B n_B^T)", "so does that of C and B");
  kept("mapping.axis", (G_B * G_A).evalm(), "(1 - 2 n_B n_B^T)(1 - 2 n_A n_A^T)",
       "so the axis of a cycle is parallel to the square roots of the masses");
  kernel.identity({.id = "mapping.axis_only",
                   .statement = {cross(inward_A, inward_B),
                                 (axis * (-sqrt(m) / sqrt((M_A + m) * (M_B + m)))).evalm()},
                   .words = "it is the line that the two walls share",
                   .shown_lhs = "n_A x n_B"});
  kernel.identity({.id = "mapping.axis_equal",
                   .statement = {symbol("e_3"), (for_equal(axis) / sqrt(for_equal(total))).evalm()},
                   .words = "for equal blocks, that is the axis of Lambda",
                   .label = "sec:comparison, axis",
                   .shown_rhs = "[[sqrt(M)], [sqrt(M)], [sqrt(alpha*M)]]/sqrt(2*M + alpha*M)"});
  for (const auto& [name, of_pair, reflected] :
       {std::tuple{"Gamma_A", cycle.Gamma_A, G_A}, {"Gamma_B", cycle.Gamma_B, G_B}})
    kernel.identity(
        {.id = std::string("mapping.") + name,
         .statement = {of_pair.lhs(), for_equal(reflected)},
         .words = "for equal blocks, the collision matrix is that reflection",
         .label = "sec:comparison",
         .shown_rhs = name == std::string("Gamma_A") ? "1 - 2 n_A n_A^T" : "1 - 2 n_B n_B^T"});

  // In the plane across the axis the walls are two rays from the origin; the ball is between them where
  // both inward normals have positive components. A ray along wall A is n_B less its part along n_A.
  const ex cosine = kernel.simplified(-product(inward_A, inward_B));
  const ex sine = kernel.simplified(sqrt(1 - pow(cosine, 2)));
  const Theorem h = read_off_angle(kernel, "mapping.h", symbol("h_m"), cosine, sine,
                                   "the angle whose cosine is -n_A . n_B");
  const ex ray_A = kernel.simplified(((inward_B + cosine * inward_A) / sine).evalm());
  const ex ray_B = kernel.simplified(((inward_A + cosine * inward_B) / sine).evalm());
  const auto about = [&](const std::string& name, const ex& value, const ex& expected,
                         const std::string& shown, const char* words) {
    return kernel.identity({.id = "mapping." + name,
                            .statement = {value, expected},
                            .words = words,
                            .shown_lhs = shown});
  };
  for (const auto& [name, ray, own, other] :
       {std::tuple{"A", ray_A, inward_A, inward_B}, {"B", ray_B, inward_B, inward_A}}) {
    const std::string d = std::string("d_") + name, id = std::string("ray_") + name;
    about(id + "_axis", product(ray, axis), 0, d + " . axis", "a ray across the axis ...");
    about(id + "_wall", product(ray, own), 0, d + " . n_" + name, "... on the wall");
    about(id + "_unit", product(ray, ray), 1, "|" + d + "|^2", "... of length 1");
    kernel.positivity({.id = "mapping." + id + "_side",
                       .statement = {product(ray, other), Relation::greater, 0},
                       .words = "... on the other wall's inner side",
                       .shown_lhs = d + (name == std::string("A") ? " . n_B" : " . n_A")});
  }
  const Theorem wedge =
      kernel.identity({.id = "mapping.wedge",
                       .statement = {cos(h.lhs()), sqrt(M_A * M_B / ((M_A + m) * (M_B + m)))},
                       .words = "the walls enclose the angle h_m: the cosine of d_A and d_B",
                       .label = "sec:comparison"});
  const Theorem wedge_sine = kernel.identity(
      {.id = "mapping.wedge_sine", .statement = {sin(h.lhs()), sine}, .words = "and its sine"});
  kernel.rewriting({.id = "mapping.wedge_rays",
                    .statement = {product(ray_A, ray_B), cos(h.lhs())},
                    .words = "which is the angle between the two rays",
                    .shown_lhs = "d_A . d_B"},
                   {wedge});
  // Two reflections turn by twice the angle: seen in the frame d_B, n_B, axis.
  const ex frame = columns({ray_B, inward_B, (axis / sqrt(total)).evalm()});
  kernel.identity({.id = "mapping.frame",
                   .statement = {(transpose(frame) * frame).evalm(), unit(3)},
                   .words = "a frame: the ray, the normal and the axis",
                   .shown_lhs = "F^T F",
                   .shown_rhs = "1"});
  const ex mirror_A = matrix{
      {cos(2 * h.lhs()), sin(2 * h.lhs()), 0}, {sin(2 * h.lhs()), -cos(2 * h.lhs()), 0}, {0, 0, 1}};
  const ex mirror_B = matrix{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  for (const auto& [name, collision, there] :
       {std::tuple{"A", G_A, mirror_A}, {"B", G_B, mirror_B}})
    kernel.rewriting(
        {.id = std::string("mapping.mirror_") + name,
         .statement = {(collision * frame).evalm(), (frame * there).evalm()},
         .words = name == std::string("A")
                      ? "in it, A's collision is the reflection in the ray at h_m"
                      : "and B's that in the ray at 0",
         .label = "sec:comparison",
         .shown_lhs = std::string("(1 - 2 n_") + name + " n_" + name + "^T) F",
         .shown_rhs =
             name == std::string("A")
                 ? "F [[cos(2*h_m), sin(2*h_m), 0], [sin(2*h_m), -cos(2*h_m), 0], [0, 0, 1]]"
                 : "F [[1, 0, 0], [0, -1, 0], [0, 0, 1]]"},
        {wedge, wedge_sine});
  const ex phi = symbol("phi");
  kernel.identity(
      {.id = "mapping.turn",
       .statement = {(mirror_B * mirror_A.subs(h.lhs() == phi)).evalm(), rotation_3(-2 * phi)},
       .words = "a mirror at 0 after one at an angle phi turns by 2 phi: a cycle turns by "
                "twice the wedge's angle",
       .label = "sec:comparison",
       .shown_rhs = "lambda_3(-2*phi)"});
  kernel.identity({.id = "mapping.wedge_equal",
                   .statement = {for_equal(wedge.rhs()), cos(rotation.psi.lhs() / 2)},
                   .words = "for equal blocks 1/(1 + alpha): the wedge is psi/2 wide",
                   .label = "sec:comparison"});
  const auto for_equal_blocks = [&](const char* id, const char* name, const ex& column,
                                    const char* words) {
    return kernel.definition({.id = id,
                              .statement = {symbol(name), kernel.simplified(for_equal(column))},
                              .words = words});
  };
  return {for_equal_blocks("mapping.d_B", "d_B", ray_B, "the ray along wall B, for equal blocks"),
          for_equal_blocks("mapping.n_B", "n_B", inward_B, "and the normal there")};
}

}  // namespace magicmass::derivation
