// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/nearest_threshold.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using cln::cl_RA;

namespace {

/// (alpha - threshold)/threshold from CLN.
double distance(double alpha, bool is_magic, std::int64_t k) {
  constexpr long bits = 400;
  const cl_RA threshold = is_magic ? reference::ratio_within(Magic{k}, bits)
                                   : reference::ratio_within(Deficient{k}, bits);
  return reference::nearest<double>((reference::exact(alpha) - threshold) / threshold);
}

double distance_by_reference(double alpha, const NearestThreshold& nearest) {
  return distance(alpha, nearest.is_magic, nearest.k);
}

}  // namespace

TEST_CASE("no threshold is closer, and the distance is right", "[check]") {
  testing::Generator generator(91);
  for (int i = 0; i < 60; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-3, 20.0);
    INFO("alpha = " << to_text(MassRatio(alpha)));
    const NearestThreshold nearest = nearest_threshold(alpha).value();
    REQUIRE(nearest.distance == distance_by_reference(alpha, nearest));
    for (std::int64_t k = 1; k <= 60; ++k) {
      REQUIRE(std::fabs(distance(alpha, true, k)) >= std::fabs(nearest.distance));
      REQUIRE(std::fabs(distance(alpha, false, k)) >= std::fabs(nearest.distance));
    }
  }
}

TEST_CASE("next to a threshold it is that one", "[check]") {
  testing::Generator generator(92);
  for (int i = 0; i < 200; ++i) {
    const auto k = static_cast<std::int64_t>(testing::log_uniform(generator, 1.0, 2e18));
    const bool is_magic = i % 2 == 0;
    const double threshold = is_magic ? reference::nearest_ratio<double>(Magic{k})
                                      : reference::nearest_ratio<double>(Deficient{k});
    const NearestThreshold nearest = nearest_threshold(threshold).value();
    if (k < 1000000) {  // beyond some 1e7 there are several between two doubles
      REQUIRE(nearest.is_magic == is_magic);
      REQUIRE(nearest.k == k);
    }
    REQUIRE(nearest.distance == distance_by_reference(threshold, nearest));
    REQUIRE(std::fabs(nearest.distance) <= 0x1p-53);
  }
}

TEST_CASE("the doubles closest to a threshold, alpha = 1, and where there is none", "[exam]") {
  const NearestThreshold magic = nearest_threshold(0x1.1c7397cb68b7ep-18).value();
  CHECK(magic.is_magic);
  CHECK(magic.k == 539);
  CHECK(std::fabs(magic.distance) < 0x1p-70);
  CHECK(magic.distance == distance_by_reference(0x1.1c7397cb68b7ep-18, magic));
  const NearestThreshold deficient = nearest_threshold(0x1.bc7fb47556f22p-29).value();
  CHECK_FALSE(deficient.is_magic);
  CHECK(deficient.k == 19530);
  CHECK(std::fabs(deficient.distance) < 0x1p-70);
  const NearestThreshold one = nearest_threshold(1.0).value();
  CHECK(one.k == 1);
  CHECK(one.is_magic);
  CHECK(one.distance == 0.0);
  CHECK(nearest_threshold(std::nextafter(1.0, 0.0)).value().distance == -0x1p-53);
  CHECK(nearest_threshold(3.0).value().distance == 2.0);
  CHECK_FALSE(nearest_threshold(1e-100).has_value());
  CHECK_THROWS_AS(nearest_threshold(-1.0), InvalidInput);
}
