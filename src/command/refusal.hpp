// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "command/exit_code.hpp"
#include "derivation/derivation.hpp"

namespace magicmass::command {

/// check_failed, with the refused step's message on stderr, if a step was refused; else done.
ExitCode say_if_refused(const derivation::Derivation& derivation);

}  // namespace magicmass::command
