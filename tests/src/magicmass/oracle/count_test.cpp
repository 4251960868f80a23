// SPDX-License-Identifier: GPL-2.0-or-later
// Counts: known ones, those beside thresholds, of any size; against stepping in exact rationals.
#include "magicmass/oracle/count.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "catch.hpp"
#include "magicmass/oracle/mass_ratio.hpp"
#include "magicmass/oracle/rational.hpp"
#include "magicmass/simulator/three_bodies.hpp"

using namespace magicmass::oracle;
using cln::cl_I;
using cln::cl_RA;

namespace {

Counts stepped(const cl_RA& alpha) {
  magicmass::simulator::ThreeBodies<cl_RA> bodies(alpha);
  Counts counts{0, 0};
  while (const auto event = bodies.step()) {
    cl_I& count = event->gap == 1 ? counts.N_A : counts.N_B;
    count = count + 1;
  }
  return counts;
}

/// alpha against a threshold that is not a double.
bool is_above(double alpha, const MassRatio& threshold) {
  const Interval distance = Interval(exact(alpha), 400) - threshold.enclosed(400);
  REQUIRE(distance.sign() != Sign::open);
  return distance.sign() == Sign::positive;
}

Counts of_double(double alpha) { return count_collisions(exact(alpha)); }

}  // namespace

TEST_CASE("known counts", "[exam]") {
  CHECK(count_collisions(1) == Counts{1, 1});
  CHECK(count_collisions(cl_RA(1) / 7) == Counts{3, 3});
  CHECK(of_double(std::nextafter(1.0, 0.0)) == Counts{2, 1});
  CHECK(of_double(std::nextafter(1.0, 2.0)) == Counts{1, 1});
  CHECK(of_double(std::numeric_limits<double>::max()) == Counts{1, 1});
  CHECK_THROWS_AS(count_collisions(0), std::invalid_argument);
  CHECK_THROWS_AS(count_collisions(-1), std::invalid_argument);
}

TEST_CASE("doubles beside a threshold fall on its two sides", "[exam]") {
  const double magic_2 = std::sqrt(5.0) - 2;
  double below = magic_2;
  while (is_above(below, magic(2))) below = std::nextafter(below, 0.0);
  CHECK(of_double(below) == Counts{3, 2});
  const double above = std::nextafter(below, 1.0);
  CHECK(is_above(above, magic(2)));
  CHECK(of_double(above) == Counts{2, 2});
  const double near_magic = 0x1.1c7397cb68b7ep-18;
  const Counts at_magic = is_above(near_magic, magic(539)) ? Counts{539, 539} : Counts{540, 539};
  CHECK(of_double(near_magic) == at_magic);
  const double near_deficient = 0x1.bc7fb47556f22p-29;
  const bool deficient_above = is_above(near_deficient, deficient(19530));
  const Counts at_deficient = deficient_above ? Counts{19531, 19530} : Counts{19531, 19531};
  CHECK(of_double(near_deficient) == at_deficient);
}

TEST_CASE("bisection and stepping agree", "[check]") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 40; ++i) {
    const auto below = static_cast<long>(90 + random() % 3000);
    const cl_RA alpha = cl_RA(static_cast<long>(1 + random() % 4)) / below;
    CHECK(count_collisions(alpha) == stepped(alpha));
  }
  for (int i = 1; i < 60; ++i) CHECK(count_collisions(cl_RA(i) / 20) == stepped(cl_RA(i) / 20));
}

TEST_CASE("the simulator in doubles counts right or says that it may not", "[check]") {
  std::mt19937_64 random(7);
  int wrong = 0, silent = 0;
  for (int i = 0; i < 300; ++i) {
    const auto k = static_cast<long>(2 + random() % 400);
    const MassRatio threshold = i % 2 == 0 ? magic(k) : deficient(k);
    const double beside = nearest(threshold.enclosed(200).low());
    const auto steps = static_cast<double>(random() % 9) - 4;
    const double alpha = beside * (1 + steps * 0x1p-52);
    magicmass::simulator::ThreeBodies<double> bodies(alpha);
    int collisions = 0;
    while (bodies.step()) ++collisions;
    const Counts counts = of_double(alpha);
    const bool is_right = counts.N_A + counts.N_B == collisions;
    wrong += is_right ? 0 : 1;
    silent += is_right || bodies.near_ties() > 0 ? 0 : 1;
  }
  CHECK(wrong > 0);
  CHECK(silent == 0);
}

TEST_CASE("counts of any size", "[exam]") {
  const cl_I limit = cln::ash(cl_I(1), 63);
  const Counts below = of_double(5.9e-38);
  CHECK(below.N_A + below.N_B < limit);
  const Counts above = of_double(5.7e-38);
  CHECK(above.N_A + above.N_B >= limit);
  // N is the ceiling of pi/h less 1 with h = sqrt(2 alpha) to leading order.
  const Counts smallest = of_double(std::numeric_limits<double>::denorm_min());
  const double N = nearest(cl_RA(smallest.N_A + smallest.N_B));
  CHECK_THAT(N, WithinRel(3.141592653589793 / std::sqrt(2.0) * std::pow(2.0, 537), 1e-13));
}
