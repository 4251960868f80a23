// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/evaluators/multiword.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

#include "evaluators/exact_words.hpp"
#include "magicmass/evaluators/multiword_division.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using cln::cl_RA;

namespace {

template <std::size_t Words>
bool is_normal(const Multiword<Words>& x) {
  return x.top() != 0 || stored(x) == 0;
}

/// Every operation on operands that stand for numbers anywhere within their bounds: how often the result's bound,
/// made smaller by a factor, does not hold the true result.
template <std::size_t Words>
int broken_bounds(double factor) {
  Generator generator(31 + Words);
  int broken = 0;
  const auto expect = [&](Multiword<Words> got, const cl_RA& expected) {
    REQUIRE(is_normal(got));
    got.error *= static_cast<typename Multiword<Words>::Bound>(factor);
    broken += std::isfinite(got.error) && !holds(got, expected) ? 1 : 0;
  };
  for (int i = 0; i < 1500; ++i) {
    const auto x = random_multiword<Words>(generator, 2);
    const auto y = random_multiword<Words>(generator, 2);
    const cl_RA true_x = possible(generator, x);
    const cl_RA true_y = possible(generator, y);
    expect(x + y, true_x + true_y);
    expect(x - y, true_x - true_y);
    expect(x * y, true_x * true_y);
    expect(x / y, true_y == 0 ? cl_RA(0) : true_x / true_y);
    const std::int64_t factor_of_x = whole(generator, -1000000, 1000000);
    expect(times(x, factor_of_x), true_x * cln::cl_I(static_cast<long>(factor_of_x)));
    const std::int64_t divisor = whole(generator, 1, 1000000);
    expect(over(x, static_cast<std::uint32_t>(divisor)),
           true_x / cln::cl_I(static_cast<long>(divisor)));
  }
  return broken;
}

/// Both bounds of stored magnitudes hold and are as near as their rounding lets them.
template <std::size_t Words>
void sizes_enclose() {
  Generator generator(47 + Words);
  // neighbours in memory, of all zeros and all ones among others
  std::array<Multiword<Words>, 300> numbers;
  for (auto& x : numbers) x = random_multiword<Words>(generator, 2);
  for (const auto& x : numbers) {
    const cl_RA size = cln::abs(stored(x)) * power_of_two(-64 * x.exponent);
    const cl_RA above = reference::exact(size_above(x));
    const cl_RA below = reference::exact(size_below(x));
    CHECK(below <= size);
    CHECK(size <= above);
    CHECK(above - below <= size * power_of_two(-48) + power_of_two(-127));
  }
  CHECK(size_above(Multiword<Words>()) == 0);
  CHECK(size_below(Multiword<Words>()) == 0);
}

}  // namespace

TEST_CASE("the size of what is stored is bounded from above and below", "[check]") {
  sizes_enclose<2>();
  sizes_enclose<3>();
  sizes_enclose<4>();
  sizes_enclose<8>();
}

TEST_CASE("the bound holds the true result of every operation", "[check]") {
  CHECK(broken_bounds<2>(1.0) == 0);
  CHECK(broken_bounds<3>(1.0) == 0);
  CHECK(broken_bounds<4>(1.0) == 0);
  CHECK(broken_bounds<8>(1.0) == 0);
  CHECK(broken_bounds<24>(1.0) == 0);
}

TEST_CASE("a bound a tenth too small would be seen", "[check]") {
  CHECK(broken_bounds<2>(0.9) > 100);
  CHECK(broken_bounds<4>(0.9) > 100);
}

TEST_CASE("what is exact is known to be, and what is cut off is not", "[exam]") {
  const auto x = multiword<4>(12345, 3);
  const auto y = multiword<4>(77, -60, true);
  CHECK((x + y).error == 0);
  CHECK((x - y).error == 0);
  CHECK((x * y).error == 0);
  CHECK(stored(x + y) == stored(x) + stored(y));
  CHECK(stored(x * y) == stored(x) * stored(y));
  CHECK((x * y / y).error == 0);
  CHECK(stored(x * y / y) == stored(x));
  CHECK((x - x).is_exact_zero());
  CHECK((multiword<4>(1) / multiword<4>(3)).error >= 1);
  CHECK((multiword<4>(1) + multiword<4>(1, -256)).error >= 1);
  CHECK((multiword<4>(1) + multiword<4>(1, -192)).error == 0);
  CHECK(over(multiword<4>(6), 3).error == 0);
  CHECK(over(multiword<4>(7), 3).error >= 1);
  CHECK(times(multiword<2>(1), 0).is_exact_zero());
}

TEST_CASE("a whole factor or divisor scales the bound, and adds one unit at most", "[exam]") {
  auto x = multiword<4>(77, 40);
  x.error = 1e6;
  CHECK(times(x, -1000).error == Approx(1e9).margin(1.001));
  CHECK(over(x, 1000).error == Approx(1e3).margin(1.001));
}

TEST_CASE("division refuses what may be zero", "[exam]") {
  auto small = multiword<4>(1, -300);
  small.error = 1e65;  // the stored number is 2^212 units
  CHECK(std::isinf((multiword<4>(1) / small).error));
  CHECK(std::isinf((multiword<4>(1) / Multiword<4>()).error));
  CHECK_FALSE(std::isinf((multiword<4>(1) / multiword<4>(1, -300)).error));
}

TEST_CASE("quotient words that are guessed one too large are put right", "[exam]") {
  // divisors and dividends of ones and zeros make the guesses fail
  constexpr std::uint64_t ones = ~std::uint64_t{0};
  constexpr std::uint64_t half = std::uint64_t{1} << 63U;
  for (const Multiword<3>::Magnitude& above : {Multiword<3>::Magnitude{0, 0, half},
                                               {ones, ones, half - 1},
                                               {0, ones, half},
                                               {3, 0, half}}) {
    for (const Multiword<3>::Magnitude& below : {Multiword<3>::Magnitude{ones, 0, half},
                                                 {1, 0, half},
                                                 {ones, ones, half},
                                                 {ones, ones, ones}}) {
      const Multiword<3> x{above, 0, false, 0};
      const Multiword<3> y{below, 0, false, 0};
      const Multiword<3> q = x / y;
      CHECK(holds(q, stored(x) / stored(y)));
      CHECK(q.error < 1.001);
    }
  }
}
