// SPDX-License-Identifier: GPL-2.0-or-later
// The mass ratios at which figures are evaluated.
#pragma once

#include <functional>
#include <vector>

#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass::command {

/// All magic and deficient ratios from `first` to `last`, ascending.
std::vector<MassRatio> thresholds(double first, double last);

/// `first`, `last` and between them so many equal steps an octave, a power of two: short binary fractions, the
/// same on every machine. With them the doubles nearest to the thresholds, where curves have their corners. Ascending.
std::vector<double> ratio_grid(double first, double last, int steps);

/// The largest double at which `holds`, by bisection: it does at `first`, not at `last`, and changes once.
double last_where(double first, double last, const std::function<bool(double)>& holds);

/// The largest double at which equal blocks collapse, for 0.5 <= e < 1: each decision is exact.
double last_collapse(double e);

}  // namespace magicmass::command
