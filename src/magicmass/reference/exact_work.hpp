// SPDX-License-Identifier: GPL-2.0-or-later
// When exact numbers have become too long to go on with.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>

#include "magicmass/reference/number_field.hpp"
#include "magicmass/simulator/line_motion.hpp"

namespace magicmass::reference {

/// Of a run, some ten seconds; and of a look ahead at one.
inline constexpr double most_exact_work = 2e12;
inline constexpr double most_rehearsed_work = 2e11;

/// What exact numbers cost, by their length: a division takes its square, and in a field of degree d some d^3 of them with
/// numbers d times as long. So a run stops after the same event on every machine.
class ExactWork {
public:
  ExactWork(std::size_t degree, double most)
      : each_(std::pow(static_cast<double>(degree), 5)), most_(most) {}

  /// The clock alone does not tell: it stands still where bodies between walls have no room.
  template <class Scalar>
  bool is_too_much(const LineEvent<Scalar>& event) {
    if constexpr (std::floating_point<Scalar>) {
      return false;
    } else {
      const auto length = [](const Scalar& x) { return FieldNumber(x).bits(); };
      const long longest =
          std::max({length(event.time), length(event.v_left), length(event.v_right)});
      const auto bits = static_cast<double>(longest);
      work_ += 3 * bits * bits * each_;
      return longest > most_bits || work_ > most_;
    }
  }

private:
  static constexpr long most_bits = 1L << 17U;
  double each_, most_;
  double work_ = 0.0;
};

}  // namespace magicmass::reference
