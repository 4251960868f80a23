// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 5: the trigonometric table, and where theta and psi lie.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::Pi;

Table table(Kernel& kernel, const Contact& contact, const Rotation& rotation, const Paper& paper) {
  const ex alpha = symbol("alpha"), theta = contact.theta.lhs(), psi = rotation.psi.lhs();
  const struct {
    const char* id;
    const char* label;
    ex angle;
  } rows[] = {{"theta_half", "theta/2", theta / 2},
              {"theta", "theta", theta},
              {"psi_quarter", "psi/4", psi / 4},
              {"psi_half", "psi/2", psi / 2},
              {"psi", "psi", psi}};
  std::map<std::string, Theorem> proved;
  for (const auto& row : rows) {
    for (const char* name : {"cos", "sin", "tan"}) {
      const std::string label = std::string("table:trig, ") + name + " " + row.label;
      const std::string id = std::string(name) + "_" + row.id;
      proved.emplace(
          id, kernel.identity({.id = "table." + id,
                               .statement = paper.at(label),
                               .words = "from the definition of the angle, halved or doubled",
                               .label = label}));
    }
    kernel.positivity({.id = std::string("table.") + row.id + "_positive",
                       .statement = {row.angle, Relation::greater, 0},
                       .words = "the angle is positive"});
  }

  const Theorem lighter = kernel.hypothesis({.id = "table.lighter",
                                             .statement = {1 - alpha, Relation::greater, 0},
                                             .words = "a ball lighter than the blocks"});
  kernel.larger_angle({.id = "table.theta_range",
                       .statement = paper.at("app:Vn, range of theta"),
                       .words = "its cosine (1 - alpha)/(1 + alpha) is positive",
                       .label = "app:Vn, range of theta"},
                      lighter);
  kernel.larger_angle({.id = "table.psi_range",
                       .statement = paper.at("app:lam-n, range of psi"),
                       .words = "its cosine is more than -1/2, by a multiple of 1 - alpha",
                       .label = "app:lam-n, range of psi"},
                      lighter);
  kernel.equal_angles({.id = "table.psi_at_1",
                       .statement = {rotation.psi.rhs().subs(alpha == 1), 2 * Pi / 3},
                       .words = "and at alpha = 1 it is 2 pi/3",
                       .label = "app:lam-n, range of psi",
                       .shown_lhs = "psi at alpha = 1"});
  return {proved.at("cos_theta"), proved.at("sin_theta"), proved.at("cos_psi"),
          proved.at("sin_psi")};
}

}  // namespace magicmass::derivation
