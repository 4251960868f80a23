// SPDX-License-Identifier: GPL-2.0-or-later
// Counts and velocities for a mass ratio as it is written, from the book's theorems.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "answers/table.hpp"
#include "magicmass/scenes/ball.hpp"
#include "magicmass/scenes/trio.hpp"
#include "notation/alpha.hpp"

namespace answers {

using magicmass::scenes::Ball;
using magicmass::scenes::decimal;
using magicmass::scenes::exact;
using magicmass::scenes::nearest_double;
using magicmass::scenes::Trio;
using magicmass::scenes::value_of;
using magicmass::scenes::with_bits;

/// The mass ratio of a request. Throws InvalidInput.
notation::Alpha alpha_of(const std::string& text);
/// The nearest double.
double nearest(const notation::Alpha& alpha);
/// It, with the bits that are set now.
Ball ball_of(const notation::Alpha& alpha);

struct LargeCounts {
  cln::cl_I N_A, N_B;
};
/// Of any size. Throws Undecided where more bits would be needed than are allowed.
LargeCounts count_collisions(const notation::Alpha& alpha);

/// a, b, c, c_prime in units of V after n cycles, or the terminal a, b, c and rho, with the bits
/// that are set now. What is 0 by a theorem is exactly 0: before the first collision, and where B
/// takes everything.
using Balls = std::vector<Ball>;
Balls velocities(const notation::Alpha& alpha, const cln::cl_I& n);
Balls terminal(const notation::Alpha& alpha, const LargeCounts& counts);

/// Blocks of mass 1, a ball of mass alpha, restitution e.
Trio with_restitution(const notation::Alpha& alpha, const cln::cl_RA& e);
/// Its terminal a, b, c and rho after all of N collisions.
Balls terminal(const Trio& trio, std::int64_t N);

/// Its terminal rho, the nearest double; missing where the collisions never end.
Cell rho(const notation::Alpha& alpha, const cln::cl_RA& e);

/// Cells with the nearest doubles of what is computed, or with so many significant digits. Throws
/// Undecided where more bits would be needed than are allowed.
Row rounded(const std::function<Balls()>& values, std::optional<int> digits = {});

}  // namespace answers
