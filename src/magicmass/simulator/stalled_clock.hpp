// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>

#include "magicmass/simulator/field.hpp"

namespace magicmass {

/// The criterion of collapse where no theorem holds, for e < 1: 1000 contacts in a row during which the clock
/// moved on by less than 2^-40 of what it shows. Infinitely many contacts in finite time meet it sooner or later;
/// a motion without collapse would need more than 10^15 contacts in the time that it has taken so far.
template <Field Scalar>
class StalledClock {
public:
  /// How many in a row.
  static constexpr std::int64_t contacts = 1000;

  /// Takes note of a contact; true if the clock stands still.
  bool look(std::int64_t number, const Scalar& time) {
    if (number % contacts != 0) return false;
    const Scalar before = std::exchange(since_, time);
    const Scalar passed = (time - before) * Scalar(1 << 20) * Scalar(1 << 20);
    return number > contacts && !(time < passed);
  }

private:
  Scalar since_ = Scalar(0);
};

}  // namespace magicmass
