// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/exact_angles.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "report/last_collision.hpp"

using namespace magicmass;
using namespace magicmass::report;

TEST_CASE("times and distances are those of events in exact rationals", "[check]") {
  for (const double alpha : {0.013, 0.05, 0.1, 0.33, 0.5, 1.0, 7.0, 1e200}) {
    const auto events = record_three_body(reference::exact(alpha)).events;
    for (std::size_t j = 0; j < events.size(); ++j) {
      const auto found = exact_encounter({alpha, static_cast<std::int64_t>(j)});
      const cln::cl_RA members[] = {events[j].time, events[j].positions.b - events[j].positions.a};
      for (std::size_t m = 0; m < 2; ++m) {
        CHECK(found[m].exists);
        CHECK(found[m].high == reference::nearest<long double>(members[m]));
        CHECK(found[m].nearest_double == reference::nearest<double>(members[m]));
        CHECK(found[m].nearest_float == reference::nearest<float>(members[m]));
      }
    }
    CHECK_FALSE(exact_encounter({alpha, static_cast<std::int64_t>(events.size())})[0].exists);
  }
}

TEST_CASE("a tie of t_1 = (1+alpha)/2 is a tie", "[exam]") {
  const auto found = exact_encounter({0x1p-53, 1});
  CHECK(found[0].high == 0.5L + 0x1p-54L);
  CHECK(found[0].nearest_double == 0.5);
}

TEST_CASE("conditions of t_1 = (1+alpha)/2 and of a small psi", "[exam]") {
  for (const double alpha : {0.1, 3.0, 1e300})
    CHECK(exact_encounter({alpha, 1})[0].condition == Approx(1 / (1 + 1 / alpha)));
  CHECK(exact_angle({1e-200, 0})[0].condition == Approx(0.5));
}

TEST_CASE("next to a pole the condition is the distance to it", "[exam]") {
  // Below a threshold of `total` collisions by a relative gap g, t is as h/(pi - total h): condition 1/(2 g) about.
  const double alpha = std::nextafter(1.0, 0.0);
  REQUIRE(last_collision(alpha).total() == 3);
  const auto last = exact_encounter({alpha, 2});
  CHECK(last[0].condition > 0x1p52);
  CHECK(last[0].condition < 0x1p54);
}

TEST_CASE("psi is 2 pi/3 at alpha = 1 and pi in the limit", "[exam]") {
  const long double pi = std::numbers::pi_v<long double>;
  const auto at_one = exact_angle({1.0, 0});
  CHECK(std::fabs(at_one[0].high - 2 * pi / 3) <= 0x1p-62L);
  CHECK(exact_angle({1e300, 0})[0].high == pi);
  // cos(psi/2) = 1/(1 + alpha)
  for (const double alpha : {1e-3, 0.2, 5.0}) {
    const long double half = exact_angle({alpha, 0})[0].high / 2;
    CHECK(std::fabs(std::cos(half) * (1 + static_cast<long double>(alpha)) - 1) < 0x1p-58L);
  }
}
