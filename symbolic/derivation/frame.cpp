// SPDX-License-Identifier: GPL-2.0-or-later
// Appendix app:orthogonal, second part: a right-handed triad as a matrix, and the rotation about any axis.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::matrix;

namespace {

ex dot(const ex& x, const ex& y) {
  return x.op(0) * y.op(0) + x.op(1) * y.op(1) + x.op(2) * y.op(2);
}

ex outer(const ex& x, const ex& y) { return (x * transpose(y)).evalm(); }

}  // namespace

void frame(Kernel& kernel, const Paper& paper) {
  const auto vector = [](const std::string& name) {
    return matrix{{symbol(name + "_1")}, {symbol(name + "_2")}, {symbol(name + "_3")}};
  };
  const ex x = vector("x"), y = vector("y"), z = cross(x, y), phi = symbol("phi");
  const auto suppose = [&](const char* id, const ex& product, const ex& value, const char* words) {
    return kernel.hypothesis({.id = id, .statement = {product, value}, .words = words});
  };
  const Theorem xx = suppose("frame.x", dot(x, x), 1, "x = e'_1 is a unit vector");
  const Theorem yy = suppose("frame.y", dot(y, y), 1, "y = e'_2 is a unit vector");
  const Theorem xy = suppose("frame.xy", dot(x, y), 0, "across the first; the third is x x y");
  const Theorem zz = kernel.consequence(
      {.id = "frame.z",
       .statement = {dot(z, z), 1},
       .words = "|x x y|^2 = |x|^2 |y|^2 - (x.y)^2: the third is a unit vector, too",
       .label = "app:orthogonal",
       .shown_lhs = "|e'_3|^2"},
      {{xx, dot(y, y)}, {yy, 1}, {xy, -dot(x, y)}});

  const matrix R = ex_to<matrix>(columns({x, y, z}));
  kernel.definition({.id = "frame.R",
                     .statement = {symbol("R_n"), R},
                     .words = "the triad's components, a column for each of its vectors"});
  kernel.identity({.id = "frame.R_paper",
                   .statement = paper.at("def:R"),
                   .words = "R_ij = e_i . e'_j",
                   .label = "def:R",
                   .shown_rhs = "[[e_i . e'_j]]"});
  kernel.rewriting({.id = "frame.R_orthogonal",
                    .statement = {(R.transpose() * ex(R)).evalm(), unit(3)},
                    .words = "(R^T R)_jk = sum over i of (e_i . e'_j)(e_i . e'_k) = e'_j . e'_k",
                    .label = "def:R",
                    .shown_lhs = "R^T R",
                    .shown_rhs = "1"},
                   {xx, yy, xy, zz});
  kernel.consequence({.id = "frame.R_determinant",
                      .statement = {determinant(R), 1},
                      .words = "e'_1 . (e'_2 x e'_3) = |e'_3|^2",
                      .label = "app:orthogonal",
                      .shown_lhs = "det R"},
                     {{zz, 1}});
  // z z^T = (|x|^2 |y|^2 - (x.y)^2) 1 - |y|^2 x x^T - |x|^2 y y^T + (x.y)(x y^T + y x^T), always.
  std::vector<Theorem> complete;
  const matrix R_R = ex_to<matrix>((ex(R) * R.transpose()).evalm());
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned k = i; k < 3; ++k) {
      const ex same = i == k ? 1 : 0;
      complete.push_back(kernel.consequence(
          {.id = "frame.complete_" + std::to_string(i + 1) + std::to_string(k + 1),
           .statement = {R_R(i, k), same},
           .words = "the rows of R, too, are unit vectors across each other",
           .shown_lhs = "(R R^T)_" + std::to_string(i + 1) + std::to_string(k + 1)},
          {{xx, dot(y, y) * same - y.op(i) * y.op(k)},
           {yy, same - x.op(i) * x.op(k)},
           {xy, -dot(x, y) * same + x.op(i) * y.op(k) + y.op(i) * x.op(k)}}));
    }
  kernel.rewriting({.id = "frame.R_inverse",
                    .statement = {ex(R_R), unit(3)},
                    .words = "R^T is the inverse on both sides",
                    .label = "def:R",
                    .shown_lhs = "R R^T",
                    .shown_rhs = "1"},
                   complete);

  // The rotation about e'_3: e'_1 -> cos(phi) e'_1 + sin(phi) e'_2 and so on.
  const ex image_x = (cos(phi) * x + sin(phi) * y).evalm();
  const ex image_y = (cos(phi) * y - sin(phi) * x).evalm();
  const ex turn = (outer(image_x, x) + outer(image_y, y) + outer(z, z)).evalm();
  kernel.definition({.id = "frame.lambda_n",
                     .statement = {symbol("lambda_n"), turn},
                     .words = "e'_1 and e'_2 are turned by phi in their plane, e'_3 is kept",
                     .shown_rhs = "cos(phi)*(x x^T + y y^T) + sin(phi)*(y x^T - x y^T) + z z^T"});
  kernel.identity({.id = "frame.lambda_n_paper",
                   .statement = paper.at("eq:lambda-n"),
                   .words = "which is lambda_3(phi), seen from S",
                   .label = "eq:lambda-n",
                   .shown_rhs = "R lambda_3(phi) R^T"});
  for (unsigned i = 0; i < 3; ++i)
    kernel.consequence({.id = "frame.axis_" + std::to_string(i + 1),
                        .statement = {(turn * z).evalm().op(i).expand(), z.op(i)},
                        .words = "the axis stays where it is",
                        .label = "eq:lambda-n",
                        .shown_lhs = "(lambda_n e'_3)_" + std::to_string(i + 1)},
                       {{zz, z.op(i)}});
  kernel.consequence({.id = "frame.trace",
                      .statement = {ex_to<matrix>(turn).trace(), 1 + 2 * cos(phi)},
                      .words = "its trace gives the angle",
                      .label = "eq:lambda-n",
                      .shown_lhs = "tr lambda_n"},
                     {{xx, cos(phi)}, {yy, cos(phi)}, {zz, 1}});
}

}  // namespace magicmass::derivation
