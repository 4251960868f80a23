// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "command/figure/figure.hpp"
#include "command/gnuplot.hpp"
#include "command/report/alpha_sweep.hpp"
#include "report/contestants.hpp"

namespace magicmass::command {
namespace {

constexpr double lowest_ulp = 0.01;
constexpr double highest_ulp = 1e5;
constexpr std::size_t points = 400;  // of each velocity
constexpr std::size_t first_evaluator = 3;

/// Each style wants a colour of its own: gnuplot's SVG takes the dashes of arrows over to the next one of the same.
std::string vertical_lines(const std::vector<double>& values, const char* style) {
  std::string text;
  for (const double value : values)
    text +=
        fmt::format("set arrow from {0:.9g}, graph 0 to {0:.9g}, graph 1 nohead back lw 0.7 {1}\n",
                    value, style);
  return text;
}

/// Errors that are drawn: 0 has no logarithm.
std::string within_axis(std::size_t column) {
  return fmt::format("(${0} < {1} ? {1} : ${0} > {2} ? {2} : ${0})", column, lowest_ulp,
                     highest_ulp);
}

/// One evaluator's errors of a_n and of b_n, whose rows follow each other, and the envelope of a_n.
std::string panel(const std::string& evaluator, std::size_t index, bool is_left, bool is_low) {
  const std::string of_a = fmt::format("data every ::0::{}", points - 1);
  const std::string of_b = fmt::format("data every ::{}::{}", points, 2 * points - 1);
  return fmt::format(
      "set label 1 {} at graph 0.97,0.92 right noenhanced\n{}{}"
      "plot {} using 2:{} with points pt 1 ps 0.5 lc rgb '#d55e00' title 'b_n', "
      "{} using 2:{} with points pt 7 ps 0.3 lc rgb 'black' title 'a_n', "
      "{} using 2:3 with lines lw 2 lc rgb '#0072b2' title 'envelope of a_n'\n"
      "set key off\n",
      gnuplot_quoted(evaluator),
      is_left ? "set format y '10^{%L}'\nset ylabel 'error in ulp' offset 1\n"
              : "set format y ''\nunset ylabel\n",
      is_low ? "set format x '%g'\nset xlabel 'α = m/M'\n" : "set format x ''\nunset xlabel\n",
      of_b, within_axis(first_evaluator + 1 + index), of_a,
      within_axis(first_evaluator + 1 + index), of_a);
}

}  // namespace

Figure error_figure() {
  report::Oracle oracle;
  Progress progress;
  const std::vector<AlphaSweep> sweeps =
      alpha_sweeps(report::contestants("velocities"), points, oracle, progress);
  progress.clear();
  if (sweeps.empty()) Progress::end_as_interrupted();
  const std::vector<std::string>& evaluators = sweeps[0].evaluators;
  const std::size_t lines = (evaluators.size() + 1) / 2;
  Figure figure{
      .title = "Errors of the evaluators of a_n and b_n against the mass ratio",
      .description = fmt::format(
          "{} panels, one for each way to compute the velocities in double: {}. Each shows, over "
          "the mass ratio alpha on a logarithmic axis, the error in units in the last place (ulp) "
          "of a_n at n = N_A (dots) and of b_n at n = N_B (crosses), and as a line the envelope of "
          "a_n: what rounding alpha alone costs. The envelope has a peak at every magic ratio "
          "(solid vertical lines), where a_n is 0, and is low at the deficient ones (dotted). The "
          "paper's formulas (naive) and the generated closed form are often far above it, most of "
          "all for small alpha; tier fast stays below it or close to it, and tier accurate at half "
          "an ulp or less everywhere.",
          evaluators.size(), fmt::join(evaluators, ", ")),
      .width = 900,
      .height = static_cast<int>(120 + 260 * lines),
      .columns = {"member", "alpha", "envelope"},
      .rows = {},
      .script = fmt::format(
          "set logscale xy\nset xrange [0.01:1.6]\nset yrange [{}:{}]\nset ytics 0.1,10,1e4\nset "
          "mytics 1\n"
          "set key at screen 0.98,0.995 right top horizontal maxrows 1 Left reverse samplen 2\n"
          "{}{}set multiplot layout {},2 margins 0.09,0.98,0.07,0.93 spacing 0.03,0.02\n",
          lowest_ulp, highest_ulp, vertical_lines(sweeps[0].magic, "lc rgb '#999999'"),
          vertical_lines(sweeps[0].deficient, "dt (2,4) lc rgb '#777777'"), lines)};
  for (const std::string& evaluator : evaluators) figure.columns.push_back("ulp_" + evaluator);
  for (std::size_t i = 0; i < evaluators.size(); ++i)
    figure.script += panel(evaluators[i], i, i % 2 == 0, i + 2 >= evaluators.size());
  figure.script += "unset multiplot\n";
  for (const AlphaSweep& sweep : sweeps)
    for (const AlphaSweep::Point& point : sweep.points) {
      figure.rows.push_back(
          {text_cell(sweep.member), number_cell(point.alpha), number_cell(point.envelope)});
      for (const double ulp : point.ulp)
        figure.rows.back().push_back(std::isnan(ulp) ? missing_cell() : number_cell(ulp));
    }
  return figure;
}

}  // namespace magicmass::command
