// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "magicmass/quantities.hpp"
#include "magicmass/terminal.hpp"

namespace magicmass::batch {

/// The functions for one input, for rows that a kernel leaves open; not a number where there is no answer, and -1 for a count. n beyond
/// the last collision may have none.
generated::Velocities<double> fast_velocities(double alpha, std::int64_t n);
generated::Velocities<double> accurate_velocities(double alpha, std::int64_t n);
Terminal fast_terminal(double alpha);
Terminal accurate_terminal(double alpha);
/// Where a kernel's numbers left a rounding open, of an alpha with N_A up to 2^51.
Terminal open_terminal(double alpha, const Counts& counts);
double transmission(double alpha, double e);
generated::Ratios<double> fast_ratios(std::int64_t k);
generated::Ratios<double> accurate_ratios(std::int64_t k);

}  // namespace magicmass::batch
