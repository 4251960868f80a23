// SPDX-License-Identifier: MIT
// Bodies on a line as numbers: what a scene is worth once it is exact, or rounded.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace magicmass {

/// Bodies from left to right, none to the right of the next; walls outside them. Masses > 0, 0 < e <= 1.
/// Bodies are numbered from 0; gap g is to the left of body g, and gap number bodies() is that to the right wall.
template <class Scalar>
struct Line {
  std::vector<Scalar> masses;        ///< > 0
  std::vector<Scalar> positions;     ///< not decreasing; as many as masses
  std::vector<Scalar> velocities;    ///< as many as masses, > 0 to the right
  std::optional<Scalar> left_wall;   ///< its place; none without
  std::optional<Scalar> right_wall;  ///< its place; none without
  Scalar restitution = Scalar(1);    ///< e of every contact
  bool is_rounded =
      false;  ///< some number is the nearest one to what it stands for, not that itself

  /// How many there are.
  std::size_t bodies() const { return masses.size(); }
};

/// The same line in other numbers.
template <class To, class From, class Convert>
Line<To> converted(const Line<From>& line, const Convert& convert) {
  const auto all = [&](const std::vector<From>& values) {
    std::vector<To> numbers;
    numbers.reserve(values.size());
    for (const From& value : values) numbers.push_back(convert(value));
    return numbers;
  };
  const auto wall = [&](const std::optional<From>& place) {
    return place ? std::optional<To>(convert(*place)) : std::nullopt;
  };
  return {all(line.masses),     all(line.positions),   all(line.velocities),
          wall(line.left_wall), wall(line.right_wall), convert(line.restitution)};
}

}  // namespace magicmass
