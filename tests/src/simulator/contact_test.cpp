// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/simulator/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "random_numbers.hpp"

using namespace magicmass;

namespace {

/// A body of mass 1 and one of another mass that approach each other.
struct Approach {
  double mass, u1, u2;

  explicit Approach(testing::Generator& generator)
      : mass(testing::log_uniform(generator, 1e-20, 1e20)),
        u1(testing::log_uniform(generator, 1e-3, 1.0)),
        u2(-testing::log_uniform(generator, 1e-3, 1.0)) {}
  /// So many eps of the larger speed.
  double bound(int eps) const {
    return eps * std::numeric_limits<double>::epsilon() * std::max(std::fabs(u1), std::fabs(u2));
  }
};

void check_within(double bound, const AfterContact<double>& got,
                  const AfterContact<long double>& exact) {
  REQUIRE(std::fabs(static_cast<double>(got.first - exact.first)) <= bound);
  REQUIRE(std::fabs(static_cast<double>(got.second - exact.second)) <= bound);
}

}  // namespace

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
    const Approach x(generator);
    check_within(x.bound(6), collide(1.0, x.u1, x.mass, x.u2),
                 collide<long double>(1.0L, x.u1, x.mass, x.u2));
  }
}

TEST_CASE("with restitution velocities are within the stated 8 eps of the law", "[check]") {
  testing::Generator generator(3);
  for (int i = 0; i < 10000; ++i) {
    const Approach x(generator);
    const double e = testing::log_uniform(generator, 1e-3, 1.0);
    // Momentum and the relative velocity's fraction e, solved for the impulse of the contact.
    const long double impulse =
        (1.0L + e) * (static_cast<long double>(x.u1) - x.u2) * x.mass / (1.0L + x.mass);
    check_within(x.bound(8), collide(1.0, x.u1, x.mass, x.u2, e),
                 {x.u1 - impulse, x.u2 + impulse / x.mass});
  }
}
