// SPDX-License-Identifier: GPL-2.0-or-later
// Scripts that complete commands, options and their values, one for each shell.
#pragma once

#include <string>

#include "command/manual/command_tree.hpp"

namespace magicmass::command {

std::string bash_completion(const CommandText& program);
std::string zsh_completion(const CommandText& program);
std::string fish_completion(const CommandText& program);

/// 'text', as one word of each of these shells.
std::string shell_quoted(const std::string& text);

}  // namespace magicmass::command
