// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/simulator/trio_stepping.hpp"

#include <cstdint>

#include <catch2/catch.hpp>

#include "magicmass/simulator/three_body.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

constexpr std::int64_t no_limit = std::int64_t{1} << 60U;

}  // namespace

TEST_CASE("stepping by weights is stepping by the law", "[check]") {
  testing::Generator generator(71);
  for (int i = 0; i < 500; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-3, 1e3);
    const Trio<double> trio{contact_weights(1.0, alpha, 1.0), contact_weights(1.0, alpha, 1.0)};
    const auto recorded = record_three_body(alpha);
    BodyVelocities<double> alone{1.0, 0.0, 0.0};
    CHECK(step_trio(trio, alone, no_limit) == static_cast<std::int64_t>(recorded.events.size()));
    BodyVelocities<double> v{1.0, 0.0, 0.0};
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
  std::int64_t expected[] = {3, 31, 314, 3141, 31415, 314159, 3141592, 31415926};
  double ratio = 1.0;
  for (const std::int64_t digits : expected) {
    const Trio<double> trio{contact_weights(ratio, 1.0, 1.0), wall_weights(1.0)};
    BodyVelocities<double> v{1.0, 0.0, 0.0};
    CHECK(step_trio(trio, v, no_limit) == digits);
    ratio *= 100.0;
  }
}

TEST_CASE("a limit stops stepping where it is", "[exam]") {
  const Trio<double> trio{contact_weights(1e6, 1.0, 1.0), wall_weights(1.0)};
  BodyVelocities<double> v{1.0, 0.0, 0.0};
  CHECK(step_trio(trio, v, 101) == 101);
  CHECK(v.c > 0.0);  // after P
}

TEST_CASE("... and 3 * 10^8 events count nine digits, in doubles", "[time]") {
  const Trio<double> trio{contact_weights(1e16, 1.0, 1.0), wall_weights(1.0)};
  BodyVelocities<double> v{1.0, 0.0, 0.0};
  CHECK(step_trio(trio, v, no_limit) == 314159265);
}
