// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "magicmass/quantities.hpp"

namespace magicmass::batch {

/// The functions for one input, for rows that a kernel leaves open; not a number where there is no answer. n beyond the last
/// collision may have none.
generated::Velocities<double> fast_velocities(double alpha, std::int64_t n);
generated::Velocities<double> accurate_velocities(double alpha, std::int64_t n);
generated::TerminalValues<double> fast_terminal(double alpha);
generated::TerminalValues<double> accurate_terminal(double alpha);
double transmission(double alpha, double e);
generated::Ratios<double> fast_ratios(std::int64_t k);
generated::Ratios<double> accurate_ratios(std::int64_t k);

}  // namespace magicmass::batch
