// SPDX-License-Identifier: GPL-2.0-or-later
// The motion step by step: known events, and what floating point cannot tell.
#include "magicmass/simulator/three_bodies.hpp"

#include <cln/rational.h>

#include "catch.hpp"

using namespace magicmass::simulator;
using cln::cl_RA;

TEST_CASE("equal masses hand the velocity on", "[exam]") {
  ThreeBodies<cl_RA> motion(1);
  const auto first = motion.step();
  REQUIRE(first);
  CHECK((first->gap == 1 && first->time == 0 && first->position == 0));
  const auto second = motion.step();
  REQUIRE(second);
  CHECK((second->gap == 2 && second->time == 1 && second->position == 1));
  CHECK_FALSE(motion.step());
  CHECK(motion.bodies()[2].velocity == 1);
}

TEST_CASE("alpha = 1/3: first collisions by hand", "[exam]") {
  ThreeBodies<cl_RA> motion(cl_RA(1) / 3);
  motion.step();
  CHECK(motion.bodies()[0].velocity == cl_RA(1) / 2);
  CHECK(motion.bodies()[1].velocity == cl_RA(3) / 2);
  const auto event = motion.step();
  REQUIRE(event);
  CHECK(event->time == cl_RA(2) / 3);
  CHECK(motion.bodies()[0].position == cl_RA(1) / 3);
  CHECK(motion.bodies()[1].velocity == cl_RA(-3) / 4);
  CHECK(motion.bodies()[2].velocity == cl_RA(3) / 4);
}

TEST_CASE("near ties are told at thresholds and not away from them", "[exam]") {
  const double magic_2 = 0.2360679774997897;  // sqrt(5) - 2, where one collision too many is seen
  for (const auto& [alpha, expected, near] : {std::tuple{1.0, 2, 0},
                                              {0.1, 7, 0},
                                              {0.24, 4, 0},
                                              {magic_2, 5, 2},
                                              {magic_2 + 2e-15, 4, 1},
                                              {magic_2 + 4e-15, 4, 0}}) {
    INFO(alpha);
    ThreeBodies<double> motion(alpha);
    int collisions = 0;
    while (motion.step()) ++collisions;
    CHECK(collisions == expected);
    CHECK(motion.near_ties() == near);
  }
}

TEST_CASE("equal masses swap velocities without rounding", "[exam]") {
  Body<double> first{3, 0, 0.1};
  Body<double> second{3, 0, 0.3};
  collide(first, second);
  CHECK((first.velocity == 0.3 && second.velocity == 0.1));
}
