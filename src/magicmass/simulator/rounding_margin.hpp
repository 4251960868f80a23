// SPDX-License-Identifier: MIT
// How far a motion in floating point may be from the exact one, while each decision was the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "magicmass/simulator/line.hpp"

namespace magicmass::simulator {

/// What is on the two sides of a gap. A wall has infinite mass and velocity 0.
template <Field Scalar>
struct Sides {
  const Body<Scalar>& left;
  const Body<Scalar>& right;

  Scalar closing() const { return left.velocity - right.velocity; }
  Scalar spread() const { return std::sqrt(1 / left.mass + 1 / right.mass); }
  Scalar speeds() const { return std::abs(left.velocity) + std::abs(right.velocity); }
};

/// How far times and places of collisions, and velocities, may be off at most; or infinite.
template <Field Scalar>
struct Errors {
  Scalar time{0}, position{0}, velocity{0};
};

/// Lengths are measured as sqrt(sum m x^2), of velocities likewise. In that length a collision is a
/// reflection (with e < 1 a contraction) of all velocities and of the positions, so that errors
/// only add up, and those of positions grow by those of velocities times the time. With
/// s = sqrt(m1) |u1| + sqrt(m2) |u2| of the two that meet:
/// - velocities: the centre's, U, is within 2.5 eps s/sqrt(m1 + m2), each result within 2 |dU| +
///   eps |u'|, so both together within 6 eps s; what is rounded of masses and restitution costs 2
///   eps s more. 10 is taken.
/// - positions up to X at time t: the heavier body's is within 2.5 eps X; the clock is within 9 eps
///   X/c + eps t/2 for a closing speed c, so the lighter one, put at the same place, is moved by up
///   to 12 eps X + eps t c/2, its sqrt(m) c <= s. 13 eps X (sqrt(m1) + sqrt(m2)) + eps t s: taken.
/// A difference between two bodies is within sqrt(1/m1 + 1/m2) of such a length.
template <Field Scalar>
class RoundingMargin {
  static Scalar eps() { return std::numeric_limits<Scalar>::epsilon(); }
  /// More than what is lost below the normal numbers, as of sqrt(m) u for a tiny mass.
  static Scalar least() { return std::numeric_limits<Scalar>::min(); }

public:
  /// Exact numbers have none, and ask for none.
  explicit RoundingMargin([[maybe_unused]] const Line<Scalar>& line) {
    if constexpr (std::floating_point<Scalar>) {
      Scalar root_mass = 0, speeds = 0;
      for (std::size_t i = 0; i < line.masses.size(); ++i) {
        const Scalar r = std::sqrt(line.masses[i]);
        lightest_ = i == 0 ? r : std::min(lightest_, r);
        root_mass += r;
        speeds += r * std::abs(line.velocities[i]);
        look_at(line.positions[i]);
      }
      for (const auto& wall : {line.left_wall, line.right_wall}) look_at(wall.value_or(0));
      positions_ = line.is_rounded ? eps() * size_ * root_mass + least() : 0;
      const bool moves = std::ranges::any_of(line.velocities, [](Scalar u) { return u != 0; });
      velocities_ = line.is_rounded && moves ? eps() * speeds + least() : 0;
      worst_.velocity = velocities_ / lightest_;
    }
  }

  void look_at(Scalar position) { size_ = std::max(size_, std::abs(position)); }

  /// A collision at this time; what is only swapped or turned round is not rounded.
  void add_collision(Scalar time, const Sides<Scalar>& before, bool rounds) {
    const Scalar r1 = root(before.left.mass), r2 = root(before.right.mass);
    const Scalar s = r1 * std::abs(before.left.velocity) + r2 * std::abs(before.right.velocity);
    positions_ += velocities_ * (time - last_);
    const Scalar slowest = before.closing() - velocities_ * before.spread();
    const Scalar off = slowest > 0 ? error(before, positions_, size_, time) / slowest
                                   : std::numeric_limits<Scalar>::infinity();
    positions_ += eps() * (13 * size_ * (r1 + r2) + time * s) + least();
    last_ = time;
    const Scalar place = (positions_ + (velocities_ + s) * off) / std::max(r1, r2);
    worst_.time = std::max(worst_.time, off);
    worst_.position = std::max(worst_.position, place + eps() * size_);
    if (rounds) velocities_ += 10 * eps() * s + least();
    worst_.velocity = velocities_ / lightest_;
  }
  /// Of all collisions so far.
  const Errors<Scalar>& errors() const { return worst_; }

  /// May the sides of a gap in truth be at rest to each other, or go the other way?
  bool reaches_rest(const Sides<Scalar>& gap) const {
    return velocities_ > 0 && !(velocities_ * gap.spread() < std::abs(gap.closing()));
  }

  /// May the second gap, which closes later by `apart`, in truth close first? Else there is a time
  /// between the two at which the first has closed for certain and the second has not.
  bool reaches_time(Scalar apart, Scalar time, const Sides<Scalar>& first,
                    const Sides<Scalar>& second) const {
    const Scalar c1 = first.closing(), c2 = second.closing();
    const Scalar later = time + apart;
    const Scalar positions = positions_ + velocities_ * (later - last_);
    const Scalar reach = size_ + apart * (first.speeds() + second.speeds());
    return !(error(first, positions, reach, later) * c2 +
                 error(second, positions, reach, later) * c1 <
             apart * c1 * c2);
  }

private:
  Scalar size_{0};
  Scalar positions_{0};  // error of all of them, at the time last_
  Scalar velocities_{0};
  Scalar last_{0};
  Scalar lightest_{0};  // the root of its mass
  Errors<Scalar> worst_;

  /// Of a gap's width.
  static Scalar error(const Sides<Scalar>& gap, Scalar positions, Scalar reach, Scalar time) {
    return positions * gap.spread() + eps() * (12 * reach + 2 * time * gap.closing());
  }
  static Scalar root(Scalar mass) { return std::isinf(mass) ? 0 : std::sqrt(mass); }
};

}  // namespace magicmass::simulator
