// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "derivation/matrices.hpp"
#include "derivation/paper/equations.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

Equations orthogonal_equations() {
  const ex phi = symbol("phi"), phi_O = symbol("phi_O");
  const matrix O{{symbol("o2_11"), symbol("o2_12")}, {symbol("o2_21"), symbol("o2_22")}};
  return {
      {"app:orthogonal, lambda",
       {symbol("lambda"), matrix{{cos(phi), -sin(phi)}, {sin(phi), cos(phi)}}}},
      {"eq:lambda-1",
       {symbol("lambda_1"), matrix{{1, 0, 0}, {0, cos(phi), -sin(phi)}, {0, sin(phi), cos(phi)}}}},
      {"eq:lambda-2",
       {symbol("lambda_2"), matrix{{cos(phi), 0, sin(phi)}, {0, 1, 0}, {-sin(phi), 0, cos(phi)}}}},
      {"eq:lambda-3",
       {symbol("lambda_3"), matrix{{cos(phi), -sin(phi), 0}, {sin(phi), cos(phi), 0}, {0, 0, 1}}}},
      {"app:orthogonal, det 1", {ex(O), plane_rotation(phi_O)}},
      {"app:orthogonal, det -1",
       {ex(O), (plane_rotation(phi_O) * matrix{{1, 0}, {0, -1}}).evalm()}},
  };
}

Equations frame_equations() {
  const auto vector = [](const std::string& name) {
    return matrix{{symbol(name + "_1")}, {symbol(name + "_2")}, {symbol(name + "_3")}};
  };
  const ex x = vector("x"), y = vector("y");
  const std::vector<ex> triad{x, y, cross(x, y)};
  matrix R(3, 3);
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      for (unsigned component = 0; component < 3; ++component)
        R(i, j) += unit(3).op(3 * i + component) * triad[j].op(component);
  return {
      {"def:R", {symbol("R_n"), ex(R)}},
      {"eq:lambda-n",
       {symbol("lambda_n"), (ex(R) * rotation_3(symbol("phi")) * R.transpose()).evalm()}},
  };
}

}  // namespace magicmass::derivation
