// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/figures.hpp"

#include <algorithm>
#include <cmath>

#include "answers/evaluate.hpp"
#include "answers/motion.hpp"
#include "kernel/print.hpp"

namespace answers {
namespace {

using notation::Alpha;
using notation::Deficient;
using notation::Magic;

Column real_column(const std::string& name) { return {name, Type::real, "", ""}; }

/// alpha_k and beta_k down to a mass ratio, from the largest.
std::vector<Alpha> thresholds_above(double least) {
  std::vector<Alpha> all;
  for (int k = 1;; ++k) {
    for (const Alpha& alpha : {Alpha(Magic{k}), Alpha(Deficient{k})}) {
      if (nearest(alpha) < least) return all;
      all.push_back(alpha);
    }
  }
}

Table terminal_data() {
  Table table{{real_column("alpha"), real_column("a_t"), real_column("b_t"), real_column("c_t")},
              {}};
  const auto add = [&](const Alpha& alpha) {
    const LargeCounts counts = count_collisions(alpha);
    const Row v = rounded([&] { return terminal(alpha, counts); });
    table.rows.push_back({real_cell(nearest(alpha)), v[0], v[1], v[2]});
  };
  constexpr double least = 0.01;
  std::vector<Alpha> alphas = thresholds_above(least);
  constexpr int steps = 400;  // closer where the curves are narrower
  for (int i = 0; i <= steps; ++i)
    alphas.emplace_back(least * std::pow(1.2 / least, double(i) / steps));
  std::sort(alphas.begin(), alphas.end(),
            [](const Alpha& a, const Alpha& b) { return nearest(a) < nearest(b); });
  for (const Alpha& alpha : alphas) add(alpha);
  return table;
}

Table counts_data() {
  Table table{{real_column("alpha"), {"N_A", Type::whole, "1", ""}, {"N_B", Type::whole, "1", ""}},
              {}};
  const auto add = [&](const Alpha& alpha) {
    const LargeCounts counts = count_collisions(alpha);
    const auto cell = [](const cln::cl_I& n) { return whole_cell(kernel::digits(n)); };
    table.rows.push_back({real_cell(nearest(alpha)), cell(counts.N_A), cell(counts.N_B)});
  };
  std::vector<Alpha> thresholds = thresholds_above(0.01);
  std::reverse(thresholds.begin(), thresholds.end());
  add(Alpha(0.01));
  for (const Alpha& alpha : thresholds) add(alpha);
  add(Alpha(2.0));
  return table;
}

}  // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{
      {"counts", "Numbers of collisions N_A and N_B against the mass ratio",
       "Two falling staircases over alpha from 0.01 to 2, on a logarithmic axis: N_A (thin, black) "
       "becomes k at the magic ratio alpha_k, N_B (thick, grey) at the deficient ratio beta_k.",
       counts_data},
      {"terminal", "Terminal velocities against the mass ratio",
       "Three curves over alpha from 0 to 1.2: b_t (solid) reaches V at every magic ratio, where "
       "c_t (dashed) and a_t (dotted) are 0, and falls to c_t at every deficient ratio; a_t is "
       "never positive.",
       terminal_data},
  };
  return all;
}

}  // namespace answers
