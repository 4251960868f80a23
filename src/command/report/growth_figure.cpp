// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "command/gnuplot.hpp"
#include "command/report/figures.hpp"

namespace magicmass::command {
namespace {

bool is_drawn(const report::Growth& growth) {
  return growth.precision == "double" || growth.precision == "exact";
}

/// One panel: every growth along one scale.
std::string panel(const std::vector<report::Growth>& growths, const std::string& words,
                  double report::GrowthPoint::*value, const std::string& axis) {
  std::string data;
  std::string plots;
  int number = 0;
  for (const report::Growth& growth : growths) {
    if (growth.words != words || !is_drawn(growth)) continue;
    std::string points;
    for (const report::GrowthPoint& point : growth.points)
      if (std::isfinite(point.*value) && point.*value > 0)
        points += fmt::format("{:.6g} {:.6g}\n", point.x, point.*value);
    if (points.empty()) continue;
    data += fmt::format("$growth{} << END\n{}END\n", ++number, points);
    plots += fmt::format(
        "{}$growth{} using 1:2 with linespoints lw 1.5 ps 0.4 lc {} pt {} title {} noenhanced",
        number == 1 ? "plot " : ", ", number, number, number, gnuplot_quoted(growth.contestant));
  }
  if (number == 0) return "";
  return data + fmt::format("set xlabel {} noenhanced\nset ylabel {}\n{}\n", gnuplot_quoted(words),
                            gnuplot_quoted(axis), plots);
}

}  // namespace

std::string growth_figure(const std::vector<report::Growth>& growths, const std::string& file) {
  std::vector<std::string> panels;
  std::vector<std::string> seen;
  for (const report::Growth& growth : growths) {
    if (std::find(seen.begin(), seen.end(), growth.words) != seen.end()) continue;
    seen.push_back(growth.words);
    for (const auto& [value, axis] :
         {std::pair(&report::GrowthPoint::ns, "ns per evaluation"),
          std::pair(&report::GrowthPoint::max_ulp, "largest error in ulp")})
      if (std::string one = panel(growths, growth.words, value, axis); !one.empty())
        panels.push_back(std::move(one));
  }
  if (panels.empty()) return "";
  const std::size_t rows = (panels.size() + 1) / 2;
  std::string text = fmt::format(
      "reset\nset terminal svg size 1100,{} font 'sans,12' background 'white'\nset output {}\n"
      "set logscale xy\nset format x '10^{{%L}}'\nset format y '10^{{%L}}'\nset grid lc rgb "
      "'#dddddd'\nset key outside right top font ',10' samplen 1.5\nset multiplot layout {},2\n",
      420 * rows, gnuplot_quoted(file), rows);
  for (const std::string& one : panels) text += one;
  return text + "unset multiplot\nunset output\n";
}

}  // namespace magicmass::command
