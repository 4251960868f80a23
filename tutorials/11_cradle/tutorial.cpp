// A cradle with magic balls between its blocks; and what happens without gaps.
#include <cstdio>
#include <string>
#include <vector>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/simulator/three_bodies.hpp"

using magicmass::simulator::Engine;
using Balls = std::vector<double>;

double magic(int k) { return magicmass::accurate::ratios(k).magic; }

// Blocks of mass 1 with these balls between them, all at rest but the first block, which comes in
// with 1. It is 1 from a ball to the block on its right, `gap` from a block to the next ball.
// Bodies that rounding left with a tiny velocity may meet much later: that is not counted.
void print_row(const std::string& what, const Balls& balls, double gap) {
  magicmass::simulator::Line<double> line{{1}, {-gap}, {1}, {}, {}};
  double place = 0;
  for (const double ball : balls) {
    line.masses.insert(line.masses.end(), {ball, 1});
    line.positions.insert(line.positions.end(), {place, place + 1});
    line.velocities.insert(line.velocities.end(), {0, 0});
    place += 1 + gap;
  }
  Engine<double> motion(line);
  int collisions = 0;
  for (; motion.next() && *motion.next() < 1e6; motion.step()) ++collisions;
  const double last = motion.bodies().back().velocity;
  std::printf("  %s | %.6f | %d\n", what.c_str(), last * last, collisions);
}

int main() {
  std::printf("grams: %.0f\nfewer_grams: %.0f\n", 1000 * magic(3), 1000 * magic(9));
  std::printf("cradles:\n  four balls | energy of the last block | collisions\n");
  print_row("magic 1, 2, 3, 4", {magic(1), magic(2), magic(3), magic(4)}, 1);
  print_row("magic 4, 2, 9, 6", {magic(4), magic(2), magic(9), magic(6)}, 1);
  print_row("all magic 3", Balls(4, magic(3)), 1);
  print_row("all one tenth", Balls(4, 0.1), 1);
  print_row("all one half", Balls(4, 0.5), 1);

  // Each ball needs room: B, which started at 1, has moved when its transfer is over.
  magicmass::simulator::ThreeBodies<double> transfer(magic(3));
  while (transfer.step()) continue;
  const double needed = transfer.bodies()[2].position - 1;
  std::printf("room: %.6f\ngaps:\n  gap | energy of the last block | collisions\n", needed);
  for (const double gap : {1.0, needed + 0.01, needed - 0.1, 0.5, 0.2, 0.05, 0.01})
    print_row(std::to_string(gap).substr(0, 5), Balls(4, magic(3)), gap);

  // Both blocks come to a resting ball at the same moment. Which one is first? The laws do not say.
  std::printf("at_once:\n  ball | first collision | A | ball afterwards | B\n");
  for (const double alpha : {0.12, 0.5, 1.0})
    for (const double early : {1e-9, -1e-9}) {
      Engine<double> motion({{1, alpha, 1}, {early - 1, 0, early + 1}, {1, 0, -1}, {}, {}});
      while (motion.next()) motion.step();
      const auto v = motion.bodies();
      std::printf("  %g | %c | %.4f | %.4f | %.4f\n", alpha, early > 0 ? 'A' : 'B', v[0].velocity,
                  v[1].velocity, v[2].velocity);
    }
}
