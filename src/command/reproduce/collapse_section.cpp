// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "command/figure/ratio_grid.hpp"
#include "command/reproduce/sections.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/restitution.hpp"

namespace magicmass::command {
ComparisonSection collapse_section() {
  ComparisonSection section{
      "Inelastic collapse",
      "Up to a mass ratio alpha_c(e) the collisions never end. Found by bisection between doubles, "
      "each decided exactly. The value for equal masses is the literature's, 7 - 4 sqrt(3).",
      {}};
  for (const double e : {0.9, 0.8, 0.7})
    section.rows.push_back({"fig:inelastic", fmt::format("alpha_c({})", e), "",
                            fmt::format("{}", last_collapse(e)),
                            "the paper does not speak of collapse"});
  const double of_equal_masses = last_where(
      0.01, 1.0, [](double e) { return !reference::count_collisions(1.0, reference::exact(e)); });
  section.rows.push_back({"literature", "largest e with a collapse at alpha = 1", "0.0718",
                          fmt::format("{}", of_equal_masses), ""});
  return section;
}

}  // namespace magicmass::command
