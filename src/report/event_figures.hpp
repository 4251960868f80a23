// SPDX-License-Identifier: GPL-2.0-or-later
// How fast the simulator steps events, and what a body costs it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "magicmass/simulator/line.hpp"
#include "report/rounds.hpp"

namespace magicmass::report {

/// One figure of the simulator; `where` says of what.
struct EventFigure {
  std::string name;
  double value = 0.0;
  std::string where = {};
};

/// Names of the figures.
namespace events {
inline const std::string velocities = "three bodies, velocities only";  ///< million events a second
inline const std::string places = "three bodies, with times and places";  ///< likewise
inline const std::string short_chain = "chain of 1000 blocks";            ///< likewise
inline const std::string long_chain = "chain of 100000 blocks";           ///< likewise
inline const std::string memory = "bytes a body";
inline const std::string growth = "time an event ~ (log bodies)^p";  ///< p
}  // namespace events

/// Blocks and balls of random places and velocities between two walls, which go on for ever: the same in every run.
Line<double> busy_chain(std::size_t blocks);

/// All of them: works side by side in interleaved rounds of one process, of each the fastest round: what else runs only slows it. A repetition steps
/// three bodies 2^20 times, each chain of 10, 100, ..., 100000 blocks 2^14 times or as often as it
/// has bodies, on from where it is.
std::vector<EventFigure> event_figures(const Plan& plan);

/// Of a chain of so many blocks: the engine, and the scene it was read from.
double bytes_a_body(std::size_t blocks);

}  // namespace magicmass::report
