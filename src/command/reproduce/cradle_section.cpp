// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "command/figure/figure.hpp"
#include "command/reproduce/sections.hpp"
#include "command/scene_motion.hpp"

namespace magicmass::command {

ComparisonSection cradle_section() {
  ComparisonSection section{
      "The generalised Newton's cradle",
      "One round trip between the walls, event by event in doubles: 1e-12 is left to rounding.",
      {}};
  const SceneMotion motion = cradle_motion();
  const auto wall = std::find_if(
      motion.contacts.begin(), motion.contacts.end(),
      [&](const MotionContact& contact) { return contact.gap == motion.names.size(); });
  for (std::size_t k = 1; k <= 4; ++k) {
    const std::size_t ball = 2 * k - 1;  // A_1, C_1, A_2, C_2, ...
    const auto met = [&](std::size_t gap) {
      return std::to_string(
          std::count_if(motion.contacts.begin(), wall,
                        [&](const MotionContact& contact) { return contact.gap == gap; }));
    };
    section.rows.push_back({"fig:system2",
                            fmt::format("collisions of A_{0} with C_{0} on the way there", k),
                            std::to_string(k), met(ball), ""});
    section.rows.push_back({"fig:system2",
                            fmt::format("collisions of C_{} with A_{} on the way there", k, k + 1),
                            std::to_string(k), met(ball + 1), ""});
  }
  const auto after = static_cast<std::size_t>(wall - motion.contacts.begin());
  for (std::size_t body = 0; body < motion.names.size(); ++body) {
    const auto& pieces = motion.pieces[body];
    const auto past =
        std::partition_point(pieces.begin(), pieces.end(),
                             [&](const MotionPiece& piece) { return piece.contacts <= after; });
    const double velocity = std::prev(past)->velocity;
    const std::string text = fmt::format("{:.12f}", std::abs(velocity) < 5e-13 ? 0.0 : velocity);
    section.rows.push_back({"fig:system2",
                            fmt::format("velocity of {} before the wall, in V", motion.names[body]),
                            body + 1 == motion.names.size() ? "1" : "0", text, ""});
  }
  return section;
}

}  // namespace magicmass::command
