// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/figures.hpp"

#include <algorithm>
#include <cmath>

#include "answers/drawings.hpp"
#include "answers/motion.hpp"
#include "kernel/print.hpp"

namespace answers {
namespace {

using notation::Alpha;
using notation::Deficient;
using notation::Magic;

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

/// Up to 1.2 with all thresholds, closer where the curves are narrower.
std::vector<Alpha> alphas() {
  constexpr double least = 0.01;
  constexpr int steps = 400;
  std::vector<Alpha> all = thresholds_above(least);
  for (int i = 0; i <= steps; ++i)
    all.emplace_back(least * std::pow(1.2 / least, double(i) / steps));
  std::sort(all.begin(), all.end(),
            [](const Alpha& a, const Alpha& b) { return nearest(a) < nearest(b); });
  return all;
}

Table terminal_data() {
  Table table{named_columns({"alpha", "a_t", "b_t", "c_t"}), {}};
  for (const Alpha& alpha : alphas()) {
    const LargeCounts counts = count_collisions(alpha);
    const Row v = rounded([&] { return terminal(alpha, counts); });
    table.rows.push_back({real_cell(nearest(alpha)), v[0], v[1], v[2]});
  }
  return table;
}

Table velocities_data() {
  const Alpha alpha = cln::cl_RA(1) / 1000;
  Table table{named_columns({"n", "a", "b", "c", "c_prime"}), {}};
  for (int n = 0; n <= count_collisions(alpha).N_A; ++n) {
    table.rows.push_back(rounded([&] { return velocities(alpha, n); }));
    table.rows.back().insert(table.rows.back().begin(), whole_cell(n));
  }
  return table;
}

Table transmission_data() {
  Table table{named_columns({"alpha", "rho_1", "rho_0.9", "rho_0.8", "rho_0.7"}), {}};
  for (const Alpha& alpha : alphas()) {
    table.rows.push_back({real_cell(nearest(alpha))});
    for (const int tenths : {10, 9, 8, 7})
      table.rows.back().push_back(rho(alpha, cln::cl_RA(tenths) / 10));
  }
  return table;
}

Table counts_data() {
  Table table{named_columns({"alpha", "N_A", "N_B"}), {}};
  std::vector<Alpha> steps = thresholds_above(0.01);
  steps.insert(steps.begin(), 2.0);
  steps.emplace_back(0.01);
  for (auto alpha = steps.rbegin(); alpha != steps.rend(); ++alpha) {
    const LargeCounts counts = count_collisions(*alpha);
    const auto cell = [](const cln::cl_I& n) { return whole_cell(kernel::digits(n)); };
    table.rows.push_back({real_cell(nearest(*alpha)), cell(counts.N_A), cell(counts.N_B)});
  }
  return table;
}

}  // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{{"setup", setup_data},
                                       {"counts", counts_data},
                                       {"trajectories", trajectories_data},
                                       {"terminal", terminal_data},
                                       {"transmission", transmission_data},
                                       {"velocities", velocities_data},
                                       {"sphere", sphere_data},
                                       {"wedge", wedge_data},
                                       {"way", way_data},
                                       {"cradle", cradle_data}};
  return all;
}

}  // namespace answers
