// SPDX-License-Identifier: MIT
// Bodies on a line, between walls or none, and what makes them a line that can move.
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "magicmass/simulator/contact.hpp"

namespace magicmass::simulator {

/// Bodies from left to right at time 0; they may touch. Gap g is to the left of body g, and the
/// last gap to the right of the last body: there are as many gaps as bodies, and one more.
template <Field Scalar>
struct Line {
  std::vector<Scalar> masses;           ///< > 0
  std::vector<Scalar> positions;        ///< none less than the one before
  std::vector<Scalar> velocities;       ///< > 0 to the right
  std::optional<Scalar> left_wall;      ///< its place
  std::optional<Scalar> right_wall;     ///< its place
  Scalar restitution{1};                ///< e of every collision, walls' too: 0 < e <= 1
  bool is_rounded = false;              ///< numbers are only the nearest to what they stand for
  bool has_rounded_velocities = false;  ///< velocities are, too, and differ
};

struct Fault {
  std::string key;  ///< the member
  std::string what;
  std::string allowed;
};

/// The first fault of a line, or nothing.
template <Field Scalar>
std::optional<Fault> fault(const Line<Scalar>& line) {
  const Scalar zero(0), one(1);
  const auto body = [](std::size_t i) { return "body " + std::to_string(i + 1); };
  const std::size_t bodies = line.masses.size();
  if (bodies == 0) return Fault{"masses", "no bodies", "one or more"};
  for (const auto& [key, values] : {std::pair{"masses", &line.masses},
                                    {"positions", &line.positions},
                                    {"velocities", &line.velocities}}) {
    if (values->size() != bodies)
      return Fault{key, "a list of " + std::to_string(values->size()),
                   "as many as there are masses: " + std::to_string(bodies)};
    for (std::size_t i = 0; i < bodies; ++i)
      if (!((*values)[i] - (*values)[i] == zero))
        return Fault{key, "that of " + body(i) + " is not finite", "finite numbers"};
  }
  for (std::size_t i = 0; i < bodies; ++i) {
    if (!(zero < line.masses[i]))
      return Fault{"masses", "that of " + body(i) + " is not above 0", "masses above 0"};
    if (i > 0 && line.positions[i] < line.positions[i - 1])
      return Fault{"positions", body(i) + " is left of " + body(i - 1), "from left to right"};
  }
  const auto is_before = [&](const Scalar& x, const Scalar& y) { return x < y || x - y == zero; };
  if (line.left_wall && !is_before(*line.left_wall, line.positions.front()))
    return Fault{"left_wall", "right of " + body(0), "at the first body or left of it"};
  if (line.right_wall && !is_before(line.positions.back(), *line.right_wall))
    return Fault{"right_wall", "left of " + body(bodies - 1), "at the last body or right of it"};
  if (!(zero < line.restitution) || one < line.restitution)
    return Fault{"restitution", "0 or less, or above 1", "above 0, at most 1"};
  return std::nullopt;
}

template <Field Scalar>
const Line<Scalar>& without_fault(const Line<Scalar>& line) {
  if (const auto found = fault(line))
    throw std::invalid_argument(found->key + ": " + found->what + "; allowed: " + found->allowed);
  return line;
}

/// What a mirror shows of a line, or of all that has members of these names.
template <class Bodies>
Bodies mirrored(Bodies all, const auto& negative) {
  const auto turn = [&](auto& x) { x = negative(x); };
  for (auto* values : {&all.masses, &all.positions, &all.velocities}) std::ranges::reverse(*values);
  for (auto* values : {&all.positions, &all.velocities}) std::ranges::for_each(*values, turn);
  std::swap(all.left_wall, all.right_wall);
  for (auto* wall : {&all.left_wall, &all.right_wall})
    if (*wall) turn(**wall);
  return all;
}

}  // namespace magicmass::simulator
