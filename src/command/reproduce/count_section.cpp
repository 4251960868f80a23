// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "command/alpha_value.hpp"
#include "command/reproduce/sections.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::command {
namespace {

/// The largest double below an irrational ratio.
MassRatio just_below(const MassRatio& ratio) { return std::nextafter(nearest_double(ratio), 0.0); }

}  // namespace

ComparisonSection count_section() {
  ComparisonSection section{
      "Numbers of collisions",
      "N_A and N_B, counted exactly: at a threshold itself, and for the double just below it.",
      {}};
  const auto add = [&](const std::string& place, const std::string& where, const MassRatio& alpha,
                       const char* N_A, const char* N_B) {
    const reference::LargeCounts ours = reference::count_collisions(alpha);
    section.rows.push_back({place, "N_A " + where, N_A, reference::to_text(ours.N_A), ""});
    section.rows.push_back({place, "N_B " + where, N_B, reference::to_text(ours.N_B), ""});
  };
  add("fig:NaNb", "at alpha = 2", 2.0, "1", "1");
  add("fig:NaNb", "at alpha = 1", 1.0, "1", "1");
  add("fig:NaNb", "at alpha = 0.5", 0.5, "2", "1");
  add("eq:Nbatcritical", "at beta_1", Deficient{1}, "2", "1");
  add("eq:Naatcritical", "at alpha_3", Magic{3}, "3", "3");
  add("fig:NaNb", "just below alpha_3", just_below(Magic{3}), "4", "3");
  add("eq:Nbatcritical", "at beta_3", Deficient{3}, "4", "3");
  add("fig:NaNb", "just below beta_3", just_below(Deficient{3}), "4", "4");
  add("fig:trajectories", "at alpha = 0.12", 0.12, "3", "3");
  add("fig:trajectories", "at alpha = 0.10", 0.10, "4", "3");
  return section;
}

}  // namespace magicmass::command
