// SPDX-License-Identifier: GPL-2.0-or-later
// Each number that the paper prints, quoted with its label, and ours, from the evaluators. One function a section.
#pragma once

#include "command/reproduce/comparison.hpp"

namespace magicmass::command {

ComparisonSection ratio_section();
ComparisonSection count_section();
ComparisonSection terminal_section();
ComparisonSection restitution_section();
ComparisonSection collapse_section();
ComparisonSection cradle_section();

/// All of them, in the paper's order.
std::vector<ComparisonSection> comparison_sections();

}  // namespace magicmass::command
