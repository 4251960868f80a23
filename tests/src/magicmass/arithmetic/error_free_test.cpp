// SPDX-License-Identifier: GPL-2.0-or-later
// Error-free transforms against whole numbers of 128 bits.
#include <cmath>
#include <random>

#include "catch.hpp"
#include "magicmass/arithmetic/double_double.hpp"

using namespace magicmass::arithmetic;

namespace {
__extension__ typedef __int128 Whole;
using D = DoubleDouble<double>;

// A whole number of up to 53 bits, often near a power of two.
double draw(std::mt19937_64& random) {
  const int bits = 1 + int(random() % 53);
  const double top = std::ldexp(1.0, bits);
  const double x = random() % 4 == 0 ? top - double(random() % 3)
                                     : std::floor(top * double(random() >> 11) * 0x1p-53);
  return random() % 2 == 0 ? x : -x;
}
Whole whole(double x) { return Whole(x); }
double half_ulp(double x) { return std::ldexp(0.5, std::ilogb(x) - 52); }
}  // namespace

TEST_CASE("two_sum and fast_two_sum are exact, and high is the rounded sum") {
  std::mt19937_64 random(1);
  for (int row = 0; row < 100000; ++row) {
    const double x = draw(random) * std::ldexp(1.0, int(random() % 60));
    const double y = draw(random);
    const D sum = two_sum(x, y);
    REQUIRE(sum.high == x + y);
    REQUIRE(whole(sum.high) + whole(sum.low) == whole(x) + whole(y));
    const D ordered = std::fabs(x) >= std::fabs(y) ? fast_two_sum(x, y) : fast_two_sum(y, x);
    REQUIRE(ordered.high == sum.high);
    REQUIRE(ordered.low == sum.low);
  }
}

TEST_CASE("fast_two_sum loses at most an ulp's half of y where |x| < |y|") {
  const D sum = fast_two_sum(1.0, 0x1.fffffffffffffp53);
  REQUIRE(two_sum(1.0, 0x1.fffffffffffffp53).low != sum.low);
  std::mt19937_64 random(2);
  for (int row = 0; row < 100000; ++row) {
    const double x = draw(random), y = draw(random) * 4.0;
    if (y == 0.0) continue;
    const D s = fast_two_sum(x, y);
    const Whole lost = whole(x) + whole(y) - whole(s.high) - whole(s.low);
    REQUIRE(std::fabs(double(lost)) <= half_ulp(y));
  }
}

TEST_CASE("veltkamp_split gives two numbers of 26 bits, two_product is exact") {
  std::mt19937_64 random(3);
  for (int row = 0; row < 100000; ++row) {
    const double x = draw(random), y = draw(random);
    const D parts = veltkamp_split(x);
    REQUIRE(parts.high + parts.low == x);
    const double unit = std::ldexp(1.0, x == 0.0 ? 0 : std::ilogb(x) - 25);
    REQUIRE(std::fmod(parts.high, unit) == 0.0);
    REQUIRE(std::fabs(parts.low) <= unit / 2);
    const D product = two_product(x, y);
    REQUIRE(whole(product.high) + whole(product.low) == whole(x) * whole(y));
  }
}

TEST_CASE("two_product is exact to the ends of its range, and not beyond") {
  const double x = 0x1.0000000000001p0;
  for (double scale : {0x1p-480, 0x1p480}) {
    const D product = two_product(x * scale, x * scale);
    CHECK(product.high == (x * x) * scale * scale);
    CHECK(product.low == 0x1p-104 * scale * scale);
  }
  // Below, Dekker's product is not even the rounded one, which a fused operation gives.
  const bool is_rounded = two_product(x * 0x1p-512, x * 0x1p-512).low == 0;
  CHECK(is_rounded == magicmass::arithmetic::has_fma);
}

TEST_CASE("less_product has one rounding, where the product is near") {
  std::mt19937_64 random(4);
  for (int row = 0; row < 100000; ++row) {
    const double x = std::fabs(draw(random)) + 1.0;
    const double y = std::fabs(draw(random)) + 1.0;
    const double z = x * y * (0.5 + 1.5 * double(random() >> 11) * 0x1p-53);
    if (z < x * y / 2 || z > 2 * (x * y) || z != std::floor(z)) continue;
    REQUIRE(less_product(z, x, y) == double(whole(z) - whole(x) * whole(y)));
  }
}
