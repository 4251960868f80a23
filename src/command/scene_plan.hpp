// SPDX-License-Identifier: GPL-2.0-or-later
// Picks the cheapest model that gives what a scene asks for, and says why.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "command/program.hpp"
#include "magicmass/reference/exact_line.hpp"
#include "magicmass/reference/trio_end.hpp"
#include "magicmass/scenes/scene.hpp"
#include "magicmass/simulator/line_motion.hpp"

namespace magicmass::command {

enum class Model { closed_form, velocity_stepping, event_driven, exact_events, transfers };

/// "closed form", "velocity stepping", "event-driven", "exact events", "transfers".
std::string to_text(Model model);
/// The same with hyphens, as --model takes it. Throws InvalidInput.
Model parse_model(const std::string& name);

/// In which events are stepped. planned: in doubles, or exactly where doubles cannot tell.
enum class Scalars { planned, doubles, long_doubles, exact };

struct SceneOptions {
  std::optional<std::int64_t> max_events;  ///< 1000000 where neither this nor the scene says
  Scalars scalars = Scalars::planned;      ///< other than planned: events are stepped
  std::string model;                       ///< empty: the cheapest
};
inline constexpr std::int64_t usual_max_events = 1'000'000;
/// --model, --scalar and --max-events.
void add_model_option(CLI::App& command, SceneOptions& options);
std::int64_t event_limit(const Scene& scene, const SceneOptions& options);

/// The model chosen, why, and how many events it steps through.
struct Plan {
  std::string model;
  std::string reason;
  cln::cl_I events;
};

/// A plan together with what was found out on the way.
struct LinePlan {
  Model model;
  Plan plan;
  std::optional<reference::TrioEnd> end;  ///< where theorems hold
};

/// Plans a scene. Steps through events, in doubles and without any output, where only that tells how many there are
/// and whether doubles can decide them. Throws InvalidInput where the model asked for cannot give the outputs, and where a
/// trajectory would take more events than the limit, with what to ask for instead.
LinePlan plan_line(const Scene& scene, const reference::ExactLine& line,
                   const SceneOptions& options);

/// The limit is in the way of this many events: what else to ask for. Throws InvalidInput.
[[noreturn]] void refuse_as_too_long(const Scene& scene, const cln::cl_I& events,
                                     std::int64_t limit);

}  // namespace magicmass::command
