// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "command/figure/figure.hpp"
#include "command/figure/ratio_grid.hpp"
#include "magicmass/batch.hpp"

namespace magicmass::command {
namespace {

constexpr double first = 0.0005;
constexpr double last = 1.0;

struct Series {
  double e;
  const char* line;   // how gnuplot draws it
  const char* shade;  // of its collapse
};

constexpr std::array<Series, 4> all_series = {
    {{1.0, "lw 2 dt solid lc rgb '#000000'", ""},
     {0.9, "lw 2.2 dt (12,4) lc rgb '#0072b2'", "#c4c4c4"},
     {0.8, "lw 2.2 dt (6,4) lc rgb '#d55e00'", "#d9d9d9"},
     {0.7, "lw 2.6 dt (1.5,2.5) lc rgb '#007a59'", "#ececec"}}};

}  // namespace

Figure transmission_figure() {
  Figure figure{.title = "Fraction rho of the energy that B takes, against the mass ratio",
                .description = "",
                .width = 860,
                .height = 580,
                .columns = {"alpha"},
                .rows = {},
                .script =
                    "set logscale x\nset yrange [0:1.04]\nset xlabel 'α = m/M'\n"
                    "set ylabel 'ρ = (b_t/V)^2' offset 1\nset xtics nomirror\n"
                    "set ytics nomirror\nset tmargin at screen 0.87\n"
                    "set key outside right center Left reverse samplen 4 spacing 1.4\n"};
  figure.script += fmt::format("set xrange [{}:{}]\n", first, last);
  std::vector<double> alpha = ratio_grid(first, last, 256);
  std::string collapses;
  std::vector<double> edges;  // of each series
  double left = first;
  for (const Series& series : all_series) {
    if (series.e == 1.0) {
      edges.push_back(0.0);
      continue;
    }
    const double edge = last_collapse(series.e);
    edges.push_back(edge);
    alpha.push_back(edge);
    for (int halvings = 3; halvings <= 40; ++halvings)  // the curve begins at the edge
      alpha.push_back(edge + std::ldexp(edge, -halvings));
    figure.script += fmt::format(
        "set object rectangle from {0}, graph 0 to {1}, graph 1 behind fillstyle solid 1 noborder "
        "fc "
        "rgb '{2}'\n"
        "set arrow from {1}, graph 0 to {1}, graph 1.01 nohead back lw 0.8 lc rgb '#666666'\n"
        "set label 'collapse' at {1}, graph 0.04 rotate offset -2.6,0 font ',10'\n"
        "set label 'e ≤ {3}' at {1}, graph 0.04 rotate offset -1.1,0 font ',10'\n"
        "set label 'α_c({3})' at {1}, graph {4} center\n",
        left, edge, series.shade, series.e, edges.size() % 2 == 0 ? 1.04 : 1.095);
    collapses += fmt::format("{} {:.3g} for e = {}", collapses.empty() ? "" : ",", edge, series.e);
    left = edge;
  }
  std::sort(alpha.begin(), alpha.end());
  alpha.erase(std::unique(alpha.begin(), alpha.end()), alpha.end());
  for (const double value : alpha) figure.rows.push_back({number_cell(value)});
  std::string plots;
  for (std::size_t k = 0; k < all_series.size(); ++k) {
    const Series& series = all_series[k];
    std::vector<double> rho(alpha.size());
    fast::transmission(alpha, series.e, rho);
    for (std::size_t i = 0; i < rho.size(); ++i)
      figure.rows[i].push_back(alpha[i] > edges[k] ? number_cell(rho[i]) : missing_cell());
    figure.columns.push_back(fmt::format("rho_{}", series.e));
    plots += fmt::format("{} data using 1:{} with lines {} title 'e = {}'",
                         plots.empty() ? "" : ",", figure.columns.size(), series.line, series.e);
  }
  figure.script += "plot" + plots + "\n";
  figure.description =
      "Four curves of rho = (b_t/V)^2 over the mass ratio alpha on a logarithmic axis, for the "
      "restitutions e = 1 (solid), 0.9 (long dashes), 0.8 (short dashes) and 0.7 (dotted). The "
      "elastic curve touches 1 at every magic ratio; the smaller e, the lower the curve and the "
      "further right its peaks. Up to alpha_c(e), which is" +
      collapses +
      ", the collisions never end and there is no curve: these regions are shaded, the darker the "
      "more of the curves have ended.";
  return figure;
}

}  // namespace magicmass::command
