// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "report/contestant.hpp"

namespace magicmass::report {

/// Everything that is measured: velocities, encounters, angle, ratios, counts, elastic_terminal (velocities after the
/// last collision and the counts), sequence (velocities again, one n after the other), and what the generated
/// tables have besides.
const std::vector<Quantity>& quantities();

/// The quantity of that name; throws InvalidInput for another.
const Quantity& quantity_named(const std::string& name);

/// Is the result a function of alpha, which the caller had to round? Ratios take k alone. True for a name that is none.
bool takes_alpha(const std::string& quantity);

/// N_A and N_B: whole numbers, right or wrong.
bool is_count(const std::string& member);
/// Is one of its members a count?
bool has_counts(const std::string& quantity);

/// Does it take n or j, of which there is a last one for each alpha?
bool has_last_index(const std::string& quantity);

}  // namespace magicmass::report
