// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command/line_run.hpp"

namespace magicmass::command {

/// What a scene came to as one JSON object without its closing brace and without events, or as readable text.
std::string line_json(const Scene& scene, const LineResult& result);
std::string line_text(const Scene& scene, const LineResult& result);
/// The one CSV row, with its header, of a scene that asked neither for events nor for a trajectory.
std::string line_csv(const LineResult& result);
std::string plan_json(const reference::Plan& plan);

}  // namespace magicmass::command
