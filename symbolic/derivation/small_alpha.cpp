// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 9: light balls.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::Pi;

void small_alpha(Kernel& kernel, const Rotation& rotation, const Counting& counting,
                 const Paper& paper) {
  const ex alpha = symbol("alpha"), psi = symbol("psi");
  kernel.expansion({.id = "small_alpha.theta",
                    .statement = paper.at("app:Vn, small alpha"),
                    .words = "the angle of one contact for a light ball",
                    .label = "app:Vn, small alpha"});
  kernel.expansion({.id = "small_alpha.psi",
                    .statement = paper.at("app:lam-n, small alpha"),
                    .words = "the angle of one cycle for a light ball",
                    .label = "app:lam-n, small alpha"});

  // Further terms: the series is computed here, and checked there.
  const ex s = GiNaC::possymbol("s");
  const auto series = [&](const ex& function, int terms) {
    const ex in_s = function.subs(alpha == pow(s, 2)).expand();
    return GiNaC::series_to_poly(in_s.series(s == 0, terms)).expand().subs(s == sqrt(alpha));
  };
  const ex meaning = rotation.psi.rhs();
  kernel.expansion({.id = "small_alpha.psi_further",
                    .statement = {psi, Relation::asymptotic, series(meaning, 8)},
                    .words = "and its next terms"});
  kernel.expansion({.id = "small_alpha.cycles_further",
                    .statement = {Pi / psi, Relation::asymptotic, series(Pi / meaning, 5)},
                    .words = "how many angles psi make a straight one"});
  const Theorem cycles =
      kernel.expansion({.id = "small_alpha.cycles",
                        .statement = {Pi / psi, Relation::asymptotic, series(Pi / meaning, 0)},
                        .words = "to leading order"});
  for (const auto& [name, count] :
       {std::pair{"N_A", counting.N_A}, std::pair{"N_B", counting.N_B}}) {
    const std::string label = std::string("eq:NA-approx, ") + name;
    kernel.expansion_of_count({.id = std::string("small_alpha.") + name,
                               .statement = paper.at(label),
                               .words = "a whole number within one of that",
                               .label = "eq:NA-approx"},
                              count, cycles);
  }
  kernel.expansion_of_count({.id = "small_alpha.N",
                             .statement = {symbol("N"), Relation::asymptotic, 2 * cycles.rhs()},
                             .words = "all collisions, on both sides of the ball: Redner's count",
                             .label = "eq:NA-approx"},
                            counting.N, cycles);
}

}  // namespace magicmass::derivation
