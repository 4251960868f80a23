// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/rational.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <catch2/catch.hpp>
#include <cln/integer.h>

#include "magicmass/errors.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using namespace magicmass::reference;
using cln::cl_I;
using cln::cl_RA;

namespace {

cl_RA two_to(long exponent) {
  const cl_I power = cln::ash(cl_I(1), exponent < 0 ? -exponent : exponent);
  return exponent < 0 ? cln::recip(cl_RA(power)) : cl_RA(power);
}

template <class Float>
void check_rounding_by_hand() {
  using Limits = std::numeric_limits<Float>;
  const Float eps = Limits::epsilon();
  const long digits = Limits::digits;
  const long tiny = Limits::min_exponent - digits;  // denorm_min = 2^tiny
  const cl_RA half_unit = two_to(-digits);          // half the spacing from 1 to 2
  const cl_RA hair = two_to(-20000);
  CHECK(nearest<Float>(cl_RA(0)) == 0);
  CHECK(nearest<Float>(1 + half_unit) == 1);
  CHECK(nearest<Float>(1 + half_unit + hair) == 1 + eps);
  CHECK(nearest<Float>(1 + half_unit - hair) == 1);
  CHECK(nearest<Float>(1 + 3 * half_unit) == 1 + 2 * eps);
  CHECK(nearest<Float>(1 + 3 * half_unit - hair) == 1 + eps);
  CHECK(nearest<Float>(-1 - 3 * half_unit) == -1 - 2 * eps);
  CHECK(nearest<Float>(2 - half_unit) == 2);  // a tie that carries into the next binade
  CHECK(nearest<Float>(1 - half_unit / 2) == 1);
  CHECK(nearest<Float>(1 - half_unit / 2 - hair) == 1 - eps / 2);
  CHECK(nearest<Float>(two_to(tiny)) == Limits::denorm_min());
  CHECK(nearest<Float>(two_to(tiny - 1)) == 0);
  CHECK(nearest<Float>(two_to(tiny - 1) + hair) == Limits::denorm_min());
  CHECK(nearest<Float>(-two_to(tiny - 1) - hair) == -Limits::denorm_min());
  CHECK(nearest<Float>(3 * two_to(tiny - 1)) == 2 * Limits::denorm_min());
  CHECK(nearest<Float>(two_to(tiny - 100)) == 0);
  CHECK(nearest<Float>(exact(Limits::min()) - two_to(tiny - 1)) ==
        Limits::min());  // up into the normal range
  const cl_RA largest = exact(Limits::max());
  const cl_RA half_last = two_to(Limits::max_exponent - digits - 1);
  CHECK(nearest<Float>(largest) == Limits::max());
  CHECK(nearest<Float>(largest + half_last - hair) == Limits::max());
  CHECK(nearest<Float>(largest + half_last) == Limits::infinity());
  CHECK(nearest<Float>(-largest - half_last) == -Limits::infinity());
  CHECK(nearest<Float>(two_to(100000)) == Limits::infinity());
}

}  // namespace

TEST_CASE("rounding to nearest, ties to even, against ties made by hand", "[exam]") {
  check_rounding_by_hand<float>();
  check_rounding_by_hand<double>();
  check_rounding_by_hand<long double>();
}

TEST_CASE("a double of any bit pattern survives the way to a rational and back", "[check]") {
  testing::Generator generator(11);
  for (int i = 0; i < 20000; ++i) {
    const auto x = std::bit_cast<double>(generator());
    if (std::isfinite(x)) {
      REQUIRE(nearest<double>(exact(x)) == x);
      REQUIRE(nearest<long double>(exact(static_cast<long double>(x))) ==
              static_cast<long double>(x));
    }
  }
}

TEST_CASE("rounding agrees with the processor's", "[check]") {
  testing::Generator generator(12);
  for (int i = 0; i < 20000; ++i) {
    const double x =
        testing::log_uniform(generator, 1e-46, 1e39);  // across float's subnormals and overflow
    REQUIRE(nearest<float>(exact(x)) == static_cast<float>(x));
    const long double y = std::ldexp(static_cast<long double>(generator()),
                                     static_cast<int>(testing::whole(generator, -1150, 970)));
    REQUIRE(nearest<double>(exact(y)) == static_cast<double>(y));
    const auto numerator = static_cast<double>(testing::whole(generator, 1, 1L << 52));
    const auto denominator = static_cast<double>(testing::whole(generator, 1, 1L << 52));
    REQUIRE(nearest<double>(exact(numerator) / exact(denominator)) == numerator / denominator);
  }
}

TEST_CASE("ulp errors by hand", "[exam]") {
  const double next = std::nextafter(1.0, 2.0);
  CHECK(ulp_error(1.0, 1) == 0.0);
  CHECK(ulp_error(next, 1) == 1.0);
  CHECK(ulp_error(std::nextafter(1.0, 0.0), 1) == 0.5);  // doubles are twice as dense below 1
  CHECK(ulp_error(0.1, cl_RA(1) / 10) < 0.5);
  CHECK(ulp_error(std::nextafter(0.1, 1.0), cl_RA(1) / 10) > 0.5);
  CHECK(ulp_error(std::nextafter(0.1, 1.0), cl_RA(1) / 10) < 1.5);
  CHECK(ulp_error(-1.0, 1) == 0x1p53);
  CHECK(ulp_error(0.0, 0) == 0.0);
  CHECK(ulp_error(std::numeric_limits<double>::denorm_min(), 0) == 1.0);
  CHECK(ulp_error(0.0, two_to(-1075)) == 0.5);
  CHECK(ulp_error(std::numeric_limits<double>::max(), two_to(1024)) == 1.0);
  CHECK(ulp_error(std::numeric_limits<double>::infinity(), two_to(2000)) == HUGE_VAL);
  CHECK(ulp_error(std::numeric_limits<double>::quiet_NaN(), 1) == HUGE_VAL);
  CHECK(ulp_error(std::nextafter(1.0F, 2.0F), 1) == 1.0);
  CHECK(ulp_error(std::nextafter(1.0L, 2.0L), 1) == 1.0);
}

TEST_CASE("the error of a correctly rounded double is at most half, of a neighbour about one",
          "[check]") {
  testing::Generator generator(13);
  for (int i = 0; i < 5000; ++i) {
    const cl_RA x =
        cl_RA(testing::whole(generator, 1, 1L << 60)) / testing::whole(generator, 1, 1L << 60);
    const auto rounded = nearest<double>(x);
    REQUIRE(ulp_error(rounded, x) <= 0.5);
    REQUIRE(ulp_error(std::nextafter(rounded, HUGE_VAL), x) >= 0.5);
    REQUIRE(ulp_error(std::nextafter(rounded, HUGE_VAL), x) <=
            2.0);  // 2 where a binade ends between
  }
}

TEST_CASE("mass ratios that are rationals by form", "[exam]") {
  CHECK(exact(MassRatio(0.1)).value() == cl_RA(cl_I("3602879701896397")) / two_to(55));
  CHECK(exact(MassRatio(Fraction{"2", "14"})).value() == cl_RA(1) / 7);
  CHECK_FALSE(exact(MassRatio(Magic{3})).has_value());
  CHECK_FALSE(exact(MassRatio(Deficient{1})).has_value());
}

TEST_CASE("rationals to text and back", "[exam]") {
  CHECK(to_text(cl_RA(-6) / 14) == "-3/7");
  CHECK(to_text(cl_RA(12)) == "12");
  CHECK(parse_rational("-3/7") == cl_RA(-3) / 7);
  CHECK(parse_rational("0012") == 12);
  CHECK(to_text(parse_rational("1/1" + std::string(200, '0'))) == "1/1" + std::string(200, '0'));
  for (const char* text :
       {"", "-", "/", "1/", "/2", "1/-2", "--1", "+1", "0x1", "1.5", "1 ", "1/2/3"}) {
    CHECK_THROWS_AS(parse_rational(text), InvalidInput);
  }
  CHECK_THROWS_WITH(parse_rational("1/0"), "division by zero: 1/0");
  CHECK_THROWS_AS(exact(std::numeric_limits<double>::infinity()), InvalidInput);
}
