// SPDX-License-Identifier: GPL-2.0-or-later
// Runs the paper's scenes, equal blocks and elastic contacts, by the paper's own formulas and in the paper's terms.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command/records.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/scene_plan.hpp"
#include "magicmass/scenes/scene.hpp"

namespace magicmass::command {

/// Columns of an event: body, n, time, position, a, b, c; of a trajectory point: t, x_A, x_B, x_C.
extern const std::vector<std::string> event_columns;
extern const std::vector<std::string> trajectory_columns;

struct SceneResult {
  std::string status;   ///< "complete" or "limited"
  Cell computed_alpha;  ///< the number that was computed with
  reference::Plan plan;
  reference::LargeCounts counts;                  ///< exact, for alpha as it was written
  std::optional<reference::LargeCounts> stepped;  ///< collisions that the event loop went through
  std::vector<Cell> terminal;                     ///< a_t, b_t, c_t in units of the scene; rho
  std::vector<std::vector<Cell>> events;          ///< if asked for
  std::vector<std::vector<Cell>>
      trajectory;  ///< if asked for: one L/V before P_1, each event, one L/V after the last
  std::vector<Cell> drift;  ///< if asked for: energy, momentum
};

/// A scene that is_papers_scene. Throws InvalidInput where exact arithmetic was asked for and alpha is irrational, Undecided where the answer
/// does not fit.
SceneResult run_scene(const Scene& scene, const reference::SceneOptions& options);

}  // namespace magicmass::command
