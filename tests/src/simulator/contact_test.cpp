// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/simulator/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "random_numbers.hpp"

using namespace magicmass;

TEST_CASE("equal masses exchange their velocities", "[exam]") {
  const AfterContact<double> after = collide(1.0, 3.0, 1.0, -2.0);
  CHECK(after.first == -2.0);
  CHECK(after.second == 3.0);
}

TEST_CASE("a hand-worked contact of masses 1 and 3", "[exam]") {
  // centre of mass at (1*4 + 3*0)/4 = 1: 4 -> -2 and 0 -> 2
  const AfterContact<double> after = collide(1.0, 4.0, 3.0, 0.0);
  CHECK(after.first == -2.0);
  CHECK(after.second == 2.0);
}

TEST_CASE("masses at the ends of the doubles overflow nothing", "[exam]") {
  const double largest = std::numeric_limits<double>::max();
  CHECK(collide(1.0, 1.0, largest, 0.0).first == -1.0);
  CHECK(collide(1.0, 1.0, std::numeric_limits<double>::denorm_min(), 0.0).second == 2.0);
}

TEST_CASE("relative velocity turns round within the stated 6 eps", "[check]") {
  testing::Generator generator(2);
  for (int i = 0; i < 10000; ++i) {
    const double mass = testing::log_uniform(generator, 1e-20, 1e20);
    const double u1 = testing::log_uniform(generator, 1e-3, 1.0);
    const double u2 = -testing::log_uniform(generator, 1e-3, 1.0);
    const auto got = collide(1.0, u1, mass, u2);
    const auto exact = collide<long double>(1.0L, u1, mass, u2);
    const double bound =
        6 * std::numeric_limits<double>::epsilon() * std::max(std::fabs(u1), std::fabs(u2));
    REQUIRE(std::fabs(static_cast<double>(got.first - exact.first)) <= bound);
    REQUIRE(std::fabs(static_cast<double>(got.second - exact.second)) <= bound);
  }
}

TEST_CASE("with restitution velocities are within the stated 8 eps of the law", "[check]") {
  testing::Generator generator(3);
  for (int i = 0; i < 10000; ++i) {
    const double mass = testing::log_uniform(generator, 1e-20, 1e20);
    const double u1 = testing::log_uniform(generator, 1e-3, 1.0);
    const double u2 = -testing::log_uniform(generator, 1e-3, 1.0);
    const double e = testing::log_uniform(generator, 1e-3, 1.0);
    const auto got = collide(1.0, u1, mass, u2, e);
    // Momentum and the relative velocity's fraction e, solved for the impulse of the contact.
    const long double impulse =
        (1.0L + e) * (static_cast<long double>(u1) - u2) * mass / (1.0L + mass);
    const double bound =
        8 * std::numeric_limits<double>::epsilon() * std::max(std::fabs(u1), std::fabs(u2));
    REQUIRE(std::fabs(static_cast<double>(got.first - (u1 - impulse))) <= bound);
    REQUIRE(std::fabs(static_cast<double>(got.second - (u2 + impulse / mass))) <= bound);
  }
}
