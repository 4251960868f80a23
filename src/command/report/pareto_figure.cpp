// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "command/gnuplot.hpp"
#include "command/report/figures.hpp"
#include "command/report/report_tables.hpp"

namespace magicmass::command {
namespace {

constexpr double lowest_ulp = 0.1;    // exact results have no logarithm
constexpr double highest_ulp = 1e40;  // for infinity, too

/// Where the number of a spot stands, in turn, so that those of neighbours seldom meet.
constexpr const char* corners[] = {"1.0,0.6", "1.0,-0.6", "-1.0,0.6", "-1.0,-0.6"};

struct Spot {
  std::string name;
  double ns, ulp;  ///< as drawn
  std::string shown_ulp;
  bool is_naive;
};

std::vector<Spot> spots_of(const MeasuredFamily& measured) {
  std::vector<Spot> spots;
  for (const Entry& entry : measured.entries) {
    if (entry.precision != "double" || !entry.time || entry.errors.empty()) continue;
    const double ulp = entry.worst().max_ulp;
    spots.push_back({entry.evaluator, entry.time->ns_median,
                     std::clamp(ulp, lowest_ulp, highest_ulp), short_number(ulp), entry.is_naive});
  }
  std::sort(spots.begin(), spots.end(), [](const Spot& left, const Spot& right) {
    return std::pair(left.ns, left.ulp) < std::pair(right.ns, right.ulp);
  });
  return spots;
}

bool is_on_frontier(const std::vector<Spot>& sorted, std::size_t which) {
  return std::none_of(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(which),
                      [&](const Spot& faster) { return faster.ulp <= sorted[which].ulp; });
}

}  // namespace

std::string pareto_figure(const MeasuredFamily& measured, const std::string& file) {
  const std::vector<Spot> spots = spots_of(measured);
  if (spots.empty() || measured.family.quantity == "counts") return "";
  std::string all;
  std::string frontier;
  std::string naive;
  std::string labels;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Spot& spot = spots[i];
    const std::string place = fmt::format("{:.6g} {:.6g}", spot.ns, spot.ulp);
    (spot.is_naive ? naive : all) += place + "\n";
    labels += fmt::format("set label {} '{}' at {:.6g},{:.6g} center offset {} font ',11'{}\n",
                          i + 101, i + 1, spot.ns, spot.ulp, corners[i % std::size(corners)],
                          spot.is_naive ? " tc rgb '#c00000'" : "");
    if (is_on_frontier(spots, i)) frontier += place + "\n";
    labels += fmt::format("set label {} {} at screen 0.665,{:.3f} font ',11' noenhanced{}\n", i + 1,
                          gnuplot_quoted(fmt::format("{:>2}  {}: {} ns, {} ulp", i + 1, spot.name,
                                                     short_number(spot.ns), spot.shown_ulp)),
                          0.86 - 0.045 * static_cast<double>(i),
                          spot.is_naive ? " tc rgb '#c00000'" : "");
  }
  const auto [least, most] =
      std::minmax_element(spots.begin(), spots.end(),
                          [](const Spot& left, const Spot& right) { return left.ulp < right.ulp; });
  const double slowest = spots.back().ns;
  frontier += fmt::format("{:.6g} {:.6g}\n", slowest * 3,
                          std::min_element(spots.begin(), spots.end(), [](auto& x, auto& y) {
                            return x.ulp < y.ulp;
                          })->ulp);
  return fmt::format(
             "reset\nset terminal svg size 900,520 font 'sans,13' background 'white'\n"
             "set output {}\n$all << END\n{}END\n$naive << END\n{}END\n$frontier << END\n{}END\n",
             gnuplot_quoted(file), all, naive, frontier) +
         fmt::format("set title {} noenhanced\n",
                     gnuplot_quoted(measured.family.quantity + ", " + measured.family.name +
                                    ": evaluators in double")) +
         "set lmargin screen 0.09\nset rmargin screen 0.64\nset logscale xy\n"
         "set format x '%h'\nset format y '10^{%L}'\nset grid lc rgb '#dddddd'\n"
         "set xlabel 'ns per evaluation (throughput)'\n"
         "set ylabel 'largest error in ulp'\n" +
         fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n",
                     spots.front().ns / 2, slowest * 2, std::min(least->ulp, 0.5) / 3,
                     std::max(most->ulp, 1.0) * 10) +
         labels + "set key off\n" +
         "plot $frontier using 1:2 with steps lw 1.5 lc rgb '#0060ad', "
         "$all using 1:2 with points pt 7 ps 0.7 lc rgb 'black', " +
         (naive.empty() ? "" : "$naive using 1:2 with points pt 9 ps 1.2 lc rgb '#c00000', ") +
         "0.5 with lines dt 3 lc rgb '#888888'\nunset output\n";
}

}  // namespace magicmass::command
