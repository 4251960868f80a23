// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "command/scene_run.hpp"

namespace magicmass::command {

/// What a scene came to, as "text", "json" or "csv". CSV holds the events, or the trajectory where no events were
/// asked for, or one line of counts and terminal velocities.
std::string scene_page(const Scene& scene, const SceneResult& result, const std::string& format);

}  // namespace magicmass::command
