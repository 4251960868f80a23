// SPDX-License-Identifier: GPL-2.0-or-later
// Runs any scene by the model planned for it, and hands on events and trajectory points as they come.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "command/records.hpp"
#include "magicmass/reference/exact_line.hpp"
#include "magicmass/reference/scene_plan.hpp"

namespace magicmass::command {

/// Columns of an event: number, left, right, time, position, v_left, v_right; of a trajectory point: t, body, x.
extern const std::vector<std::string> line_event_columns;
extern const std::vector<std::string> line_point_columns;

/// Called with each event and each trajectory point; nothing is kept.
struct LineListener {
  std::function<void(const std::vector<Cell>&)> on_event;
  std::function<void(const std::vector<Cell>&)> on_point;
};

struct LineResult {
  std::string status;  ///< "complete", "collapse" or "limited"
  std::string why;     ///< of a collapse that no theorem told, or of a limit
  reference::Plan plan;
  bool fractions = false;      ///< exact rationals are printed as such
  Cell contacts;               ///< how many; missing in a collapse
  std::vector<Cell> counts;    ///< N_A and N_B, of three bodies or two and a wall
  std::int64_t stepped = 0;    ///< events that were stepped
  std::int64_t evaluated = 0;  ///< quantities that were evaluated in closed form
  std::int64_t near_ties = 0;
  std::int64_t simultaneous = 0;
  std::vector<Cell> velocities;  ///< at the end of the run, a body each, up to 1000 of them
  std::vector<Cell> collapse;    ///< time and position
  std::vector<Cell> drift;       ///< if asked for: energy, momentum
  std::vector<Cell> cradle;      ///< transfers: how many, round trips, the block that moves
};

/// Throws as plan_line does, and Undecided where the answer does not fit.
LineResult run_line(const Scene& scene, const reference::ExactLine& line,
                    const reference::SceneOptions& options, const LineListener& listener);

}  // namespace magicmass::command
