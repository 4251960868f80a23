// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "command/alpha_value.hpp"
#include "command/figure/figure.hpp"
#include "command/figure/ratio_grid.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::command {
namespace {

constexpr double first = 0.01;
constexpr double last = 2.0;
constexpr std::int64_t last_named = 5;  // further thresholds are too close for a name each

/// A thin line at a threshold and, where there is room, its name above the frame: the deficient ones a line higher.
std::string threshold_line(const MassRatio& ratio) {
  const auto* magic = std::get_if<Magic>(&ratio);
  const std::int64_t k = magic != nullptr ? magic->k : std::get<Deficient>(ratio).k;
  const double alpha = nearest_double(ratio);
  std::string text =
      fmt::format("set arrow from {0}, graph 0 to {0}, graph {1} nohead back lw 0.8 {2}\n", alpha,
                  magic != nullptr ? "1.015" : "1.055",
                  magic != nullptr ? "dt solid lc rgb '#999999'" : "dt (2,4) lc rgb '#666666'");
  if (k <= last_named)
    text += fmt::format("set label '{}_{{{}}}' at {}, graph {} center\n",
                        magic != nullptr ? "α" : "β", k, alpha, magic != nullptr ? 1.035 : 1.085);
  return text;
}

std::vector<Cell> row(const MassRatio& alpha, const std::string& threshold) {
  const reference::LargeCounts counts = reference::count_collisions(alpha);
  return {number_cell(nearest_double(alpha)), digits_cell(reference::to_text(counts.N_A)),
          digits_cell(reference::to_text(counts.N_B)), text_cell(threshold)};
}

}  // namespace

Figure counts_figure() {
  Figure figure{
      .title = "Numbers of collisions N_A and N_B against the mass ratio",
      .description =
          "Two falling staircases over the mass ratio alpha from 0.01 to 2 on a logarithmic axis. "
          "N_A "
          "(thin black line) drops to k at the magic ratio alpha_k, N_B (thick grey line) drops to "
          "k "
          "at the deficient ratio beta_k, so that both are the same from alpha_k to beta_(k-1). "
          "Thin vertical lines show these thresholds, alpha_k solid and beta_k dotted; those of "
          "k = 1 to 5 are named.",
      .width = 800,
      .height = 560,
      .columns = {"alpha", "N_A", "N_B", "threshold"},
      .rows = {row(first, "")},
      .script =
          "set logscale x\nset xlabel 'α = m/M'\nset ylabel 'number of collisions' offset 1\n"
          "set tmargin at screen 0.88\nset ytics 0,1 nomirror\nset xtics nomirror\n"
          "set key at graph 0.85,0.9 right top samplen 3 spacing 1.3\n"};
  figure.script += fmt::format("set xrange [{}:{}]\nset yrange [0:12]\n", first, last);
  for (const MassRatio& ratio : thresholds(first, last)) {
    figure.rows.push_back(row(ratio, to_text(ratio)));
    figure.script += threshold_line(ratio);
  }
  figure.rows.push_back(row(last, ""));
  figure.script +=
      "plot data using 1:3 with steps lw 7 lc rgb '#b0b0b0' title 'N_B', "
      "data using 1:2 with steps lw 2 lc rgb 'black' title 'N_A'\n";
  return figure;
}

}  // namespace magicmass::command
