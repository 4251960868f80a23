// SPDX-License-Identifier: MIT
// How far the motion in floating point may be from the exact one, as long as every decision so far was the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "magicmass/simulator/line.hpp"

namespace magicmass {

/// With lengths measured as sqrt(sum m x^2), a contact is a reflection of all velocities and of the position: it
/// makes no error longer (shorter, below e = 1). So errors only add up. A contact's own rounding is at most
/// 6 eps max(|u1|, |u2|) on each of the two, that of its rounded masses and restitution a few eps more: together
/// below 32 eps sqrt(2 E) in that length. Positions drift by the velocities' error times the time, and
/// each contact rounds positions of size X and a clock of size t.
template <class Scalar>
class RoundingMargin {
public:
  explicit RoundingMargin(const Line<Scalar>& line) {
    Scalar mass = 0;
    Scalar twice_energy = 0;
    Scalar lightest = line.masses.front();
    for (std::size_t i = 0; i < line.bodies(); ++i) {
      mass += line.masses[i];
      twice_energy += line.masses[i] * line.velocities[i] * line.velocities[i];
      lightest = std::min(lightest, line.masses[i]);
      look_at(line.positions[i]);
    }
    for (const auto& wall : {line.left_wall, line.right_wall})
      if (wall) look_at(*wall);
    root_mass_ = std::sqrt(mass);
    root_energy_ = std::sqrt(twice_energy);
    at_lightest_ = 1 / std::sqrt(lightest);
  }

  /// A contact that rounded; velocities that are only swapped or turned round are not.
  void add_contact() { contacts_ += 1; }
  void look_at(Scalar position) { size_ = std::max(size_, std::abs(position)); }

  /// May velocities of bodies of masses m1 and m2 that differ by `closing` be equal in truth? Infinite mass: a wall.
  bool reaches_closing(Scalar closing, Scalar m1, Scalar m2) const {
    const Scalar error = of_velocities();
    return error > 0 && std::abs(closing) <= 2 * error * at_lightest_ &&
           std::abs(closing) <= error * (1 / std::sqrt(m1) + 1 / std::sqrt(m2));
  }

  /// May contacts of two gaps, `apart` after one another at about `time`, be at once in truth? Gaps close at c1 and c2.
  bool reaches_time(Scalar apart, Scalar time, Scalar c1, Scalar c2) const {
    return apart * c1 * c2 <= 2 * of_positions(time) * at_lightest_ * (c1 + c2);
  }

private:
  static constexpr Scalar eps = std::numeric_limits<Scalar>::epsilon();
  Scalar root_mass_ = 0;
  Scalar root_energy_ = 0;
  Scalar at_lightest_ = 0;
  Scalar size_ = 0;
  Scalar contacts_ = 0;

  Scalar of_velocities() const { return 32 * eps * contacts_ * root_energy_; }
  Scalar of_positions(Scalar time) const {
    return 16 * eps * (contacts_ + 1) * (size_ * root_mass_ + 3 * time * root_energy_);
  }
};

}  // namespace magicmass
