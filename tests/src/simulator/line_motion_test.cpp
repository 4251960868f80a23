// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/simulator/line_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/simulator/line_audit.hpp"
#include "magicmass/simulator/stalled_clock.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

template <class Scalar>
std::vector<LineEvent<Scalar>> all_events(LineMotion<Scalar>& motion, std::int64_t most = 100000) {
  std::vector<LineEvent<Scalar>> events;
  while (motion.next() && motion.events() < most) events.push_back(motion.step());
  return events;
}

Line<double> random_line(testing::Generator& generator, std::size_t bodies) {
  Line<double> line;
  for (std::size_t i = 0; i < bodies; ++i) {
    line.masses.push_back(testing::log_uniform(generator, 0.1, 10.0));
    line.positions.push_back(static_cast<double>(i) + testing::log_uniform(generator, 0.1, 0.9));
    line.velocities.push_back(testing::log_uniform(generator, 0.1, 10.0) *
                              (generator() % 2 == 0 ? 1.0 : -1.0));
  }
  return line;
}

/// The engine without its queue: every gap is looked at before each contact, every body moved.
std::vector<LineEvent<double>> by_brute_force(Line<double> line, std::int64_t most) {
  std::vector<LineEvent<double>> events;
  double now = 0.0;
  while (static_cast<std::int64_t>(events.size()) < most) {
    std::size_t gap = line.bodies();
    double least = HUGE_VAL;
    for (std::size_t g = 1; g < line.bodies(); ++g) {
      const double closing = line.velocities[g - 1] - line.velocities[g];
      const double wait = (line.positions[g] - line.positions[g - 1]) / closing;
      if (closing > 0.0 && wait < least) {
        least = std::max(wait, 0.0);
        gap = g;
      }
    }
    if (gap == line.bodies()) break;
    now += least;
    for (std::size_t i = 0; i < line.bodies(); ++i) line.positions[i] += least * line.velocities[i];
    line.positions[gap] = line.positions[gap - 1];
    const auto after = collide(line.masses[gap - 1], line.velocities[gap - 1], line.masses[gap],
                               line.velocities[gap]);
    line.velocities[gap - 1] = after.first;
    line.velocities[gap] = after.second;
    events.push_back({static_cast<std::int64_t>(events.size()) + 1, gap, now, line.positions[gap],
                      after.first, after.second});
  }
  return events;
}

}  // namespace

TEST_CASE("A and B take turns, though the engine does not assume it", "[check]") {
  testing::Generator generator(61);
  for (int i = 0; i < 200; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-3, 1e3);
    const auto recorded = record_three_body(alpha);
    LineMotion<double> motion({{1.0, alpha, 1.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {}, {}});
    const auto events = all_events(motion);
    REQUIRE(events.size() == recorded.events.size());
    for (std::size_t j = 0; j < events.size(); ++j) {
      REQUIRE((events[j].gap == 1) == (recorded.events[j].body == Body::A));
      REQUIRE(events[j].time == Approx(recorded.events[j].time).epsilon(1e-9).margin(1e-12));
    }
  }
}

TEST_CASE("the queue finds the events that looking everywhere finds", "[check]") {
  testing::Generator generator(62);
  for (const std::size_t bodies : std::array<std::size_t, 10>{1, 2, 3, 4, 5, 7, 8, 9, 20, 33}) {
    const Line<double> line = random_line(generator, bodies);
    LineMotion<double> motion(line);
    const auto events = all_events(motion, 500);
    const auto expected = by_brute_force(line, 500);
    REQUIRE(events.size() == expected.size());
    for (std::size_t j = 0; j < events.size(); ++j) {
      REQUIRE(events[j].gap == expected[j].gap);
      REQUIRE(events[j].time == Approx(expected[j].time).epsilon(1e-9));
      REQUIRE(events[j].position == Approx(expected[j].position).epsilon(1e-9).margin(1e-9));
      REQUIRE((j == 0 || events[j - 1].time <= events[j].time));
    }
  }
}

TEST_CASE("of contacts at one time the leftmost goes first", "[exam]") {
  // Three equal pairs that meet at time 1, far from each other.
  LineMotion<double> motion({{1, 1, 1, 1, 1, 1},
                             {0, 2, 10, 12, 20, 22},
                             {1, -1, 1, -1, 1, -1},
                             std::nullopt,
                             std::nullopt});
  const auto events = all_events(motion);
  REQUIRE(events.size() >= 3);
  CHECK(events[0].gap == 1);
  CHECK(events[1].gap == 3);
  CHECK(events[2].gap == 5);
  CHECK(motion.ties().near == 0);  // no body is in two of them
}

TEST_CASE("three bodies at one place at once are a near tie in doubles", "[exam]") {
  LineMotion<double> motion({{1.0, 0.3, 2.0}, {-1.0, 0.0, 1.0}, {1.0, 0.0, -1.0}, {}, {}});
  all_events(motion);
  CHECK(motion.ties().near > 0);
  LineMotion<double> apart({{1.0, 0.3, 2.0}, {-1.0, 0.0, 1.001}, {1.0, 0.0, -1.0}, {}, {}});
  all_events(apart);
  CHECK(apart.ties().near == 0);
}

TEST_CASE("equal masses swap velocities without rounding, in any number type", "[exam]") {
  Line<double> line{{}, {}, {}, -1.0, 20.0};
  for (int i = 0; i < 20; ++i) {
    line.masses.push_back(0.1);
    line.positions.push_back(i);
    line.velocities.push_back(i == 0 ? 0.3 : 0.0);
  }
  LineMotion<double> motion(line);
  for (int i = 0; i < 4200; ++i) motion.step();
  const std::vector<double> velocities = motion.line().velocities;
  CHECK(std::count(velocities.begin(), velocities.end(), 0.0) == 19);
  CHECK(motion.ties().near == 0);
  LineMotion<long double> wide(
      {{1.0L, 0.1L, 1.0L}, {0.0L, 0.0L, 1.0L}, {1.0L, 0.0L, 0.0L}, {}, {}});
  CHECK(all_events(wide).size() == 7);
}

TEST_CASE("energy and momentum are watched, walls included", "[check]") {
  testing::Generator generator(63);
  Line<double> line = random_line(generator, 30);
  line.left_wall = -1.0;
  line.right_wall = 31.0;
  LineAudit<double> audit(line);
  LineMotion<double> motion(line);
  for (int i = 0; i < 20000; ++i) {
    const auto event = motion.step();
    audit.look(motion, event);
  }
  audit.look(motion.line());
  CHECK(audit.largest().energy < 20000 * 16 * 0x1p-52);
  CHECK(audit.largest().momentum < 20000 * 16 * 0x1p-52);
  Line<double> wrong = motion.line();  // and it can fail
  wrong.velocities[3] *= 1.001;
  audit.look(wrong);
  CHECK(audit.largest().energy > 1e-7);
  CHECK(audit.largest().momentum > 1e-7);
}

TEST_CASE("less energy is a departure where contacts are elastic, more is one everywhere",
          "[exam]") {
  const auto departure = [](double e, double speed) {
    Line<double> line{{1.0, 1.0}, {0.0, 1.0}, {1.0, -1.0}, std::nullopt, std::nullopt, e};
    LineAudit<double> audit(line);
    line.velocities = {-speed, speed};
    audit.look(line);
    return audit.largest().energy;
  };
  CHECK(departure(1.0, 0.5) == 0.75);
  CHECK(departure(0.5, 0.5) == 0.0);
  CHECK(departure(1.0, 2.0) == 3.0);
  CHECK(departure(0.5, 2.0) == 3.0);
}

TEST_CASE("a collapse in a chain makes the clock stand still, and nothing else does", "[exam]") {
  const auto stalls = [](double e) {
    LineMotion<double> motion(
        {{1, 1, 1, 1, 1}, {0, 1, 2, 3, 4}, {5, 1, 0, -1, -4}, std::nullopt, std::nullopt, e});
    StalledClock<double> clock;
    while (motion.next() && motion.events() < 200000) {
      motion.step();
      if (clock.look(motion.events(), motion.now())) return true;
    }
    return false;
  };
  CHECK(stalls(0.02));
  CHECK_FALSE(stalls(0.9));
}

TEST_CASE("what cools until doubles do not hold it is known to be lost", "[exam]") {
  for (const double e : {0.01, 0.1, 0.3, 0.5, 0.6, 0.9}) {
    LineMotion<double> box({{1.0, 0.3, 1.0}, {0.0, 1.0, 2.0}, {1.0, 0.0, 0.0}, -1.0, 3.0, e});
    all_events(box, 200000);
    CHECK((box.next() || box.losses().time || box.losses().rebound));
    LineMotion<double> alone({{1.0}, {0.0}, {1.0}, -1.0, 3.0, e});
    all_events(alone, 200000);
    CHECK((alone.next() || alone.losses().time || alone.losses().rebound));
  }
  LineMotion<double> ends({{1.0, 0.3, 1.0}, {0.0, 1.0, 2.0}, {1.0, 0.0, 0.0}, {}, {}, 0.9});
  all_events(ends);
  CHECK_FALSE(ends.next().has_value());
  CHECK_FALSE(ends.losses().time);
  CHECK_FALSE(ends.losses().rebound);
}

TEST_CASE("hostile lines end or go on, in order and without a time that is no number", "[check]") {
  testing::Generator generator(64);
  const double extremes[] = {5e-324, 1e-308, 1e-200, 1e-17, 0.5, 1.0, 3.0, 1e17, 1e200, 1.7e308};
  const auto any = [&] { return extremes[generator() % std::size(extremes)]; };
  for (int i = 0; i < 500; ++i) {
    Line<double> line;
    const std::size_t bodies = 1 + generator() % 9;
    for (std::size_t b = 0; b < bodies; ++b) {
      line.masses.push_back(any());
      line.velocities.push_back(generator() % 3 == 0 ? 0.0 : generator() % 2 == 0 ? any() : -any());
      line.positions.push_back(generator() % 2 == 0 ? any() : -any());
    }
    std::sort(line.positions.begin(), line.positions.end());
    if (generator() % 2 == 0) line.left_wall = line.positions.front();
    if (generator() % 2 == 0) line.right_wall = line.positions.back();
    if (generator() % 2 == 0) line.restitution = std::min(any(), 1.0);
    LineMotion<double> motion(line);
    double before = 0.0;
    while (motion.next() && motion.events() < 2000) {
      const LineEvent<double> event = motion.step();
      REQUIRE(event.time >= before);  // never, and not a number, are no times
      REQUIRE(event.time < HUGE_VAL);
      before = event.time;
    }
  }
}
