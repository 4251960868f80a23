// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/simulator/velocity_stepping.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"

using namespace magicmass;

TEST_CASE("equal masses hand everything on", "[exam]") {
  const auto run = step_velocities(1.0);
  CHECK(run.status == RunStatus::complete);
  CHECK(run.counts == Counts{1, 1});
  CHECK(run.terminal == BodyVelocities<double>{0.0, 1.0, 0.0});
}

TEST_CASE("a ball three times as heavy as the blocks, by hand", "[exam]") {
  // P_1: centre of mass velocity 1/4, A 1 -> -1/2, C 0 -> 1/2. Q_1: 3/8, C 1/2 -> 1/4, B 0 -> 3/4.
  std::vector<VelocityEvent<double>> events;
  const auto run =
      step_velocities(3.0, 1.0, 100, [&](const VelocityEvent<double>& e) { events.push_back(e); });
  CHECK(run.counts == Counts{1, 1});
  REQUIRE(events.size() == 2);
  CHECK(events[0].body == Body::A);
  CHECK(events[0].n == 1);
  CHECK(events[0].after == BodyVelocities<double>{-0.5, 0.0, 0.5});
  CHECK(events[1].body == Body::B);
  CHECK(events[1].n == 1);
  CHECK(events[1].after == BodyVelocities<double>{-0.5, 0.75, 0.25});
}

TEST_CASE("the paper's counts at 0.12 and 0.10, in every floating-point type", "[exam]") {
  CHECK(step_velocities(0.12).counts == Counts{3, 3});
  CHECK(step_velocities(0.10).counts == Counts{4, 3});
  CHECK(step_velocities(0.12F).counts == Counts{3, 3});
  CHECK(step_velocities(0.10F).counts == Counts{4, 3});
  CHECK(step_velocities(0.12L).counts == Counts{3, 3});
  CHECK(step_velocities(0.10L).counts == Counts{4, 3});
}

TEST_CASE("the largest number of collisions stops a run, and only then is it limited", "[exam]") {
  CHECK(step_velocities(0.10, 1.0, 6).status == RunStatus::limited);
  CHECK(step_velocities(0.10, 1.0, 6).counts == Counts{3, 3});
  CHECK(step_velocities(0.10, 1.0, 7).status == RunStatus::complete);
  CHECK(step_velocities(0.10, 1.0, 0).counts == Counts{0, 0});
  CHECK(step_velocities(0.10, 1.0, 0).terminal == BodyVelocities<double>{1.0, 0.0, 0.0});
}

TEST_CASE("speed only scales, down to the smallest double", "[exam]") {
  CHECK(step_velocities(0.10, 4.0).terminal.b == 4.0 * step_velocities(0.10).terminal.b);
  CHECK(step_velocities(0.10, std::numeric_limits<double>::denorm_min()).counts == Counts{4, 3});
}

TEST_CASE("masses and speeds that mean nothing are refused", "[exam]") {
  CHECK_THROWS_WITH(step_velocities(-0.1), "alpha must be a positive finite number, got -0.1");
  CHECK_THROWS_AS(step_velocities(0.0), InvalidInput);
  CHECK_THROWS_AS(step_velocities(std::numeric_limits<double>::quiet_NaN()), InvalidInput);
  CHECK_THROWS_AS(step_velocities(std::numeric_limits<double>::infinity()), InvalidInput);
  CHECK_THROWS_WITH(step_velocities(0.1, -2.0), "V must be a positive finite number, got -2");
}
