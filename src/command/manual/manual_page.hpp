// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "command/manual/command_tree.hpp"

namespace magicmass::command {

/// "magicmass-eval.1" of "magicmass eval".
std::string manual_page_name(const CommandText& command);

/// The command's page for man(1); no date, so that the same tree gives the same bytes.
std::string manual_page(const CommandText& command, const std::string& version);

}  // namespace magicmass::command
