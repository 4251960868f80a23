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
  const auto add = [&](const Alpha& alpha) {
    const LargeCounts counts = count_collisions(alpha);
    const Row v = rounded([&] { return terminal(alpha, counts); });
    table.rows.push_back({real_cell(nearest(alpha)), v[0], v[1], v[2]});
  };
  for (const Alpha& alpha : alphas()) add(alpha);
  return table;
}

Table transmission_data() {
  Table table{named_columns({"alpha", "rho_1", "rho_0.9", "rho_0.8", "rho_0.7"}), {}};
  const std::vector<cln::cl_RA> restitutions{cln::cl_RA(9) / 10, cln::cl_RA(8) / 10,
                                             cln::cl_RA(7) / 10};
  for (const Alpha& alpha : alphas()) {
    const LargeCounts counts = count_collisions(alpha);
    Row row{real_cell(nearest(alpha)),
            rounded([&] { return Balls{terminal(alpha, counts)[3]}; })[0]};
    for (const cln::cl_RA& e : restitutions) {
      const Trio trio = with_restitution(alpha, e);
      const auto N = trio.count();
      row.push_back(N ? rounded([&] { return Balls{terminal(trio, *N)[3]}; })[0] : missing_cell());
    }
    table.rows.push_back(row);
  }
  return table;
}

Table counts_data() {
  Table table{named_columns({"alpha", "N_A", "N_B"}), {}};
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
      {"setup", "The initial state of the three bodies",
       "Three bodies on a line: block A of mass M at the left moves to the right with velocity V, "
       "the ball C of mass m = alpha M rests at x = 0, block B of mass M rests at x = L.",
       setup_data},
      {"counts", "Numbers of collisions N_A and N_B against the mass ratio",
       "Two falling staircases over alpha from 0.01 to 2, on a logarithmic axis: N_A (thin, black) "
       "becomes k at the magic ratio alpha_k, N_B (thick, grey) at the deficient ratio beta_k.",
       counts_data},
      {"trajectories", "Trajectories of A, B and C",
       "Three panels, place over time: A from below and B above (solid), C between them (dashed). "
       "(a) At the magic ratio alpha_3 A and C stop and B leaves with all. (b) At alpha = 0.12 all "
       "go on moving after three collisions each. (c) At alpha = 0.10 A meets C a fourth time.",
       trajectories_data},
      {"terminal", "Terminal velocities against the mass ratio",
       "Three curves over alpha from 0 to 1.2: b_t (solid) reaches V at every magic ratio, where "
       "c_t (dashed) and a_t (dotted) are 0, and falls to c_t at every deficient ratio; a_t is "
       "never positive.",
       terminal_data},
      {"transmission", "Energy transmission rho against the mass ratio",
       "Four curves over alpha from 0 to 1.2, lower for lower restitution: e = 1 (solid) has its "
       "maxima 1 at the magic ratios; e = 0.9 (dashed), 0.8 (dash-dotted) and 0.7 (dotted) have "
       "theirs further to the right but for the one at alpha = 1. Where collisions never end there "
       "is no curve.",
       transmission_data},
      {"sphere", "V_n turning about its axis on the unit sphere",
       "A sphere with the axes a, b and sqrt(alpha) c'. At the magic ratio alpha_5 the tips of V_0 "
       "to V_5 (dots) lie on one circle about an axis (arrow), each a turn by psi from the one "
       "before: from the tip of a, where A has everything, to that of b, where B has.",
       sphere_data},
      {"wedge", "The collisions as a straight line through the unfolded wedge",
       "A fan of rays from one point, each turned by psi/2 from the one before: mirror images of "
       "the wedge (grey) of all places. Solid rays are collisions of A and C, dashed ones of C and "
       "B; the distance from the tip is that of A and B. At alpha_3 the six collisions P_1, Q_1 to "
       "Q_3 (dots) lie on one straight line.",
       wedge_data},
      {"cradle", "The generalised Newton's cradle in space and time",
       "Places over time of five equal blocks (solid) and four balls between them (dashed), of "
       "mass ratios alpha_1 to alpha_4, before a wall at the top. The k-th ball bounces k times "
       "between its blocks, then rests, and the next block has the whole momentum; the fifth block "
       "meets the wall and all happens again the other way round.",
       cradle_data},
  };
  return all;
}

}  // namespace answers
