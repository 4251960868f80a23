// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "magicmass/accurate.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/evaluators/count_decision.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/scenes/mass_ratio.hpp"
#include "magicmass/simulator/velocity_stepping.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

TEST_CASE("the paper's counts", "[exam]") {
  CHECK(count_collisions(0.12) == Counts{3, 3});
  CHECK(count_collisions(0.10) == Counts{4, 3});
  CHECK(count_collisions(1.0) == Counts{1, 1});
  CHECK(count_collisions(3.0) == Counts{1, 1});
  CHECK(count_collisions(std::numeric_limits<double>::max()) == Counts{1, 1});
}

TEST_CASE("the one threshold that is a double, and its neighbours", "[exam]") {
  CHECK(decide_count(std::nextafter(1.0, 0.0)).counts == Counts{2, 1});
  CHECK(decide_count(1.0).counts == Counts{1, 1});
  CHECK(decide_count(std::nextafter(1.0, 2.0)).counts == Counts{1, 1});
}

TEST_CASE("the doubles closest to a threshold are decided by the exact path", "[exam]") {
  for (const double alpha : {0x1.1c7397cb68b7ep-18, 0x1.bc7fb47556f22p-29}) {
    CHECK(decide_count(alpha).near_tie);
    const Counts here = count_collisions(alpha).value();
    const Counts below = count_collisions(std::nextafter(alpha, 0.0)).value();
    const Counts above = count_collisions(std::nextafter(alpha, 1.0)).value();
    CHECK(below.N_A + below.N_B - (above.N_A + above.N_B) == 1);
    CHECK((here == below || here == above));
  }
  CHECK_FALSE(decide_count(0.12).near_tie);
  CHECK_FALSE(decide_count(1e-12).near_tie);
}

TEST_CASE("next to thresholds the angle tells what the decision with its margins does", "[check]") {
  testing::Generator generator(51);
  std::int64_t past_2_53 = 0;
  for (int i = 0; i < 1500; ++i) {
    const auto k = static_cast<std::int64_t>(testing::log_uniform(generator, 1.0, 0x1p61));
    const auto ratios = accurate::ratios(k);  // thresholds but for their rounding
    for (const double threshold : {ratios.magic, ratios.deficient}) {
      double alpha = threshold;
      for (int ulp = 0; ulp < 3; ++ulp) alpha = std::nextafter(alpha, 0.0);
      for (int ulp = 0; ulp < 7; ++ulp, alpha = std::nextafter(alpha, 1.0)) {
        INFO(to_text(MassRatio(alpha)));
        const auto decided = decide_count(alpha).counts;
        REQUIRE(count_collisions(alpha) == decided);
        REQUIRE(fast::terminal(alpha)->counts == decided);
        past_2_53 += decided->N_A > std::int64_t{1} << 53U;
      }
    }
  }
  CHECK(past_2_53 > 100);
}

TEST_CASE("counts end where 63 bits end", "[exam]") {
  CHECK(count_collisions(5.9e-38).has_value());
  CHECK_FALSE(count_collisions(5.7e-38).has_value());
  CHECK_FALSE(count_collisions(std::numeric_limits<double>::denorm_min()).has_value());
  // bisect for the last double that fits: its total must be within reach of 2^63
  double fits = 5.9e-38;
  double large = 5.7e-38;
  while (std::nextafter(large, 1.0) < fits) {
    const double middle = large + (fits - large) / 2;
    (count_collisions(middle) ? fits : large) = middle;
  }
  const Counts last = count_collisions(fits).value();
  const auto total = static_cast<std::uint64_t>(last.N_A) + static_cast<std::uint64_t>(last.N_B);
  CHECK(total < std::uint64_t{1} << 63U);
  CHECK(static_cast<double>(total) >
        0x1p63 * (1 - 0x1p-51));  // one spacing of alpha is half of one in the count
}

TEST_CASE("alpha that is no mass ratio is refused", "[exam]") {
  CHECK_THROWS_WITH(count_collisions(-0.1), "alpha must be a positive finite number, got -0.1");
  CHECK_THROWS_AS(count_collisions(0.0), InvalidInput);
  CHECK_THROWS_AS(count_collisions(std::numeric_limits<double>::infinity()), InvalidInput);
  CHECK_THROWS_AS(count_collisions(std::numeric_limits<double>::quiet_NaN()), InvalidInput);
}

TEST_CASE("counting agrees with stepping the collisions", "[check]") {
  testing::Generator generator(6);
  for (int i = 0; i < 2000; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-7, 1e3);
    REQUIRE(count_collisions(alpha) == step_velocities<long double>(alpha).counts);
  }
}

TEST_CASE("counts never fall as alpha falls", "[check]") {
  testing::Generator generator(7);
  for (int i = 0; i < 20000; ++i) {
    const double alpha = testing::log_uniform(generator, 6e-38, 1.0);
    const Counts here = count_collisions(alpha).value();
    const Counts below = count_collisions(std::nextafter(alpha, 0.0)).value();
    REQUIRE((here.N_A <= below.N_A && here.N_B <= below.N_B));
    REQUIRE((here.N_A == here.N_B || here.N_A == here.N_B + 1));
  }
}
