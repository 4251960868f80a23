// SPDX-License-Identifier: MIT
// Results of the numeric functions, and the columns that array calls fill. Velocities are in units
// of V, the velocity of block A before the first collision; alpha is m/M.
#pragma once

#include <cstdint>
#include <span>

namespace magicmass {
/// Numbers of A-C and C-B collisions, the paper's N_A and N_B.
struct Counts {
  std::int64_t N_A = 0, N_B = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};
/// After n cycles: a_n, b_n, c_n, c'_n.
struct Velocities {
  double a = 0;        ///< of A
  double b = 0;        ///< of B
  double c = 0;        ///< of C between its n-th collisions with A and with B
  double c_prime = 0;  ///< of C after its n-th collision with B
  friend bool operator==(const Velocities&, const Velocities&) = default;
};
/// After all collisions; rho, for equal blocks b_t^2, is the share of the energy that B takes.
struct Terminal {
  Counts counts;
  double a_t = 0, b_t = 0, c_t = 0, rho = 0;
  friend bool operator==(const Terminal&, const Terminal&) = default;
};
/// Masses of the three in units of that of A: the ball's, and B's as 1 over it, 0 for a wall.
struct Masses {
  double ball = 0, per_B = 1;
};
/// When collision j takes place, and how far apart A and B are then, in units of L/V and L: their
/// distance L at the first collision, A's and the ball's, which is number 0 at time 0.
struct Collision {
  double t = 0, s = 0;
  friend bool operator==(const Collision&, const Collision&) = default;
};
/// Infinitely many collisions are over at t: all three have velocity v, B the share rho of energy.
struct Collapse {
  double t = 0, v = 0, rho = 0;
};
/// alpha_k and beta_k.
struct Ratios {
  double magic = 0, deficient = 0;
  friend bool operator==(const Ratios&, const Ratios&) = default;
};
/// The magic or deficient mass ratio that is nearest to some alpha.
struct Threshold {
  bool is_magic = true;   ///< alpha_k, else beta_k
  std::int64_t k = 1;     ///< its number, from 1 on
  double distance = 0.0;  ///< (alpha - threshold)/threshold, correctly rounded
};

/// Where array calls write: an empty span is not wanted, all others have as many rows as alpha.
/// Columns may overlap neither each other nor the inputs. Rows without an answer are NaN.
struct VelocityColumns {
  std::span<double> a = {}, b = {}, c = {}, c_prime = {};
};
/// As above; counts of rows without an answer are -1.
struct TerminalColumns {
  std::span<std::int64_t> N_A = {}, N_B = {};
  std::span<double> a_t = {}, b_t = {}, c_t = {}, rho = {};
};
}  // namespace magicmass
