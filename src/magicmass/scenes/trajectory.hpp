// SPDX-License-Identifier: GPL-2.0-or-later
// Where bodies are: between their collisions they move on straight lines.
#pragma once

#include "magicmass/scenes/run.hpp"

namespace magicmass::scenes {

struct Point {
  Number time;
  std::size_t body;
  Number position;
};

/// All bodies at each of the scene's `times` at which the motion is known. Where the scene has
/// none, the corners of their lines: all bodies at time 0, those that meet at each collision that
/// the scene wants to see, and all where the run ends.
void trajectory(const Scene& scene, const Result& result,
                const std::function<void(const Point&)>& sink);

}  // namespace magicmass::scenes
