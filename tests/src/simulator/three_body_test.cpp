// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/simulator/three_body.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/simulator/velocity_stepping.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

TEST_CASE("a ball three times as heavy as the blocks, times and places by hand", "[exam]") {
  // After P_1 the ball moves with 1/2 and reaches B at L = 1 at time 2, when A is at -1.
  const auto [run, events] = record_three_body(3.0);
  REQUIRE(events.size() == 2);
  CHECK(events[0].body == Body::A);
  CHECK(events[0].time == 0.0);
  CHECK(events[0].position == 0.0);
  CHECK(events[0].positions == BodyPositions<double>{0.0, 1.0, 0.0});
  CHECK(events[1].body == Body::B);
  CHECK(events[1].time == 2.0);
  CHECK(events[1].position == 1.0);
  CHECK(events[1].after == BodyVelocities<double>{-0.5, 0.75, 0.25});
  CHECK(events[1].positions == BodyPositions<double>{-1.0, 1.0, 1.0});
  CHECK(run.status == RunStatus::complete);
  CHECK(run.counts == Counts{1, 1});
  CHECK(run.last_time == 2.0);
  CHECK(run.last_positions == events[1].positions);
  CHECK(run.drift.energy == 0.0);
  CHECK(run.drift.momentum == 0.0);
}

TEST_CASE("bodies stay in order and in time, and meet where they are", "[check]") {
  testing::Generator generator(3);
  for (int i = 0; i < 500; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-4, 1e4);
    const auto [run, events] = record_three_body(alpha);
    REQUIRE(run.counts == step_velocities(alpha).counts);
    for (std::size_t j = 0; j < events.size(); ++j) {
      REQUIRE(events[j].body == (j % 2 == 0 ? Body::A : Body::B));
      REQUIRE(events[j].n == static_cast<std::int64_t>(j / 2 + 1));
      REQUIRE((j == 0 || events[j - 1].time < events[j].time));
      const BodyPositions<double>& x = events[j].positions;
      REQUIRE((x.a <= x.c && x.c <= x.b));
      REQUIRE((events[j].body == Body::A ? x.a : x.b) == x.c);
      REQUIRE(events[j].position == x.c);
    }
    // an error of a few eps a contact adds up
    const double bound =
        16.0 * static_cast<double>(events.size()) * std::numeric_limits<double>::epsilon();
    REQUIRE(run.drift.energy <= bound);
    REQUIRE(run.drift.momentum <= bound);
  }
}

TEST_CASE("V and L only scale a scene", "[exam]") {
  const auto unit = record_three_body(0.1);
  const auto other = record_three_body(0.1, 4.0, 0.5);
  REQUIRE(unit.events.size() == other.events.size());
  for (std::size_t j = 0; j < unit.events.size(); ++j) {
    CHECK(other.events[j].time == unit.events[j].time / 8.0);
    CHECK(other.events[j].position == unit.events[j].position / 2.0);
    CHECK(other.events[j].after.c == unit.events[j].after.c * 4.0);
  }
}

TEST_CASE("float, double and long double see the paper's trajectories", "[exam]") {
  CHECK(record_three_body(0.12F).run.counts == Counts{3, 3});
  CHECK(record_three_body(0.12).run.counts == Counts{3, 3});
  CHECK(record_three_body(0.12L).run.counts == Counts{3, 3});
  CHECK(record_three_body(0.10F).run.counts == Counts{4, 3});
  CHECK(record_three_body(0.10).run.counts == Counts{4, 3});
  CHECK(record_three_body(0.10L).run.counts == Counts{4, 3});
}

TEST_CASE("the largest number of events stops a run", "[exam]") {
  const auto stopped = record_three_body(0.1, 1.0, 1.0, 3);
  CHECK(stopped.run.status == RunStatus::limited);
  CHECK(stopped.events.size() == 3);
  CHECK(stopped.run.counts == Counts{2, 1});
  CHECK(record_three_body(0.1, 1.0, 1.0, 7).run.status == RunStatus::complete);
}

TEST_CASE("scenes that mean nothing or do not fit are refused", "[exam]") {
  CHECK_THROWS_WITH(record_three_body(0.0), "alpha must be a positive finite number, got 0");
  CHECK_THROWS_WITH(record_three_body(0.1, 0.0), "V must be a positive finite number, got 0");
  CHECK_THROWS_WITH(record_three_body(0.1, 1.0, -1.0),
                    "L must be a positive finite number, got -1");
  CHECK_THROWS_AS(record_three_body(0.1, 1e-300, 1e300), Undecided);
  CHECK_THROWS_AS(record_three_body(0.1, 1.5e308, 1e300), Undecided);
  const double heaviest = std::numeric_limits<double>::max();
  CHECK(record_three_body(heaviest).run.counts == Counts{1, 1});
  CHECK_THROWS_AS(record_three_body(heaviest, 1.0, 4.0), Undecided);  // Q_1 at 4 / 1.1e-308
  CHECK_THROWS_AS(record_three_body(heaviest, 1e6, 1e6), Undecided);  // in time, but A is far
}
