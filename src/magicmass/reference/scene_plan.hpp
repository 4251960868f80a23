// SPDX-License-Identifier: GPL-2.0-or-later
// Picks the cheapest model that gives what a scene asks for, and says why.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <cln/integer.h>

#include "magicmass/scenes/scene.hpp"

namespace magicmass::reference {

/// In which events are stepped. planned: in doubles, or exactly where doubles cannot tell.
enum class Scalars { planned, doubles, long_doubles, exact };

/// What is asked of a run besides what the scene says.
struct SceneOptions {
  std::optional<std::int64_t> max_events;  ///< 1000000 where neither this nor the scene says
  Scalars scalars =
      Scalars::planned;  ///< other than planned: events are stepped, if any are wanted
  std::string model;     ///< as Plan's, with hyphens; empty: the cheapest
};
/// Events that are stepped where nothing else is said.
inline constexpr std::int64_t usual_max_events = 1'000'000;
/// How many events may be stepped: the options' number, else the scene's, else the usual one.
std::int64_t event_limit(const Scene& scene, const SceneOptions& options);

/// The model chosen, why, and how many events it steps through.
struct Plan {
  std::string
      model;  ///< "closed form", "velocity stepping", "event-driven", "exact events" or "transfers"
  std::string reason;  ///< a clause
  cln::cl_I events;    ///< 0 where none is stepped
};

/// The plan of any scene: what `magicmass plan` says. Throws InvalidInput where the scene makes no
/// sense (file, line and key), where the model asked for cannot give the outputs, and where a trajectory would take more events
/// than the limit, with what to ask for instead; Undecided where no precision allowed tells the collisions' number.
Plan plan(const Scene& scene, const SceneOptions& options = {});

}  // namespace magicmass::reference
