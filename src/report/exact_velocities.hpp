// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "report/contestant.hpp"
#include "report/exact_value.hpp"

namespace magicmass::report {

/// a_n, b_n, c_n and c'_n at a double alpha, with what an error of alpha costs and how large each body's velocity gets.
/// exists is false for a collision that does not take place.
std::vector<ExactValue> exact_velocities(const Input& input);

/// a_t, b_t and c_t, which are velocities at the last collisions of A and B; the condition is for fixed counts. The
/// counts of alpha must be known, see LastCollision.
std::vector<ExactValue> exact_terminal(double alpha);

/// Largest |velocity| of a body between the first collision and the last; relative error below 1e-6.
struct LargestVelocities {
  double B = 0;
  double C = 0;  ///< A's is V itself: it never moves faster than at the start
};
LargestVelocities largest_velocities(double alpha);

}  // namespace magicmass::report
