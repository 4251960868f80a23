// SPDX-License-Identifier: GPL-2.0-or-later
// The generalised Newton's cradle by theorems chain.*: what one block brings, a magic ball hands on to the next whole.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <cln/integer.h>

#include "magicmass/reference/exact_line.hpp"
#include "magicmass/scenes/scene.hpp"

namespace magicmass::reference {

/// Why a scene is no such cradle, or nothing if it is one: equal blocks with a magic ball between each two, elastic, all
/// at rest but the first block, which moves to the right, and no block reaches the next ball (or wall) before the ball
/// behind it is at rest: how far it moves before (chain.room) is at most that distance (chain.one_at_a_time).
std::optional<std::string> why_no_cradle(const ExactLine& line);

/// Where a cradle is after the last whole transfer within its limits. All bodies but one block are at rest, exactly.
struct CradleEnd {
  bool complete = false;      ///< the block that moves will meet nothing any more
  bool is_whole = true;       ///< `until` is not seen to be in the middle of a transfer
  cln::cl_I contacts = 0;     ///< so far
  cln::cl_I transfers = 0;    ///< whole ones
  cln::cl_I round_trips = 0;  ///< back at the first block, moving right
  std::size_t mover = 0;      ///< body number
  int direction = 1;          ///< its velocity is V or -V
};

/// Runs transfer by transfer: through ball j with magic ratio k takes 2k contacts. A transfer ends where the block
/// that came in would be without any contact, so the mover's way is a straight line between the walls. Stops before
/// `until`, counted from the start, or before more than most_contacts.
CradleEnd run_cradle(const ExactLine& line, const cln::cl_I& most_contacts);

}  // namespace magicmass::reference
