// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "command/figure/figure.hpp"

namespace magicmass::command {

const std::vector<FigureEntry>& figures() {
  static const std::vector<FigureEntry> all = {
      {"setup", "the initial state of A, C and B", setup_figure},
      {"counts", "N_A and N_B against alpha, with their thresholds", counts_figure},
      {"trajectories", "A, B and C in time: at alpha_3, above it, below it", trajectories_figure},
      {"terminal", "a_t, b_t and c_t against alpha", terminal_figure},
      {"transmission", "rho against alpha for four restitutions, and collapse",
       transmission_figure},
      {"cradle", "five blocks and four magic balls between walls, in space and time",
       cradle_figure},
      {"wedge", "the collisions as a straight line through the unfolded wedge", wedge_figure},
      {"sphere", "V_n turning about its axis on the unit sphere", sphere_figure},
      {"error", "how far evaluators are off, against alpha", error_figure},
  };
  return all;
}

std::string figure_csv(const Figure& figure) {
  std::string text = fmt::format("{}\n", fmt::join(figure.columns, ","));
  for (const std::vector<Cell>& row : figure.rows) text += csv_line(row);
  return text;
}

}  // namespace magicmass::command
