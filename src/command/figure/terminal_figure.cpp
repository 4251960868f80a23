// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/figure/figure.hpp"
#include "command/figure/ratio_grid.hpp"
#include "magicmass/batch.hpp"

namespace magicmass::command {

Figure terminal_figure() {
  const std::vector<double> alpha = ratio_grid(0.01, 2.0, 128);
  const std::size_t size = alpha.size();
  std::vector<std::int64_t> N_A(size), N_B(size);
  std::vector<double> a_t(size), b_t(size), c_t(size);
  accurate::terminal(alpha, N_A, N_B, a_t, b_t, c_t);
  Figure figure{
      .title = "Terminal velocities a_t, b_t and c_t against the mass ratio",
      .description =
          "Three curves over the mass ratio alpha from 0.01 to 2 on a logarithmic axis, in units "
          "of "
          "V. b_t of block B (solid) touches 1 at every magic ratio alpha_k and has a sharp "
          "minimum "
          "at every deficient ratio beta_k, where it meets c_t of the ball (dotted). At alpha_k "
          "both "
          "c_t and a_t of block A (dashed) are 0; between them c_t rises to a peak and a_t is "
          "below "
          "0, and above alpha_1 = 1 c_t rises for good. The smaller alpha, the closer b_t stays to "
          "1.",
      .width = 800,
      .height = 560,
      .columns = {"alpha", "N_A", "N_B", "a_t", "b_t", "c_t"},
      .rows = {},
      .script =
          "set logscale x\nset xrange [0.01:2]\nset yrange [-0.4:1.1]\nset xlabel 'α = m/M'\n"
          "set ylabel 'terminal velocity / V' offset 1\nset xtics nomirror\nset ytics nomirror\n"
          "set key above center horizontal Left reverse samplen 4 width 2\n"
          "set arrow from graph 0, first 0 to graph 1, first 0 nohead back lw 0.8 lc rgb "
          "'#999999'\n"
          "plot data using 1:5 with lines lw 2.5 dt solid lc rgb '#000000' title 'b_t', "
          "data using 1:6 with lines lw 3 dt (1.5,2.5) lc rgb '#d55e00' title 'c_t', "
          "data using 1:4 with lines lw 2 dt (9,5) lc rgb '#0072b2' title 'a_t'\n"};
  for (std::size_t i = 0; i < size; ++i)
    figure.rows.push_back({number_cell(alpha[i]), number_cell(N_A[i]), number_cell(N_B[i]),
                           number_cell(a_t[i]), number_cell(b_t[i]), number_cell(c_t[i])});
  return figure;
}

}  // namespace magicmass::command
