// SPDX-License-Identifier: GPL-2.0-or-later
// Counts and velocities for a mass ratio as it is written, from the book's theorems.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "answers/ball.hpp"
#include "notation/alpha.hpp"

namespace answers {

/// The mass ratio of a request. Throws InvalidInput.
notation::Alpha alpha_of(const std::string& text);
/// It, with the bits that are set now.
Ball ball_of(const notation::Alpha& alpha);
/// A double, exactly.
cln::cl_RA exact(double value);

struct LargeCounts {
  cln::cl_I N_A, N_B;
};
/// Of any size. Throws Undecided where more bits would be needed than are allowed.
LargeCounts count_collisions(const notation::Alpha& alpha);

/// a, b, c, c_prime in units of V after n cycles, or the terminal a, b, c and rho: each as a ball
/// of the bits that are set now.
using Four = std::array<Ball, 4>;
using Velocities = std::function<Four()>;
Velocities velocities(const notation::Alpha& alpha, const cln::cl_I& n);
Velocities terminal(const notation::Alpha& alpha, const LargeCounts& counts);

/// The four as nearest doubles, or as decimals with so many significant digits. `is_zero` says
/// which are 0 by a theorem.
std::array<double, 4> nearest_doubles(const Velocities& values, const std::array<bool, 4>& is_zero);
std::array<std::string, 4> decimals(const Velocities& values, const std::array<bool, 4>& is_zero,
                                    int digits);
/// Which of the four after n cycles are 0 by a theorem: before the first collision, and where B
/// takes everything.
std::array<bool, 4> zeros(const notation::Alpha& alpha, const cln::cl_I& n);

}  // namespace answers
