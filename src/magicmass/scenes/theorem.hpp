// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of a trio by theorems: counted, not stepped.
#pragma once

#include "magicmass/scenes/run.hpp"
#include "magicmass/scenes/trio.hpp"

namespace magicmass::scenes {

/// All but the plan, each number the nearest double. Throws Undecided where that is not certain
/// with the bits that are allowed, std::domain_error where masses are too far apart.
Result by_theorem(const Trio& trio, std::optional<std::int64_t> collisions);
/// The collisions, each number the nearest double.
void stream_by_theorem(const Trio& trio, std::int64_t collisions, const Sink& sink);

}  // namespace magicmass::scenes
