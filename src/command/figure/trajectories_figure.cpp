// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>

#include <cln/integer.h>
#include <fmt/format.h>

#include "command/alpha_value.hpp"
#include "command/figure/figure.hpp"
#include "command/gnuplot.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/reference/count.hpp"

namespace magicmass::command {
namespace {

constexpr double begin = -1.0;     // in L/V, one before the first collision
constexpr double last_time = 5.5;  // a good L/V after the last collision of each panel

struct Panel {
  std::string name;
  std::string title;
  MassRatio alpha;
};

/// Bodies move freely from collision to collision: the times and velocities are the evaluators'.
class FreeMotion {
public:
  FreeMotion(Figure& figure, const Panel& panel, double alpha)
      : figure_(figure), panel_(panel), alpha_(alpha) {
    save();
  }

  void move_to(double time) {
    const double step = time - time_;
    for (std::size_t body = 0; body < 3; ++body) place_[body] += velocity_[body] * step;
    time_ = time;
    save();
  }

  void set_velocities(const std::array<double, 3>& velocity) { velocity_ = velocity; }

private:
  Figure& figure_;
  const Panel& panel_;
  double alpha_;
  double time_ = begin;
  std::array<double, 3> place_ = {begin, 1.0, 0.0};  // A, B, C; A reaches C at x = 0, t = 0
  std::array<double, 3> velocity_ = {1.0, 0.0, 0.0};

  void save() {
    figure_.rows.push_back({text_cell(panel_.name), number_cell(alpha_), number_cell(time_),
                            number_cell(place_[0]), number_cell(place_[1]),
                            number_cell(place_[2])});
  }
};

void add_panel(Figure& figure, const Panel& panel) {
  const reference::LargeCounts counts = reference::count_collisions(panel.alpha);
  const std::int64_t collisions = cln::cl_I_to_long(counts.N_A + counts.N_B);
  const double alpha = nearest_double(panel.alpha);
  FreeMotion motion(figure, panel, alpha);
  for (std::int64_t j = 0; j < collisions; ++j) {
    motion.move_to(fast::encounters(alpha, j).t);
    const bool with_A = j % 2 == 0;
    const auto now = fast::velocities(alpha, with_A ? j / 2 + 1 : (j + 1) / 2);
    const double b = with_A ? fast::velocities(alpha, j / 2).b : now.b;
    motion.set_velocities({now.a, b, with_A ? now.c : now.c_prime});
  }
  motion.move_to(last_time);
}

}  // namespace

Figure trajectories_figure() {
  Figure figure{
      .title = "Trajectories of A, B and C at a magic mass ratio and on either side of it",
      .description =
          "Three panels, each with position over time of block A (solid, lower), block B (solid, "
          "upper) and the ball C (dashed), which bounces between them. (a) At the magic ratio "
          "alpha_3 A "
          "and C come to rest after three collisions each, and B leaves with the speed V that A "
          "came "
          "with. (b) At 0.12, above it, A turns back after three collisions and C follows B. (c) "
          "At 0.10, "
          "below it, C comes back to A for a fourth collision and all three part.",
      .width = 640,
      .height = 900,
      .columns = {"panel", "alpha", "t", "x_A", "x_B", "x_C"},
      .rows = {},
      .script = fmt::format(
          "set key off\nset xrange [{}:{}]\nset yrange [-1:5]\nset ytics -1,1,5\n"
          "set ylabel 'x / L'\nset label 2 'A' at -0.45,-0.75\nset label 3 'B' at -0.6,1.4\n"
          "set label 4 'C' at -0.8,0.35\n"
          "set multiplot layout 3,1 margins 0.1,0.97,0.08,0.97 spacing 0.03,0.025\n",
          begin, last_time)};
  const std::array<Panel, 3> panels = {
      {{"a", "α = α_3 = {:.4f}", Magic{3}}, {"b", "α = {:.2f}", 0.12}, {"c", "α = {:.2f}", 0.10}}};
  for (const Panel& panel : panels) {
    const std::size_t first_row = figure.rows.size();
    add_panel(figure, panel);
    const std::string rows = fmt::format("every ::{}::{}", first_row, figure.rows.size() - 1);
    const std::string title = "(" + panel.name + ")  " +
                              fmt::format(fmt::runtime(panel.title), nearest_double(panel.alpha));
    figure.script += fmt::format(
        "set label 1 {} at graph 0.03,0.88\n{}"
        "plot data {rows} using 3:4 with lines lw 2 dt solid lc rgb 'black' title 'A', "
        "data {rows} using 3:5 with lines lw 2 dt solid lc rgb 'black' title 'B', "
        "data {rows} using 3:6 with lines lw 1.8 dt (7,4) lc rgb '#d55e00' title 'C'\n",
        gnuplot_quoted(title),
        panel.name == "c" ? "set format x '%g'\nset xlabel 't / (L/V)'\n"
                          : "set format x ''\nunset xlabel\n",
        fmt::arg("rows", rows));
  }
  figure.script += "unset multiplot\n";
  return figure;
}

}  // namespace magicmass::command
