// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/evaluators/fixed_point.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

#include "magicmass/cosine_ladder.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

/// Certain sign of sin(m h) sin h, or 0.
template <std::size_t Words>
int sign_of_sine(std::uint64_t m, double alpha) {
  using Number = FixedPoint<Words>;
  const Number x = Number::reciprocal(Number::one() + Number::from(alpha));
  const auto pair = generated::cosine_ladder(m, x, Number::one());
  return (x * pair.low - pair.high).certain_sign();
}

template <std::size_t Words>
FixedPoint<Words> fixed(double value) {
  return value < 0 ? FixedPoint<Words>() - FixedPoint<Words>::from(-value)
                   : FixedPoint<Words>::from(value);
}

/// Both differences from the expected double carry no certain sign, so the numbers agree within their bounds.
template <std::size_t Words>
bool agrees(const FixedPoint<Words>& got, double expected) {
  return (got - fixed<Words>(expected)).certain_sign() == 0;
}

}  // namespace

TEST_CASE("sums and products of doubles that fit are exact", "[check]") {
  testing::Generator generator(4);
  for (int i = 0; i < 10000; ++i) {
    const double x = static_cast<double>(testing::whole(generator, -1000000, 1000000)) / 1024.0;
    const double y = static_cast<double>(testing::whole(generator, -1000000, 1000000)) / 4096.0;
    REQUIRE((fixed<4>(x) + fixed<4>(y)).error_bound() < 1e-10);
    REQUIRE(agrees(fixed<4>(x) + fixed<4>(y), x + y));
    REQUIRE(agrees(fixed<4>(x) - fixed<4>(y), x - y));
    REQUIRE(agrees(fixed<4>(x) * fixed<4>(y), x * y));
    REQUIRE((fixed<4>(x) - fixed<4>(y)).certain_sign() == (x > y ? 1 : x < y ? -1 : 0));
    REQUIRE((fixed<4>(x) * fixed<4>(y) - fixed<4>(x * y + 0x1p-23)).certain_sign() ==
            -1);  // agrees() can fail
  }
}

TEST_CASE("the reciprocal is within one unit of the last place below", "[exam]") {
  const auto third = FixedPoint<4>::reciprocal(FixedPoint<4>::from(3.0));
  CHECK(third.error_bound() == 1.0);
  const auto rest = FixedPoint<4>::one() - third * FixedPoint<4>::from(3.0);
  CHECK(rest.certain_sign() == 0);  // 2^-192 is less than its bound of about 4 units
  const auto far = FixedPoint<4>::from(std::ldexp(1.0, -188));
  CHECK((far - rest).certain_sign() == 1);
  CHECK((rest + far).certain_sign() == 1);
  CHECK(FixedPoint<4>::reciprocal(third).certain_sign() == 0);  // refused: not stored exactly
}

TEST_CASE("bits that do not fit are counted as error", "[exam]") {
  CHECK(FixedPoint<2>::from(0x1p-64).error_bound() == 0.0);
  CHECK(FixedPoint<2>::from(0x1p-65).error_bound() == 1.0);
  CHECK(FixedPoint<2>::from(0x1p-65).certain_sign() == 0);
  CHECK(FixedPoint<2>::from(1.0 + 0x1p-52).error_bound() == 0.0);
}

TEST_CASE("after an overflow nothing is certain", "[exam]") {
  const auto large = FixedPoint<2>::from(0x1p62);
  CHECK(large.certain_sign() == 1);
  CHECK((large * large).certain_sign() == 0);
  CHECK((large * large).error_bound() == std::numeric_limits<double>::infinity());
  auto sum = large;
  for (int i = 0; i < 4; ++i) {
    sum = sum + large;
  }
  CHECK(sum.certain_sign() == 0);
  CHECK((sum * FixedPoint<2>()).certain_sign() == 0);
}

TEST_CASE("few words leave open what many decide, and never decide otherwise", "[check]") {
  testing::Generator generator(5);
  int open = 0;
  for (int i = 0; i < 2000; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-12, 0.9);
    const double h = 2 * std::atan(std::sqrt(alpha / (2 + alpha)));
    const auto m = static_cast<std::uint64_t>(
        testing::whole(generator, 1, static_cast<std::int64_t>(6.2 / h)));
    const int many = sign_of_sine<16>(m, alpha);
    REQUIRE(many != 0);
    for (const int few : {sign_of_sine<2>(m, alpha), sign_of_sine<3>(m, alpha)}) {
      REQUIRE((few == 0 || few == many));
      open += few == 0 ? 1 : 0;
    }
    if (std::fabs(std::sin(static_cast<double>(m) * h)) > 1e-3) {
      REQUIRE(many == (std::sin(static_cast<double>(m) * h) > 0 ? 1 : -1));
    }
  }
  CHECK(open > 100);
}

TEST_CASE("the closest doubles to a threshold need more than 128 bits and less than 512",
          "[exam]") {
  // 2 * 539 + 1 and 2 * (19530 + 1) steps of h reach pi within a hair.
  for (const auto& [m, alpha] : {std::pair{std::uint64_t{1079}, 0x1.1c7397cb68b7ep-18},
                                 std::pair{std::uint64_t{39062}, 0x1.bc7fb47556f22p-29}}) {
    CHECK(sign_of_sine<2>(m, alpha) == 0);
    CHECK(sign_of_sine<8>(m, alpha) != 0);
    CHECK(sign_of_sine<8>(m, alpha) == sign_of_sine<16>(m, alpha));
    CHECK(sign_of_sine<8>(m, alpha) == sign_of_sine<32>(m, alpha));
  }
}

TEST_CASE("an exact zero is never given a sign", "[exam]") {
  CHECK(sign_of_sine<8>(3, 1.0) == 0);  // h = pi/3
  CHECK(sign_of_sine<32>(3, 1.0) == 0);
}
