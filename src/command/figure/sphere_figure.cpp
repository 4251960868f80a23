// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "command/figure/figure.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/cycle_matrices.hpp"
#include "magicmass/fast.hpp"

namespace magicmass::command {
namespace {

using Vector = std::array<double, 3>;
constexpr int steps_of_a_turn = 24;  // of the arc between two V_n

void add_row(Figure& figure, const std::string& part, const std::string& n, const Vector& v) {
  figure.rows.push_back(
      {text_cell(part), text_cell(n), number_cell(v[0]), number_cell(v[1]), number_cell(v[2])});
}

/// V_0 turned by `angle` about the last column of the frame R, and moved away from there by the factor `widened`.
Vector turned(const generated::Rows<double>& R, const Vector& V_0, double angle,
              double widened = 1.0) {
  Vector in_frame{};
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t row = 0; row < 3; ++row) in_frame[column] += R[row][column] * V_0[row];
  const double cosine = widened * std::cos(angle);
  const double sine = widened * std::sin(angle);
  const Vector moved = {cosine * in_frame[0] - sine * in_frame[1],
                        sine * in_frame[0] + cosine * in_frame[1], in_frame[2]};
  Vector v{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) v[row] += R[row][column] * moved[column];
  return v;
}

/// An orthographic view; what is behind has a depth below 0.
constexpr const char* view =
    "set key off\nunset border\nunset tics\nset size ratio -1\nset margins 1,1,1,1\n"
    "set xrange [-1.5:1.5]\nset yrange [-1.1:1.42]\nset parametric\nset trange [0:2*pi]\n"
    "set samples 400\nazimuth = 0.62\nheight = 0.42\n"
    "px(x,y,z) = -x*sin(azimuth) + y*cos(azimuth)\n"
    "py(x,y,z) = -(x*cos(azimuth) + y*sin(azimuth))*sin(height) + z*cos(height)\n"
    "depth(x,y,z) = (x*cos(azimuth) + y*sin(azimuth))*cos(height) + z*sin(height)\n";

}  // namespace

Figure sphere_figure() {
  const double alpha = fast::ratios(5).magic;
  const double psi = fast::angle(alpha);
  const std::int64_t cycles = count_collisions(alpha).value().N_B;
  const generated::Rows<double> R = generated::R(alpha);
  Figure figure{
      .title = "V_n turning about its axis on the unit sphere",
      .description = fmt::format(
          "A sphere seen from outside with the axes a, b and sqrt(alpha) c'. The tips of the "
          "vectors "
          "V_n = (a_n, b_n, sqrt(alpha) c'_n), dots named V_0 to V_{0}, lie on one circle about an "
          "axis "
          "that is drawn as an arrow through its centre; each step turns by psi = {1:.4g} degrees. "
          "At "
          "the magic ratio alpha_5 they go from the tip of a, where A has everything, to the tip "
          "of b, where B has. The way between them is solid, the rest of the circle dotted.",
          cycles, psi * 180 / M_PI),
      .width = 640,
      .height = 540,
      .columns = {"part", "n", "a", "b", "sqrt_alpha_c_prime"},
      .rows = {},
      .script = view};
  for (std::int64_t n = 0; n <= cycles; ++n)
    add_row(figure, "V_n", std::to_string(n), generated::V_n_tangent(alpha, n));
  add_row(figure, "axis", "", {R[0][2], R[1][2], R[2][2]});
  const std::size_t circle = figure.rows.size();
  const Vector V_0 = generated::V_n_tangent(alpha, 0);
  const auto arc = static_cast<std::size_t>(cycles) * steps_of_a_turn;
  const auto turn = static_cast<std::size_t>(std::ceil(2 * M_PI / psi * steps_of_a_turn));
  for (std::size_t i = 0; i <= turn; ++i)
    add_row(figure, "circle", "", turned(R, V_0, psi * static_cast<double>(i) / steps_of_a_turn));
  figure.script += fmt::format(
      "do for [i=1:3] {{\n"
      "  x = i == 1; y = i == 2; z = i == 3\n"
      "  set arrow from 0,0 to 1.28*px(x,y,z),1.28*py(x,y,z) head size 0.05,18 back lw 1 lc rgb "
      "'#777777'\n"
      "  set label word(\"a b √α·c'\", i) at 1.38*px(x,y,z),1.38*py(x,y,z) center\n}}\n"
      "set arrow from 0,0 to 1.25*px({0},{1},{2}),1.25*py({0},{1},{2}) head filled size "
      "0.06,18 lw 2.4 lc rgb 'black'\nset label 'axis' at "
      "1.64*px({0},{1},{2}),1.64*py({0},{1},{2}) center\n",
      R[0][2], R[1][2], R[2][2]);
  for (std::int64_t n = 0; n <= cycles; ++n) {  // names of the first and last beside their axes
    const double beside = static_cast<double>(n) / static_cast<double>(cycles) - 0.5;
    const Vector v = turned(R, V_0, psi * (static_cast<double>(n) + 0.7 * beside),
                            n == 0 || n == cycles ? 1.13 : 0.87);
    figure.script += fmt::format("set label 'V_{0}' at px({1},{2},{3}),py({1},{2},{3}) center\n", n,
                                 v[0], v[1], v[2]);
  }
  figure.script += fmt::format(
      "front(x,y,z) = depth(x,y,z) < 0 ? NaN : py(x,y,z)\n"
      "plot cos(t),sin(t) with lines lw 1.6 lc rgb '#777777' title 'sphere', "
      "px(0,cos(t),sin(t)),front(0,cos(t),sin(t)) with lines lw 0.8 lc rgb '#aaaaaa' title 'a = "
      "0', "
      "px(cos(t),0,sin(t)),front(cos(t),0,sin(t)) with lines lw 0.8 lc rgb '#aaaaaa' title 'b = "
      "0', "
      "px(cos(t),sin(t),0),front(cos(t),sin(t),0) with lines lw 0.8 lc rgb '#aaaaaa' title 'c = "
      "0', "
      "data every ::{2}::{3} using (px($3,$4,$5)):(py($3,$4,$5)) with lines lw 2 dt (1.5,3) lc "
      "rgb '#d55e00' title 'circle', "
      "data every ::{1}::{2} using (px($3,$4,$5)):(py($3,$4,$5)) with lines lw 2.4 dt solid lc "
      "rgb '#0072b2' title 'turning', "
      "data every ::0::{0} using (px($3,$4,$5)):(py($3,$4,$5)) with points pt 7 ps 0.9 lc rgb "
      "'black' title 'V_n'\n",
      cycles, circle, circle + arc, circle + turn);
  return figure;
}

}  // namespace magicmass::command
