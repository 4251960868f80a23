// SPDX-License-Identifier: GPL-2.0-or-later
// A ball between a block and a wall: counting collisions, and finding the digits
// of pi among the counts.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include <cln/integer.h>
#include <cln/real.h>

#include "magicmass/reference/rational.hpp"
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

// ceil(pi/atan(10^-k)) - 1 with so many digits that the integer is certain
// (theorem special_cases.digits_of_pi).
std::string counted_by_formula(int k) {
  const cln::float_format_t digits =
      cln::float_format(static_cast<std::uintptr_t>(2 * k + 30));
  const cln::cl_R small = cln::cl_float(1 / cln::expt(cln::cl_I(10), k), digits);
  const cln::cl_I count = cln::ceiling1(cln::pi(digits) / cln::atan(small)) - 1;
  return magicmass::reference::to_text(count);
}

int main() {
  std::printf("block_and_wall:\n  mass of the block | simulated | by formula\n");
  std::int64_t mass = 1;
  for (int k = 0; k <= 5; ++k, mass *= 100)
    std::printf("  %lld | %lld | %s\n", static_cast<long long>(mass),
                static_cast<long long>(
                    collisions<double>(static_cast<double>(mass), 10'000'000)),
                counted_by_formula(k).c_str());

  std::printf("many_digits: %s\n", counted_by_formula(50).c_str());
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
