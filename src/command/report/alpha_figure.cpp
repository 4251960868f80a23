// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "command/gnuplot.hpp"
#include "command/report/figures.hpp"

namespace magicmass::command {
namespace {

constexpr double lowest_ulp = 0.01;
constexpr double highest_ulp = 1e17;

std::string thresholds(const std::vector<double>& values, const std::string& style) {
  std::string text;
  for (const double value : values)
    text += fmt::format("set arrow from {0:.9g}, graph 0 to {0:.9g}, graph 1 nohead {1}\n", value,
                        style);
  return text;
}

std::string panel(const AlphaSweep& sweep) {
  std::string data = fmt::format("$sweep_{} << END\n", sweep.member);
  for (const AlphaSweep::Point& point : sweep.points) {
    data += fmt::format("{:.9g} {:.6g}", point.alpha, point.envelope);
    for (const double ulp : point.ulp)
      data += std::isnan(ulp) ? std::string(" ?")
                              : fmt::format(" {:.6g}", std::clamp(ulp, lowest_ulp, highest_ulp));
    data += "\n";
  }
  data += "END\n";
  std::string plots = fmt::format(
      "plot $sweep_{} using 1:2 with lines lw 2 lc rgb 'black' title 'envelope'", sweep.member);
  for (std::size_t i = 0; i < sweep.evaluators.size(); ++i)
    plots += fmt::format(
        ", $sweep_{} using 1:{} with points pt {} ps 0.35 lc {} title {} noenhanced", sweep.member,
        i + 3, i % 2 == 0 ? 7 : 5, i + 1, gnuplot_quoted(sweep.evaluators[i]));
  return data + "unset arrow\n" + thresholds(sweep.magic, "lc rgb '#bbbbbb'") +
         thresholds(sweep.deficient, "lc rgb '#b0c8f0'") +
         fmt::format("set ylabel 'error of {}_n in ulp' noenhanced\n{}\n", sweep.member, plots);
}

}  // namespace

std::string alpha_figure(const std::vector<AlphaSweep>& sweeps, const std::string& file) {
  if (sweeps.empty()) return "";
  std::string text = fmt::format(
      "reset\nset terminal svg size 1000,{} font 'sans,13' background 'white'\nset output {}\n"
      "set logscale xy\nset format y '10^{{%L}}'\nset xrange [0.01:1.6]\nset datafile missing '?'\n"
      "set yrange [{}:]\n"
      "set key outside right top font ',10' samplen 1.5\n"
      "set xlabel 'α; a at n = N_A, b at n = N_B; magic ratios: grey lines, deficient: blue' "
      "noenhanced\n"
      "set multiplot layout {},1\n",
      430 * sweeps.size(), gnuplot_quoted(file), lowest_ulp, sweeps.size());
  for (const AlphaSweep& sweep : sweeps) text += panel(sweep);
  return text + "unset multiplot\nunset output\n";
}

}  // namespace magicmass::command
