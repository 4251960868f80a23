// SPDX-License-Identifier: GPL-2.0-or-later
// A scene's bodies as exact numbers, after it was found to make sense.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "magicmass/reference/exact_value.hpp"
#include "magicmass/scenes/scene.hpp"
#include "magicmass/simulator/line.hpp"

namespace magicmass::reference {

/// Largest degree of a field in which events are stepped.
inline constexpr std::int64_t most_exact_degree = 12;

struct ExactLine {
  std::vector<ExactValue> masses;             ///< each by itself
  Line<FieldNumber> geometry;                 ///< everything but the masses, in one field
  std::optional<Line<FieldNumber>> together;  ///< masses too, where they are of the same field
  std::string field;                          ///< its name; "the rationals"
  std::vector<FieldNumber> times;
  std::optional<FieldNumber> until;

  bool is_rational() const { return field == "the rationals"; }
};

/// Throws InvalidInput, with file, line and key: a mass that is not positive, bodies that overlap or are beyond a wall, V
/// or L not positive, restitution outside (0, 1], times before the start, places in more than one quadratic field.
ExactLine exact_line(const Scene& scene);

/// Everything as the nearest double.
Line<double> rounded(const ExactLine& line);

}  // namespace magicmass::reference
