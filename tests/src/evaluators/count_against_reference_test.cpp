// SPDX-License-Identifier: GPL-2.0-or-later
// The exact count of src/magicmass/evaluators against an oracle that knows only the collision law.
#include <catch2/catch.hpp>

#include "magicmass/counts.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

bool agrees(const Counts& got, double alpha) {
  const reference::LargeCounts expected = reference::count_collisions(reference::exact(alpha));
  return expected.N_A == got.N_A && expected.N_B == got.N_B;
}

bool agrees(double alpha) { return agrees(count_collisions(alpha).value(), alpha); }

}  // namespace

TEST_CASE("no mismatch at any threshold up to the thousandth and its neighbours within 3 ulp",
          "[check]") {
  for (int k = 1; k <= 1000; ++k) {
    for (const double threshold : {reference::nearest_ratio<double>(Magic{k}),
                                   reference::nearest_ratio<double>(Deficient{k})}) {
      for (const double alpha : testing::neighbourhood(threshold, 3)) {
        INFO("k = " << k << ", alpha = " << to_text(MassRatio(alpha)));
        REQUIRE(agrees(alpha));
      }
    }
  }
}

TEST_CASE("no mismatch at thresholds of large index", "[check]") {
  testing::Generator generator(21);
  for (int i = 0; i < 100; ++i) {
    const auto k = static_cast<std::int64_t>(testing::log_uniform(generator, 1e3, 4e18));
    for (const double alpha :
         testing::neighbourhood(reference::nearest_ratio<double>(Magic{k}), 3)) {
      INFO("k = " << k << ", alpha = " << to_text(MassRatio(alpha)));
      REQUIRE(agrees(alpha));
    }
  }
}

TEST_CASE("no mismatch at random alpha from 1e-37 to 1e300, at 1 and at the closest doubles",
          "[check]") {
  testing::Generator generator(22);
  for (int i = 0; i < 2000; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-37, i % 4 == 0 ? 1e300 : 1.0);
    INFO("alpha = " << to_text(MassRatio(alpha)));
    REQUIRE(agrees(alpha));
  }
  for (const double centre : {1.0, 0x1.1c7397cb68b7ep-18, 0x1.bc7fb47556f22p-29}) {
    for (const double alpha : testing::neighbourhood(centre, 3)) {
      INFO("alpha = " << to_text(MassRatio(alpha)));
      REQUIRE(agrees(alpha));
    }
  }
}

TEST_CASE("the last double whose count fits 63 bits", "[exam]") {
  double fits = 5.9e-38;
  double large = 5.7e-38;
  while (std::nextafter(large, 1.0) < fits) {
    const double middle = large + (fits - large) / 2;
    (count_collisions(middle) ? fits : large) = middle;
  }
  CHECK(agrees(fits));
  const auto beyond = reference::count_collisions(reference::exact(large));
  CHECK(beyond.N_A + beyond.N_B >= cln::ash(cln::cl_I(1), 63));
}

TEST_CASE("a count off by one would be seen", "[exam]") {
  CHECK(agrees(Counts{4, 3}, 0.1));
  CHECK_FALSE(agrees(Counts{4, 4}, 0.1));
  CHECK_FALSE(agrees(Counts{3, 3}, 0.1));
}
