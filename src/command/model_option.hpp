// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "magicmass/reference/scene_plan.hpp"

namespace CLI {
class App;
}

namespace magicmass::command {

/// --model, --scalar and --max-events.
void add_model_option(CLI::App& command, reference::SceneOptions& options);

}  // namespace magicmass::command
