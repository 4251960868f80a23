// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/figure/figure.hpp"
#include "magicmass/fast.hpp"

namespace magicmass::command {

Figure setup_figure() {
  const double alpha = fast::ratios(3).magic;
  const auto v = fast::velocities(alpha, 0);
  Figure figure{
      .title = "The initial state of the three bodies",
      .description =
          "A horizontal line with three bodies on it. Block A of mass M, at the left, moves to the "
          "right with velocity V. The ball C of mass m = alpha M rests at x = 0. Block B of mass "
          "M, "
          "as large as A, rests at x = L.",
      .width = 700,
      .height = 200,
      .columns = {"body", "mass", "x", "velocity"},
      .rows = {},
      .script =
          "set key off\nset xrange [-1.5:1.5]\nset yrange [-0.36:0.46]\nunset border\nunset ytics\n"
          "set size ratio -1\nset margins 1,1,0,0\nunset xtics\n"
          "set arrow from -1.45,-0.16 to 1.45,-0.16 nohead lw 1.5 lc rgb 'black'\n"
          "set arrow from 0,-0.18 to 0,-0.14 nohead lc rgb 'black'\n"
          "set arrow from 1,-0.18 to 1,-0.14 nohead lc rgb 'black'\n"
          "set label '0' at 0,-0.25 center\nset label 'L' at 1,-0.25 center \n"
          "set label 'x' at 1.45,-0.25 center\n"
          "set label 'A' at -1,0 center front\nset label 'B' at 1,0 center front\n"
          "set label 'M' at -1,0.25 center\nset label 'M' at 1,0.25 center\n"
          "set label 'C' at 0,0.07 center\nset label 'm = αM' at 0,0.25 center\n"
          "set label 'V' at -0.55,0.12 center\n"
          "plot data every 2 using 3:(0):(0.16):(0.16) with boxxyerror lc rgb '#0072b2' lw 2 fs "
          "solid "
          "0.25 border title 'blocks', "
          "data every ::1::1 using 3:(-0.09):(0.07) with circles lc rgb '#d55e00' lw 2 fs solid "
          "0.6 "
          "border title 'ball', "
          "data every ::0::0 using ($3+0.2):(0):(0.45*$4):(0) with vectors head filled size "
          "0.07,20 lw 2.5 lc rgb 'black' title 'velocity'\n"};
  figure.rows = {
      {text_cell("A"), number_cell(1.0), number_cell(-1.0), number_cell(v.a)},
      {text_cell("C"), number_cell(alpha), number_cell(0.0), number_cell(v.c)},
      {text_cell("B"), number_cell(1.0), number_cell(1.0), number_cell(v.b)},
  };
  return figure;
}

}  // namespace magicmass::command
