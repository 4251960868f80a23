// SPDX-License-Identifier: GPL-2.0-or-later
// The table of commands.
#pragma once

#include "command/command.hpp"

namespace command {

/// magicmass: its commands, one row each.
Program magicmass();

}  // namespace command
