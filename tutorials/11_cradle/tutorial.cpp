// SPDX-License-Identifier: GPL-2.0-or-later
// A cradle with magic balls between its blocks; and what happens without gaps.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "magicmass/accurate.hpp"
#include "magicmass/simulator/line_motion.hpp"
#include "magicmass/simulator/three_body.hpp"

using magicmass::Line;
using magicmass::LineMotion;

// Blocks of mass 1 with balls of these masses between them, all at rest but the
// first block, which comes in with 1. From a ball to the block on its right it is
// L = 1, from a block to the ball on its right it is `gap`.
Line<double> cradle(const std::vector<double>& balls, double gap) {
  Line<double> line;
  double place = 0;
  line.masses = {1};
  line.positions = {-gap};
  line.velocities = {1};
  for (const double ball : balls) {
    line.masses.insert(line.masses.end(), {ball, 1});
    line.positions.insert(line.positions.end(), {place, place + 1});
    line.velocities.insert(line.velocities.end(), {0, 0});
    place += 1 + gap;
  }
  return line;
}

// Energy of the last block after a time that is long for all of them. Who has
// stopped but for a rounding error may still meet somebody, some million years
// later; that is not counted.
double arrived(const std::vector<double>& balls, double gap, std::int64_t& events) {
  LineMotion<double> motion(cradle(balls, gap));
  while (motion.next() && *motion.next() < 1e6) motion.step();
  events = motion.events();
  return std::pow(motion.line().velocities.back(), 2);
}

void print_row(const char* what, const std::vector<double>& balls, double gap) {
  std::int64_t events = 0;
  const double energy = arrived(balls, gap, events);
  std::printf("  %s | %.6f | %lld\n", what, energy, static_cast<long long>(events));
}

// How far B, which started at 1, has moved at the last contact.
double way_of_block(double alpha) {
  return magicmass::record_three_body(alpha).run.last_positions.b - 1;
}

double magic(int k) { return magicmass::accurate::ratios(k).magic; }

int main() {
  std::printf("cradles:\n  four balls | energy of the last block | contacts\n");
  print_row("magic 1, 2, 3, 4", {magic(1), magic(2), magic(3), magic(4)}, 1);
  print_row("magic 4, 2, 9, 6", {magic(4), magic(2), magic(9), magic(6)}, 1);
  print_row("all magic 3", {magic(3), magic(3), magic(3), magic(3)}, 1);
  print_row("all one tenth", {0.1, 0.1, 0.1, 0.1}, 1);
  print_row("all one half", {0.5, 0.5, 0.5, 0.5}, 1);

  // Each ball needs room: as far as its block has moved when its transfer is over.
  const double needed = way_of_block(magic(3));
  std::printf("gap_needed: %.6f\n", needed);
  std::printf("gaps:\n  gap | energy of the last block | contacts\n");
  for (const double gap : {1.0, needed + 0.01, needed - 0.1, 0.5, 0.2, 0.05, 0.01})
    print_row(std::to_string(gap).substr(0, 5).c_str(),
              std::vector<double>(4, magic(3)), gap);

  // Both blocks come to a resting ball at the same moment. Which contact is
  // first? The laws do not say.
  std::printf("at_once:\n  ball | first contact | A | ball afterwards | B\n");
  for (const double alpha : {0.12, 0.5, 1.0}) {
    for (const char first : {'A', 'B'}) {
      const double early = first == 'A' ? 1e-9 : -1e-9;
      LineMotion<double> motion(
          Line<double>{.masses = {1, alpha, 1},
                       .positions = {-1 + early, 0, 1 + early},
                       .velocities = {1, 0, -1},
                       .left_wall = {},
                       .right_wall = {},
                       .restitution = 1});
      while (motion.next()) motion.step();
      const auto& v = motion.line().velocities;
      std::printf("  %g | %c | %.4f | %.4f | %.4f\n", alpha, first, v[0], v[1],
                  v[2]);
    }
  }
}
