// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace magicmass::command {

/// What the figures depend on, in order: machine, compiler, flags, ... No date, no path, no user.
using Provenance = std::vector<std::pair<std::string, std::string>>;

Provenance provenance();

/// As the kernel calls it.
std::string processor_name();

}  // namespace magicmass::command
