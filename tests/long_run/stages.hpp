// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

#include "long_run/tally.hpp"
#include "magicmass/counts.hpp"

namespace magicmass::long_run {

/// Where tier `accurate` decides an input of the functions for one, by its own ranges (tiers/accurate.cpp).
Stage velocities_stage(double alpha, std::int64_t n);
Stage encounters_stage(double alpha, std::int64_t j);
Stage angle_stage(double alpha);
Stage ratios_stage(std::int64_t k);
Stage terminal_stage(double alpha, const Counts& counts);

}  // namespace magicmass::long_run
