// SPDX-License-Identifier: GPL-2.0-or-later
// Steps a scene's events in numbers of one type, and prints what it asks for as they happen.
#pragma once

#include "command/line_run.hpp"
#include "magicmass/simulator/line_audit.hpp"

namespace magicmass::command {

/// Of at most so many bodies velocities are kept.
inline constexpr std::size_t most_velocities = 1000;

/// Departure of energy and momentum from the start in last velocities that were not stepped to one by one. Where there
/// are walls, what they took was not measured, and momentum is missing.
template <class Float>
std::vector<Cell> drift_of(const Line<Float>& start, std::vector<Float> velocities);

/// Runs until no pair approaches, the limit, the scene's `until`, a collapse, or until exact numbers have become too
/// long: more than 2^17 bits, or what stands for ten seconds of work. Instantiated for double, long double, rationals and numbers of a field.
template <Field Scalar>
void step_line(const Scene& scene, const reference::ExactLine& line, Line<Scalar> start,
               std::int64_t limit, const LineListener& listener, LineResult& result);

}  // namespace magicmass::command
