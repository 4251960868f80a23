// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "command/figure/figure.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/fast.hpp"

namespace magicmass::command {
namespace {

constexpr double reach = 2.75;  // of the sides that are drawn, in L

struct Point {
  double x, y;
};

Point polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

std::string collision_name(std::int64_t j) {
  return fmt::format("{}_{}", j % 2 == 0 ? "P" : "Q", j / 2 + 1);
}

/// A side of the wedge or an image of it, with its collision's name at the end. Two colours, as gnuplot's SVG takes the
/// dashes of arrows over to the next one of the same colour.
std::string side(std::int64_t image, double angle) {
  const Point tip = polar(reach, angle);
  const Point name = polar(reach + 0.13, angle);
  std::string text =
      fmt::format("set arrow from 0,0 to {:.9g},{:.9g} nohead back lw {} {}\n", tip.x, tip.y,
                  image < 2 ? 2.4 : 1,
                  image % 2 == 1 ? "dt solid lc rgb '#000000'" : "dt (8,4) lc rgb '#010101'");
  if (image > 0)
    text += fmt::format("set label '{}' at {:.9g},{:.9g} center\n", collision_name(image - 1),
                        name.x, name.y);
  return text;
}

}  // namespace

Figure wedge_figure() {
  const double alpha = fast::ratios(3).magic;
  const Counts counts = count_collisions(alpha).value();
  const double h = fast::angle(alpha) / 2;
  Figure figure{
      .title = "The collisions as a straight line through the unfolded wedge",
      .description = fmt::format(
          "A fan of rays from one point, each turned by h = psi/2 = {:.4g} degrees from the one "
          "before: the "
          "wedge of all places that A, C and B can take, shaded, and its mirror images. Solid rays "
          "are "
          "contacts of A and C, dashed ones of C and B; the distance from the tip is that from A "
          "to "
          "B. At alpha_3 one straight horizontal line, drawn thick from right to left, crosses the "
          "rays of the {} collisions P_1, Q_1, ..., Q_3, marked by dots. Folded back into the "
          "wedge it is the zigzag that the bodies really make, drawn dotted.",
          h * 180 / M_PI, counts.N_A + counts.N_B),
      .width = 860,
      .height = 480,
      .columns = {"collision", "t", "s", "angle", "x", "y", "x_folded", "y_folded"},
      .rows = {},
      .script =
          "set key off\nunset border\nunset tics\nset size ratio -1\nset margins 1,1,1,1\n"
          "set xrange [-3:3]\nset yrange [-0.25:2.95]\n"};
  const double height = fast::encounters(alpha, 0).s * std::sin(h);
  const auto row = [&](const std::string& name, double t, double s, double angle, Point unfolded,
                       Point folded) {
    figure.rows.push_back({text_cell(name), number_cell(t), number_cell(s), number_cell(angle),
                           number_cell(unfolded.x), number_cell(unfolded.y), number_cell(folded.x),
                           number_cell(folded.y)});
  };
  figure.script += side(0, 0.0);
  for (std::int64_t j = 0; j < counts.N_A + counts.N_B; ++j) {
    const auto [t, s] = fast::encounters(alpha, j);
    const double angle = static_cast<double>(j + 1) * h;
    row(collision_name(j), t, s, angle, polar(s, angle), polar(s, j % 2 == 0 ? h : 0.0));
    figure.script += side(j + 1, angle);
  }
  const Point tip = polar(reach, h);
  const double left = polar(fast::encounters(alpha, counts.N_A + counts.N_B - 1).s, 0.0).x;
  const Point away = polar(1.45, h);  // at a magic ratio A and C stay as they are
  figure.script += fmt::format(
      "set arrow from {0:.9g},0 to {1:.9g},{2:.9g} nohead lw 2 dt (1.5,2.5) lc rgb "
      "'#d55e00'\n"
      "set label 'C meets B' at 1.9,-0.12 center\n"
      "set label 'A meets C' at {3:.9g},{4:.9g} center rotate by {5:.9g}\n",
      left, left + away.x, away.y, polar(1.9, h).x - 0.05, polar(1.9, h).y + 0.11, h * 180 / M_PI);
  figure.script += fmt::format(
      "set object polygon from 0,0 to {0:.9g},0 to {1:.9g},{2:.9g} to 0,0 back fillstyle solid 1 "
      "noborder fc rgb '#e4e4e4'\n"
      "set arrow from 2.9,{3:.9g} to -2.9,{3:.9g} head filled size 0.12,18 lw 2.6 lc rgb "
      "'#0072b2'\n"
      "plot data using 5:6 with points pt 7 ps 0.9 lc rgb 'black' title 'collisions', "
      "data using 7:8 with lines lw 2 dt (1.5,2.5) lc rgb '#d55e00' title 'folded'\n",
      reach, tip.x, tip.y, height);
  return figure;
}

}  // namespace magicmass::command
