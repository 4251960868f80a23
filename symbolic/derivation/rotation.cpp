// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 3: the axis and the angle of the rotation Lambda.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

Rotation rotation(Kernel& kernel, const Cycle& cycle, const Paper& paper) {
  const ex alpha = symbol("alpha");
  const auto simplified = [&kernel](const ex& e) { return kernel.simplified(e); };
  const ex Lambda = cycle.Lambda.rhs();

  // The axis: Lambda e = e, solved for e and brought to length 1.
  const ex direction = null_vector((Lambda - unit(3)).evalm(), simplified);
  const ex length =
      sqrt(simplified(pow(direction.op(0), 2) + pow(direction.op(1), 2) + pow(direction.op(2), 2)));
  const ex e_3 = kernel.simplified((direction / length).evalm());
  kernel.definition({.id = "rotation.axis",
                     .statement = {symbol("e_3"), e_3},
                     .words = "the null vector of Lambda - 1, of length 1"});
  kernel.identity({.id = "rotation.axis_invariant",
                   .statement = {(Lambda * e_3).evalm(), e_3},
                   .words = "Lambda leaves it where it is",
                   .label = "app:lam-n, invariant axis",
                   .shown_lhs = "Lambda e_3",
                   .shown_rhs = "e_3"});
  kernel.identity({.id = "rotation.axis_unit",
                   .statement = {pow(e_3.op(0), 2) + pow(e_3.op(1), 2) + pow(e_3.op(2), 2), 1},
                   .words = "its length is 1",
                   .shown_lhs = "|e_3|^2"});
  kernel.identity({.id = "rotation.axis_paper",
                   .statement = paper.at("app:lam-n, axis"),
                   .words = "as the paper writes it",
                   .label = "app:lam-n, axis"});

  // A triad with that axis: e_1 across the old and the new third axis, made a unit vector.
  const matrix z{{0}, {0}, {1}};
  const ex across = cross(z, e_3);
  const ex across_length =
      sqrt(simplified(pow(across.op(0), 2) + pow(across.op(1), 2) + pow(across.op(2), 2)));
  const ex e_1 = kernel.simplified((across / across_length).evalm());
  const ex e_2 = kernel.simplified(cross(e_3, e_1));
  const ex R = columns({e_1, e_2, e_3});
  const Theorem frame = kernel.definition(
      {.id = "rotation.R",
       .statement = {symbol("R"), R},
       .words = "the triad e_1 = z x e_3 made a unit vector, e_2 = e_3 x e_1, e_3"});
  kernel.identity({.id = "rotation.R_orthogonal",
                   .statement = {(transpose(R) * R).evalm(), unit(3)},
                   .words = "R^T R = 1",
                   .label = "def:R",
                   .shown_lhs = "R^T R",
                   .shown_rhs = "1"});
  kernel.identity({.id = "rotation.R_determinant",
                   .statement = {determinant(R), 1},
                   .words = "det R = 1: right-handed",
                   .shown_lhs = "det R"});
  kernel.identity({.id = "rotation.R_paper",
                   .statement = paper.at("eq:R-app"),
                   .words = "as the paper writes it",
                   .label = "eq:R-app"});

  // In that frame Lambda turns about the third axis; the angle is read off.
  const ex seen = kernel.simplified(transpose(R) * Lambda * R);
  const Theorem psi = read_off_angle(kernel, "rotation.psi", symbol("psi"), seen.op(0), seen.op(3),
                                     "the angle of R^T Lambda R");
  kernel.equal_angles({.id = "rotation.psi_paper",
                       .statement = paper.at("def:psi"),
                       .words = "as the paper writes it",
                       .label = "def:psi, def:psi-app"});
  const ex turn = rotation_3(psi.lhs());
  kernel.identity({.id = "rotation.Lambda_turned",
                   .statement = {(transpose(R) * Lambda * R).evalm(), turn},
                   .words = "R^T Lambda R = lambda_3(psi)",
                   .label = "eq-app:lambda-R",
                   .shown_lhs = "R^T Lambda R",
                   .shown_rhs = "lambda_3(psi)"});
  const Theorem Lambda_turn =
      kernel.identity({.id = "rotation.Lambda",
                       .statement = {cycle.Lambda.lhs(), (R * turn * transpose(R)).evalm()},
                       .words = "Lambda = R lambda_3(psi) R^T",
                       .label = "eq:lambda-n, app:lam-n, Lambda",
                       .shown_rhs = "R lambda_3(psi) R^T"});

  const Theorem cos_half_psi =
      kernel.identity({.id = "rotation.cos_half_psi",
                       .statement = {cos(psi.lhs() / 2), kernel.simplified(cos(psi.lhs() / 2))},
                       .words = "the half angle"});
  const ex quarter = psi.lhs() / 4;
  const ex tangent = sqrt(kernel.simplified(pow(sin(quarter) / cos(quarter), 2)));
  const Theorem psi_half_angle = kernel.equal_angles(
      {.id = "rotation.psi_half_angle",
       .statement = {psi.lhs(), 4 * atan(tangent)},
       .words = "from a quarter of the angle: nothing overflows and nothing cancels"});
  return {frame, psi, psi_half_angle, Lambda_turn, cos_half_psi};
}

}  // namespace magicmass::derivation
