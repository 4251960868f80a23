// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "command/report/alpha_sweep.hpp"
#include "command/report/measurement.hpp"
#include "report/growth.hpp"

namespace magicmass::command {

/// A figure as gnuplot commands that hold their data; empty where there is nothing to draw.
std::string pareto_figure(const MeasuredFamily& measured, const std::string& file);
std::string alpha_figure(const std::vector<AlphaSweep>& sweeps, const std::string& file);
std::string growth_figure(const std::vector<report::Growth>& growths, const std::string& file);

/// Makes the folder and writes the figures' gnuplot script into it; throws InvalidInput where it cannot.
void prepare_folder(const std::filesystem::path& folder);
/// SVG files into a prepared folder. A line that says what is missing, or nothing.
std::string draw_figures(const Measurement& measurement, const std::filesystem::path& folder);

/// "velocities, magic neighbours" as part of a file's name.
std::string file_name(const std::string& words);

}  // namespace magicmass::command
