// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace magicmass::command {

enum class Drawing { done, no_gnuplot, failed };

/// Runs gnuplot on a script that stands in the folder, there, so that figures which name their data name no path of
/// this machine; what it says goes into gnuplot.log beside it.
Drawing run_gnuplot(const std::filesystem::path& folder, const std::string& script);

/// Text in a gnuplot string.
std::string gnuplot_quoted(const std::string& text);

}  // namespace magicmass::command
