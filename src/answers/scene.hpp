// SPDX-License-Identifier: GPL-2.0-or-later
// What a scene needs, and how it moves.
#pragma once

#include "answers/request.hpp"

namespace answers {

/// The model that one scene's file needs, and why.
Answer plan(const Request& request);
/// A scene's motion. CSV and JSON Lines are its collisions, a row each, or where it wants no events
/// but a trajectory, that; text and JSON begin with what it comes to. Rows are written as they
/// come.
Answer simulate(const Request& request);

}  // namespace answers
