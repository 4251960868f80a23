// SPDX-License-Identifier: MIT
// Tier `accurate` without its last stage, certified arithmetic: what accurate.cpp tries first, and what tells how often
// that is enough.
#pragma once

#include <cstdint>

#include "magicmass/counts.hpp"
#include "magicmass/quantities.hpp"

namespace magicmass::tiers {

/// Whether the result is certainly the nearest doubles; else it is of no meaning, and certified arithmetic has to decide.
bool first_stages(double alpha, std::int64_t n, generated::Velocities<double>& result);
bool first_stages(double alpha, std::int64_t j, generated::Encounters<double>& result);
bool first_stages(double alpha, const Counts& counts, generated::TerminalValues<double>& result);
bool first_stages(double alpha, double& psi);
bool first_stages(std::int64_t k, generated::Ratios<double>& result);

}  // namespace magicmass::tiers
