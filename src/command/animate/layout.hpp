// SPDX-License-Identifier: GPL-2.0-or-later
// Where bodies are drawn. In the paper they are points; drawn with a width, each is moved to the right by the widths
// of those before it, so that a contact of two is their edges meeting.
#pragma once

#include <optional>
#include <vector>

#include "command/scene_motion.hpp"

namespace magicmass::command {

struct Layout {
  static constexpr double width = 1000.0;
  static constexpr double height = 220.0;
  static constexpr double floor = 150.0;  ///< from above; bodies stand on it
  std::vector<double> sizes;              ///< of each body: a side, or a diameter
  std::vector<double> offsets;            ///< of each body's centre
  std::vector<bool> is_ball;
  double room;  ///< across, which bodies' sizes leave for the distances between them
  std::optional<double> left_wall;
  std::optional<double> right_wall;
};

/// Sizes grow with the cube root of the mass, within limits.
Layout layout_of(const SceneMotion& motion);

/// x of each body's centre at one moment. Room at first for the beginning, then for all bodies, wherever they are.
std::vector<double> places(const SceneMotion& motion, const Layout& layout, std::size_t contacts,
                           double time);

}  // namespace magicmass::command
