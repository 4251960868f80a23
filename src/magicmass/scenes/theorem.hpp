// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of a trio or a cradle by theorems: counted, not stepped.
#pragma once

#include "magicmass/scenes/run.hpp"
#include "magicmass/scenes/trios.hpp"

namespace magicmass::scenes {

inline constexpr const char* at_until = "the scene ends at the time `until`";
std::string at_limit(std::int64_t limit);

/// The run of a trio or a cradle, each number the nearest double; of what is few and exact only its
/// plan, since there numbers may be just between doubles. Nothing for other scenes, and
/// where a collision may be as late as `until`. Throws Undecided where
/// a trio that nothing cuts off has more collisions than can be counted.
std::optional<Result> by_theorem(const Scene& scene);
/// Every so many of its collisions; of a collapse at least the first three, and more while doubles
/// can tell their times apart.
void stream_by_theorem(const Scene& scene, std::int64_t every, const Sink& sink);
/// Where its bodies are at a time, which is after so many collisions at most.
std::vector<double> places_by_theorem(const Scene& scene, std::int64_t most, const Value& time);

}  // namespace magicmass::scenes
