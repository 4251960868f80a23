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

/// Numbers that follow from others are made when they are asked for: a chain has many bodies of few kinds.
struct ExactLine {
  std::vector<ExactValue> masses;     ///< each by itself; equal ones share what is long
  std::vector<FieldNumber> placed;    ///< positions, or none: laid out by gap and L
  std::vector<FieldNumber> launched;  ///< velocities, or none: the first body has V
  FieldNumber V;                      ///< speed of the first body, where none are launched
  FieldNumber L;    ///< distance of the second and third body, where none are placed
  FieldNumber gap;  ///< distance of the first and second body, where none are placed
  std::optional<FieldNumber> left_wall;   ///< where it is
  std::optional<FieldNumber> right_wall;  ///< where it is
  FieldNumber restitution;                ///< above 0, at most 1
  CommonField common;                     ///< of everything, or of all but the masses
  bool one_field = false;                 ///< masses too are of that field
  std::string field;                      ///< its name; "the rationals"
  std::vector<FieldNumber> times;         ///< not before the start, in the scene's order
  std::optional<FieldNumber> until;       ///< when the run stops

  /// What is of the common field is rational: everything, or all but the masses.
  bool is_rational() const { return field == "the rationals"; }
  /// How many there are.
  std::size_t bodies() const { return masses.size(); }
  /// Where the body is at time 0.
  FieldNumber position(std::size_t body) const;
  /// Its velocity at time 0.
  FieldNumber velocity(std::size_t body) const;
  Line<FieldNumber> geometry() const;  ///< everything but the masses
  Line<FieldNumber> together() const;  ///< masses too, where they are of one field
};

/// Throws InvalidInput, with file, line and key: a mass that is not positive, bodies that overlap or are beyond a wall, V
/// or L not positive, restitution outside (0, 1], times before the start, places in more than one quadratic field.
ExactLine exact_line(const Scene& scene);

/// Everything as the nearest double, or long double. Throws Undecided where something does not fit.
template <class Float = double>
Line<Float> rounded(const ExactLine& line);
/// One of its two instances.
extern template Line<double> rounded(const ExactLine&);
/// One of its two instances.
extern template Line<long double> rounded(const ExactLine&);

}  // namespace magicmass::reference
