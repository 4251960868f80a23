// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "command/alpha_value.hpp"
#include "command/reproduce/sections.hpp"
#include "command/velocity_tiers.hpp"
#include "magicmass/reference/count.hpp"

namespace magicmass::command {

ComparisonSection terminal_section() {
  ComparisonSection section{"Terminal velocities",
                            "In units of V, exactly where they are rational, else to 30 certified "
                            "digits. At a magic ratio "
                            "B has everything; at a deficient one the ball leaves as fast as B.",
                            {}};
  const Accuracy exact{"exact", std::nullopt};
  for (const std::int64_t k : {1, 2, 3, 10}) {
    const auto at_magic =
        k == 1 ? MassRatio(1.0) : MassRatio(Magic{k});  // 1 is a double: no field is needed
    const TerminalCells v =
        terminal_velocities(at_magic, reference::count_collisions(at_magic), exact);
    section.rows.push_back({"fig:atbtct", fmt::format("a_t at alpha_{}", k), "0", v.a_t.text, ""});
    section.rows.push_back({"fig:atbtct", fmt::format("b_t at alpha_{}", k), "1", v.b_t.text, ""});
    section.rows.push_back({"fig:atbtct", fmt::format("c_t at alpha_{}", k), "0", v.c_t.text, ""});
  }
  for (const std::int64_t k : {1, 2, 3, 10}) {
    const MassRatio at_deficient = Deficient{k};
    const TerminalCells v =
        terminal_velocities(at_deficient, reference::count_collisions(at_deficient), exact);
    section.rows.push_back({"fig:atbtct", fmt::format("b_t at beta_{}", k), "c_t", v.b_t.text, "",
                            v.b_t.text == v.c_t.text});
  }
  return section;
}

}  // namespace magicmass::command
