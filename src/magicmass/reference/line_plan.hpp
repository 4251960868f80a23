// SPDX-License-Identifier: GPL-2.0-or-later
// What the plan of a scene is made of, for who goes on to run it; scene_plan.hpp is what to call for the plan alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "magicmass/reference/exact_line.hpp"
#include "magicmass/reference/scene_plan.hpp"
#include "magicmass/reference/trio_end.hpp"

namespace magicmass::reference {

/// What answers a scene: theorems; stepping velocities; stepping events in floating point or exactly; theorems of a cradle.
enum class Model { closed_form, velocity_stepping, event_driven, exact_events, transfers };

/// "closed form", "velocity stepping", "event-driven", "exact events", "transfers".
std::string to_text(Model model);
/// The same with hyphens, as --model takes it. Throws InvalidInput.
Model parse_model(const std::string& name);

/// A plan together with what was found out on the way.
struct LinePlan {
  Model model;                 ///< the one chosen
  Plan plan;                   ///< the same in words
  std::optional<TrioEnd> end;  ///< where theorems hold
};

/// Plans a scene. Steps through events, in doubles and without any output, where only that tells how many there are
/// and whether doubles can decide them. Throws InvalidInput where the model asked for cannot give the outputs, and where a
/// trajectory would take more events than the limit, with what to ask for instead.
LinePlan plan_line(const Scene& scene, const ExactLine& line, const SceneOptions& options);

/// A scene for plan_papers_scene: the paper's initial state, no model asked for, nothing left out and no times of its own.
bool is_papers_scene(const Scene& scene, const SceneOptions& options);

/// Its plan, from counts alone. Throws InvalidInput where a list of events would be longer than the usual limit and no other
/// was set.
Plan plan_papers_scene(const Scene& scene, const SceneOptions& options);

/// The limit is in the way of this many events: what else to ask for. Throws InvalidInput.
[[noreturn]] void refuse_as_too_long(const Scene& scene, const cln::cl_I& events,
                                     std::int64_t limit);

}  // namespace magicmass::reference
