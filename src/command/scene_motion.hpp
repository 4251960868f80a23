// SPDX-License-Identifier: GPL-2.0-or-later
// The motion that a scene leads to, as pictures need it: all contacts, and where each body is at each moment.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "magicmass/reference/scene_plan.hpp"
#include "magicmass/scenes/scene.hpp"

namespace magicmass::command {

/// A contact. Gap g is to the left of body g; gap 0 and the last one belong to the walls, whose velocity is 0.
struct MotionContact {
  double time;
  double position;
  std::size_t gap;
  double v_left;
  double v_right;
};

/// From `time` on, and after so many contacts of all bodies, a body is at position + velocity (t - time).
struct MotionPiece {
  std::size_t contacts;
  double time;
  double position;
  double velocity;
};

struct SceneMotion {
  std::vector<std::string> names;  ///< of the bodies, from left to right
  std::vector<double> masses;
  std::vector<std::vector<MotionPiece>> pieces;  ///< of each body, in order
  std::vector<MotionContact> contacts;
  std::optional<double> left_wall;
  std::optional<double> right_wall;
  double begin;        ///< before the first contact, where the bodies came from somewhere
  double end;          ///< after the last one
  double left;         ///< of all bodies at the beginning, and the walls
  double right;        ///< likewise
  double crossing;     ///< the time from left to right at the highest speed of the beginning
  std::string status;  ///< "complete", "collapse" or "limited"
  std::string why;     ///< of a limit

  /// Where a body is after that many contacts, at a time when no other was.
  double position(std::size_t body, std::size_t after, double time) const;
};

/// Runs a scene by events, whatever outputs it asks for; `most_contacts` of them, or fewer if the scene says so, end the
/// motion as "limited". Throws InvalidInput, with the scene's file, where it has more than `most_bodies_shown` bodies or
/// spans no time or no room that a double can hold.
SceneMotion follow_scene(Scene scene, std::int64_t most_contacts);
inline constexpr std::size_t most_bodies_shown = 200;
inline constexpr std::int64_t most_contacts_of_a_picture = 2000;

}  // namespace magicmass::command
