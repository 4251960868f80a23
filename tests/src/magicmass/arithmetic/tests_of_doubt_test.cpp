// SPDX-License-Identifier: GPL-2.0-or-later
// The rounding test and the tests of signs and ranges, at their edges from both sides.
#include <limits>

#include "catch.hpp"
#include "magicmass/arithmetic/rounding_test.hpp"

using namespace magicmass::arithmetic;

namespace {
using D = DoubleDouble<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
}  // namespace

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
