// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/simulator/trio_stepping.hpp"

#include <chrono>
#include <cstdint>
#include <iostream>

#include <catch2/catch.hpp>

#include "magicmass/simulator/line_motion.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

constexpr std::int64_t no_limit = std::int64_t{1} << 60U;

template <class Run>
double millions_a_second(const Run& run) {
  const auto start = std::chrono::steady_clock::now();
  const auto events = static_cast<double>(run());
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  return events / passed.count() * 1e-6;
}

Line<double> long_chain(std::size_t blocks) {
  testing::Generator generator(7);
  Line<double> line;
  for (std::size_t i = 0; i + 1 < 2 * blocks; ++i) {
    line.masses.push_back(i % 2 == 0 ? 1.0 : 0.3);
    line.positions.push_back(static_cast<double>(i) + testing::log_uniform(generator, 0.1, 0.9));
    line.velocities.push_back(testing::log_uniform(generator, 0.1, 1.0) *
                              (generator() % 2 == 0 ? 1.0 : -1.0));
  }
  line.left_wall = -1.0;
  line.right_wall = static_cast<double>(2 * blocks);
  return line;
}

}  // namespace

TEST_CASE("stepping by weights is stepping by the law", "[check]") {
  testing::Generator generator(71);
  for (int i = 0; i < 500; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-3, 1e3);
    const Trio<double> trio{contact_weights(1.0, alpha, 1.0), contact_weights(1.0, alpha, 1.0)};
    const auto recorded = record_three_body(alpha);
    Velocities<double> alone{1.0, 0.0, 0.0};
    CHECK(step_trio(trio, alone, no_limit) == static_cast<std::int64_t>(recorded.events.size()));
    Velocities<double> v{1.0, 0.0, 0.0};
    TrioPlace<double> place{0.0, 0.0, 1.0};
    const auto contacts =
        step_trio(trio, v, place, no_limit, [&](std::int64_t n, const auto& at, const auto& after) {
          const auto& event = recorded.events[static_cast<std::size_t>(n - 1)];
          REQUIRE(at.time == Approx(event.time).epsilon(1e-10).margin(1e-12));
          REQUIRE(at.ball == Approx(event.position).epsilon(1e-10).margin(1e-12));
          REQUIRE(after.b == Approx(event.after.b).margin(1e-10));
        });
    CHECK(contacts == static_cast<std::int64_t>(recorded.events.size()));
  }
}

TEST_CASE("a block and a wall count digits of pi, event by event", "[exam]") {
  std::int64_t expected[] = {3, 31, 314, 3141, 31415, 314159, 3141592};
  double ratio = 1.0;
  for (const std::int64_t digits : expected) {
    const Trio<double> trio{contact_weights(ratio, 1.0, 1.0), wall_weights(1.0)};
    Velocities<double> v{1.0, 0.0, 0.0};
    CHECK(step_trio(trio, v, no_limit) == digits);
    ratio *= 100.0;
  }
}

TEST_CASE("a limit stops stepping where it is", "[exam]") {
  const Trio<double> trio{contact_weights(1e6, 1.0, 1.0), wall_weights(1.0)};
  Velocities<double> v{1.0, 0.0, 0.0};
  CHECK(step_trio(trio, v, 101) == 101);
  CHECK(v.c > 0.0);  // after P
}

TEST_CASE("how fast events are stepped", "[time]") {
  const double light = 1e-18;
  const Trio<double> trio{contact_weights(1.0, light, 1.0), contact_weights(1.0, light, 1.0)};
  Velocities<double> v{1.0, 0.0, 0.0};
  std::cout << "three bodies, velocities only: " << millions_a_second([&] {
    return step_trio(trio, v, 300'000'000);
  }) << " M events/s (wanted: 200)\n";
  v = {1.0, 0.0, 0.0};
  TrioPlace<double> place{0.0, 0.0, 1.0};
  double sum = 0.0;
  std::cout << "with times and places: " << millions_a_second([&] {
    return step_trio(trio, v, place, 100'000'000,
                     [&](auto, const auto& at, const auto&) { sum += at.time; });
  }) << " M events/s (wanted: 50; sum of times "
            << sum << ")\n";
  double fastest = 0.0;
  double slowest = 0.0;
  for (const std::size_t blocks : {1000U, 10000U, 100000U}) {
    LineMotion<double> motion(long_chain(blocks));
    slowest = millions_a_second([&] {
      for (int i = 0; i < 3'000'000; ++i) motion.step();
      return motion.events();
    });
    if (blocks == 1000) fastest = slowest;
    std::cout << "chain of " << blocks << " blocks: " << slowest << " M events/s\n";
  }
  // time an event ~ (log bodies)^p between 2 * 10^3 and 2 * 10^5 bodies
  std::cout << "time an event grows as log(bodies) to the power "
            << std::log(fastest / slowest) / std::log(std::log(2e5) / std::log(2e3)) << "\n";
}
