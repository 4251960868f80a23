// SPDX-License-Identifier: GPL-2.0-or-later
// A figure: its numbers, all from the evaluators, and how gnuplot is to show them.
#pragma once

#include <string>
#include <vector>

#include "command/records.hpp"
#include "command/scene_motion.hpp"

namespace magicmass::command {

struct Figure {
  std::string title;
  std::string description;  ///< what there is to see, for who does not see it
  int width;                ///< in SVG pixels
  int height;
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;  ///< the CSV file
  std::string script;                   ///< gnuplot commands that read the rows as `data`
};

/// What --list shows, and the figure when it is asked for.
struct FigureEntry {
  std::string name;
  std::string summary;
  Figure (*make)();
};

/// All figures, in the order of the paper, then those of our own.
const std::vector<FigureEntry>& figures();

Figure setup_figure();
Figure counts_figure();
Figure trajectories_figure();
Figure terminal_figure();
Figure transmission_figure();
Figure cradle_figure();
Figure wedge_figure();
Figure sphere_figure();
Figure error_figure();

/// One round trip of five blocks and four magic balls between walls, which cradle_figure draws.
SceneMotion cradle_motion();

/// Header and rows as CSV.
std::string figure_csv(const Figure& figure);

}  // namespace magicmass::command
