// SPDX-License-Identifier: GPL-2.0-or-later
// A ball between a block and a wall: counting collisions, and finding the digits
// of pi among the counts.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include "magicmass/reference/exact_line.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/trio_end.hpp"
#include "magicmass/simulator/contact.hpp"
#include "magicmass/simulator/line_motion.hpp"

using magicmass::Line;
using magicmass::LineMotion;

// Velocities alone: the block comes in with 1, the ball rests, and the wall is to
// the right of the ball.
template <class Number>
std::int64_t collisions(const Number& block_over_ball, std::int64_t most) {
  Number block(1), ball(0);
  const Number resting(0), whole(1);
  std::int64_t count = 0;
  while (count < most) {
    if (ball < block) {
      const auto after =
          magicmass::collide<Number>(block_over_ball, block, whole, ball);
      block = after.first;
      ball = after.second;
    } else if (resting < ball) {
      ball = magicmass::rebound<Number>(ball, whole);
    } else {
      break;
    }
    ++count;
  }
  return count;
}

// The same without stepping. One cycle is a matrix, two cycles its square, four the
// square of that; so the last contact is found by doubling and halving, in exact
// arithmetic. There is no pi in here, and no arctangent.
std::string counted_by_squaring(int k) {
  const std::string scene = "kind = \"wall\"\nmass_ratio = \"100^" +
                            std::to_string(k) + "\"\noutputs = [\"counts\"]\n";
  const auto line =
      magicmass::reference::exact_line(magicmass::parse_scene(scene, "a wall"));
  const magicmass::reference::TrioEnd end(line);
  return magicmass::reference::to_text(end.contacts());
}

int main() {
  std::printf("block_and_wall:\n  mass of the block | simulated | by squaring\n");
  std::int64_t mass = 1;
  for (int k = 0; k <= 5; ++k, mass *= 100)
    std::printf("  %lld | %lld | %s\n", static_cast<long long>(mass),
                static_cast<long long>(
                    collisions<double>(static_cast<double>(mass), 10'000'000)),
                counted_by_squaring(k).c_str());

  std::printf("many_digits: %s\n", counted_by_squaring(50).c_str());
  const double seconds_in_a_year = 3.15e7;
  std::printf("years: %.1g\n", std::pow(10.0, 50) / 1e9 / seconds_in_a_year);

  // The block's way: it turns round near the wall and leaves with nearly the
  // speed it had.
  std::printf("way:\n  contact with the block | time | place of the block\n");
  LineMotion<double> motion(Line<double>{.masses = {100, 1},
                                         .positions = {0, 0},
                                         .velocities = {1, 0},
                                         .left_wall = {},
                                         .right_wall = 1.0,
                                         .restitution = 1});
  for (int contact = 0; motion.next();) {
    const auto event = motion.step();
    if (event.gap == 1)
      std::printf("  %d | %.4f | %.4f\n", ++contact, event.time, event.position);
  }
}
