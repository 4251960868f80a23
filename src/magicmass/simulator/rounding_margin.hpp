// SPDX-License-Identifier: MIT
// How far the motion in floating point may be from the exact one, as long as every decision so far was the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "magicmass/simulator/line.hpp"

namespace magicmass {

/// The two sides of a gap. A wall has infinite mass and velocity 0.
template <class Scalar>
struct GapSides {
  Scalar m1;  ///< mass of the left side
  Scalar u1;  ///< its velocity
  Scalar m2;  ///< mass of the right side
  Scalar u2;  ///< its velocity

  /// Speed at which the gap closes.
  Scalar closing() const { return u1 - u2; }
};

/// Lengths are measured as sqrt(sum m x^2), of velocities likewise. In that length a contact is a reflection (with
/// e < 1 a contraction) of all velocities and of the position: it makes no error longer, so errors only add up, and
/// the position's grows by the velocities' times the time. With s = sqrt(m1) |u1| + sqrt(m2) |u2| of the two that meet:
/// - velocities: the weighted sum U is within 2.5 eps s/sqrt(m1+m2), each result within 2 |dU| + eps |u'|, so both
///   together 6 eps s; masses and restitution rounded by eps/2 cost 2 eps s more. 10 is taken.
/// - positions up to X at time t: where the heavier body is, is within 2.5 eps X; the clock is within 9 eps X/c + eps t/2
///   for a closing speed c, so the lighter one, put at the same place, is moved by up to 12 eps X + eps t c/2, and
///   sqrt(m) c <= s of the lighter. 13 eps X (sqrt(m1) + sqrt(m2)) + eps t s is taken.
/// A difference between two bodies is within sqrt(1/m1 + 1/m2) of such a length (Cauchy and Schwarz).
template <class Scalar>
class RoundingMargin {
public:
  /// The errors at the start, where the line is_rounded.
  explicit RoundingMargin(const Line<Scalar>& line) {
    Scalar root_mass = 0, speeds = 0;
    Scalar lightest = line.masses.front();
    for (std::size_t i = 0; i < line.bodies(); ++i) {
      root_mass += std::sqrt(line.masses[i]);
      speeds += std::sqrt(line.masses[i]) * std::abs(line.velocities[i]);
      lightest = std::min(lightest, line.masses[i]);
      look_at(line.positions[i]);
    }
    for (const auto& wall : {line.left_wall, line.right_wall})
      if (wall) look_at(*wall);
    at_lightest_ = std::sqrt(2 / lightest);
    if (!line.is_rounded) return;
    positions_ = eps * size_ * root_mass;
    velocities_ = eps * speeds;
  }

  /// Something is at this place.
  void look_at(Scalar position) { size_ = std::max(size_, std::abs(position)); }

  /// A contact at this time; velocities that were only swapped or turned round are not rounded.
  void add_contact(Scalar time, const GapSides<Scalar>& before, bool rounds) {
    const Scalar r1 = root(before.m1), r2 = root(before.m2);
    const Scalar s = r1 * std::abs(before.u1) + r2 * std::abs(before.u2);
    positions_ += velocities_ * (time - last_) + eps * (13 * size_ * (r1 + r2) + time * s);
    last_ = time;
    if (rounds) velocities_ += 10 * eps * s;
  }

  /// May the two sides of a gap, which close at so small a speed, be at rest to each other in truth, or go the other way?
  bool reaches_closing(const GapSides<Scalar>& gap) const {
    if (!(velocities_ > 0)) return false;
    const Scalar speed = std::abs(gap.closing());
    return !(velocities_ * at_lightest_ < speed) && !(velocities_ * spread(gap) < speed);
  }

  /// May the second gap, which closes later by `apart`, close first in truth? At a time between the two the first must
  /// have closed in truth and the second not: there is one if `apart` is longer than both gaps' errors take to close.
  bool reaches_time(Scalar apart, Scalar time, const GapSides<Scalar>& first,
                    const GapSides<Scalar>& second) const {
    const Scalar c1 = first.closing(), c2 = second.closing();
    const Scalar later = time + apart;
    const Scalar positions = positions_ + velocities_ * (later - last_);
    const Scalar reach = size_ + apart * (std::abs(first.u1) + std::abs(first.u2) +
                                          std::abs(second.u1) + std::abs(second.u2));
    const auto error = [&](Scalar of_length, Scalar c) {
      return positions * of_length + eps * (12 * reach + 2 * later * c);
    };
    const auto within = [&](Scalar e1, Scalar e2) {
      return !(e1 * c2 + e2 * c1 < apart * c1 * c2);
    };
    return within(error(at_lightest_, c1), error(at_lightest_, c2)) &&
           within(error(spread(first), c1), error(spread(second), c2));
  }

  /// The error of all velocities, in that length.
  Scalar of_velocities() const { return velocities_; }
  /// The error of all positions at a time from the last contact on.
  Scalar of_positions(Scalar time) const { return positions_ + velocities_ * (time - last_); }

private:
  static constexpr Scalar eps = std::numeric_limits<Scalar>::epsilon();
  Scalar at_lightest_ = 0;
  Scalar size_ = 0;
  Scalar positions_ = 0;  // at the time last_
  Scalar velocities_ = 0;
  Scalar last_ = 0;

  /// A wall does not move, and takes no error.
  static Scalar root(Scalar mass) { return std::isinf(mass) ? 0 : std::sqrt(mass); }
  static Scalar spread(const GapSides<Scalar>& gap) { return std::sqrt(1 / gap.m1 + 1 / gap.m2); }
};

}  // namespace magicmass
