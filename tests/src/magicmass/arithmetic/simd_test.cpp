// Simd and functions of bits; tests of rounding, signs and ranges at their edges from both sides.

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "magicmass/arithmetic/rounding_test.hpp"

using namespace magicmass::arithmetic;

namespace {
using D = DoubleDouble<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
}  // namespace

TEST_CASE("all, load and store reach every lane, aligned or not") {
  double numbers[2 * 8 + 1];
  for (int k = 0; k <= 16; ++k) numbers[k] = 1.5 * k;
  for (int offset = 0; offset <= lanes; ++offset) {
    const Simd x = load<Simd>(numbers + offset);
    double back[8] = {};
    store(back, x + all<Simd>(1.0));
    for (int k = 0; k < lanes; ++k) REQUIRE(back[k] == numbers[offset + k] + 1.0);
  }
}
TEST_CASE("square_root, magnitude and times_sign_of are those of single numbers") {
  for (double x : {0.0, 2.0, 0x1p-1074, 0x1.fffffffffffffp1023}) {
    CHECK(square_root(x) == std::sqrt(x));
    CHECK(square_root(all<Simd>(x))[lanes - 1] == std::sqrt(x));
    CHECK(magnitude(all<Simd>(-x))[0] == x);
    CHECK(magnitude(-x) == x);
    for (double y : {-0.0, 0.0, -3.0, 3.0}) {
      const double expected = std::signbit(y) ? -x : x;
      CHECK(times_sign_of(x, y) == expected);
      CHECK(times_sign_of(all<Simd>(x), all<Simd>(y))[lanes - 1] == expected);
    }
  }
}
TEST_CASE("select takes its first number where the mask is set") {
  CHECK(select(is_above(2.0, 1.0), 5.0, 6.0) == 5.0);
  CHECK(select(is_above(1.0, 1.0), 5.0, 6.0) == 6.0);
  Simd x = all<Simd>(1.0);
  x[0] = 2.0;
  const Simd chosen = select(is_above(x, all<Simd>(1.0)), all<Simd>(5.0), all<Simd>(6.0));
  CHECK(chosen[0] == 5.0);
  CHECK(chosen[lanes - 1] == 6.0);
}
TEST_CASE("nearest rounds to whole numbers, ties to even, up to 2^51") {
  for (double x :
       {0.0, 0.5, 1.5, 2.5, -0.5, -1.5, 0.49999999999999994, 1e15 + 0.5, -0x1p51, 0x1p51}) {
    CHECK(nearest(x) == std::nearbyint(x));
    CHECK(nearest(all<Simd>(x))[lanes - 1] == std::nearbyint(x));
  }
  CHECK(nearest(0x1p52 + 1.0) != 0x1p52 + 1.0);  // beyond its range
}
TEST_CASE("whole numbers to doubles and back, from 0 to 2^52 - 1") {
  for (std::int64_t n : {std::int64_t(0), std::int64_t(1), std::int64_t(4503599627370495)}) {
    const SimdMask many = SimdMask{} + n;
    CHECK(to_real(many)[lanes - 1] == double(n));
    CHECK(to_whole(all<Simd>(double(n)))[lanes - 1] == n);
    CHECK(to_whole(to_real(n)) == n);
  }
  // One past the end does not come back: callers compare, and leave the row open.
  CHECK(to_whole(to_real(SimdMask{} + (std::int64_t(1) << 52)))[0] != std::int64_t(1) << 52);
}
TEST_CASE("a rounding is certain up to the middle between two doubles") {
  const double half = 0x1p-53, error = 0x1p-80;
  const Rounded<double> below = rounding_test(D{1.0, half - 0x1p-79}, error);
  CHECK(below.value == 1.0);
  CHECK(below.doubt == 0.0);
  CHECK(rounding_test(D{1.0, half - 0x1p-81}, error).doubt != 0.0);
  CHECK(rounding_test(D{1.0, half + 0x1p-81}, error).doubt != 0.0);
  const Rounded<double> above = rounding_test(D{1.0, half + 0x1p-79}, error);
  CHECK(above.value == 0x1.0000000000001p0);
  CHECK(above.doubt == 0.0);
}
TEST_CASE("below a power of two doubles are twice as close") {
  CHECK(rounding_test(D{1.0, -0x1p-54 + 0x1p-79}, 0x1p-80).doubt == 0.0);
  CHECK(rounding_test(D{1.0, -0x1p-54 + 0x1p-81}, 0x1p-80).doubt != 0.0);
  CHECK(rounding_test(D{1.0, -0x1p-54 - 0x1p-79}, 0x1p-80).value == 0x1.fffffffffffffp-1);
}
TEST_CASE("an exact tie is open where the error counts the low part's rounding") {
  CHECK(rounding_test(D{1.0, 0x1p-53}, 0x1p-105).doubt != 0.0);
  CHECK(rounding_test(D{1.0, 0x1p-53}, 0x1p-107).doubt == 0.0);  // so the bounds count it
}
TEST_CASE("NaN and infinity leave a doubt") {
  for (const D& p : {D{nan_, 0.0}, D{1.0, nan_}, D{infinity, 0.0}, D{-infinity, 0.0}})
    CHECK_FALSE(rounding_test(p, 0x1p-80).doubt == 0.0);
  CHECK_FALSE(rounding_test(D{1.0, 0.0}, nan_).doubt == 0.0);
  CHECK(doubt_of_sign(D{nan_, 0.0}, 0.0) == 1.0);
  CHECK(doubt_of_sign(D{1.0, 0.0}, nan_) == 1.0);
  CHECK(doubt_of_range(D{nan_, 0.0}, 0.0, 1.0) == 1.0);
}
TEST_CASE("a sign is certain above its error alone") {
  CHECK(doubt_of_sign(D{0x1.0000000000001p-80, 0.0}, 0x1p-80) == 0.0);
  CHECK(doubt_of_sign(D{0x1p-80, 0.0}, 0x1p-80) == 1.0);
  CHECK(doubt_of_sign(D{-1.0, 0.0}, 0x1p-80) == 1.0);
}
TEST_CASE("a range is open at its ends") {
  for (double x : {0.26, 1.99}) CHECK(doubt_of_range(D{x, 0.0}, 0.25, 2.0) == 0.0);
  for (double x : {0.25, 2.0, -3.0}) CHECK(doubt_of_range(D{x, 0.0}, 0.25, 2.0) == 1.0);
}
TEST_CASE("in a register each lane has its own doubt") {
  Simd high = all<Simd>(1.0), low = all<Simd>(0.0);
  low[lanes - 1] = 0x1p-53;
  const Simd doubt = rounding_test(DoubleDouble<Simd>{high, low}, all<Simd>(0x1p-80)).doubt;
  CHECK(doubt[0] == 0.0);
  CHECK(doubt[lanes - 1] != 0.0);
}
