// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/evaluators/near_integer.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include <catch2/catch.hpp>

#include "evaluators/exact_words.hpp"
#include "magicmass/cosine_ladder.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using cln::cl_RA;

namespace {

/// An integer, most often a small one, and a rest.
template <std::size_t Words>
NearInteger<Words> random_number(Generator& generator) {
  const std::int64_t most = whole(generator, 0, 1) == 0 ? 2 : std::int64_t{1} << 29U;
  Multiword<Words> rest = random_multiword<Words>(generator, 2);
  if (whole(generator, 0, 9) == 0) {
    rest = {};
  }
  return {whole(generator, -most, most), rest};
}

template <std::size_t Words>
cl_RA possible(Generator& generator, const NearInteger<Words>& x) {
  return cln::cl_I(static_cast<long>(x.whole)) + testing::possible(generator, x.rest);
}

template <std::size_t Words>
bool is_settled(const NearInteger<Words>& x) {
  return x.whole == 0 || (std::abs(x.whole) <= (std::int64_t{1} << 30U) &&
                          cln::abs(stored(x.rest)) <= cl_RA(1) / 2);
}

/// sin(m h) sin h.
template <std::size_t Words>
NearInteger<Words> sine(std::uint64_t m, double alpha) {
  using Number = NearInteger<Words>;
  const Number x = Number(1) / (Number(1) + Number(alpha));
  return generated::sine_ladder(m, x, Number(1));
}

}  // namespace

TEST_CASE("the field's operations hold the true result", "[check]") {
  Generator generator(41);
  for (int i = 0; i < 3000; ++i) {
    const auto x = random_number<3>(generator);
    const auto y = random_number<3>(generator);
    const cl_RA true_x = possible(generator, x);
    const cl_RA true_y = possible(generator, y);
    for (const auto& [got, expected] :
         {std::pair{x + y, true_x + true_y}, std::pair{x - y, true_x - true_y},
          std::pair{x * y, true_x * true_y}, std::pair{-x, -true_x}}) {
      REQUIRE(is_settled(got));
      REQUIRE(holds(got, expected));
    }
    const auto quotient = x / y;
    REQUIRE((!std::isfinite(quotient.rest.error) || holds(quotient, true_x / true_y)));
    REQUIRE((x.together().error > 0 || holds(x.together(), true_x)));
  }
}

TEST_CASE("integers and doubles are stored exactly", "[exam]") {
  CHECK(NearInteger<4>(7).whole == 7);
  CHECK(NearInteger<4>(-7).whole == -7);
  CHECK(NearInteger<4>(0.75).whole == 1);
  for (const std::int64_t k :
       {std::int64_t{0}, std::int64_t{1} << 40U, std::numeric_limits<std::int64_t>::max(),
        std::numeric_limits<std::int64_t>::min()}) {
    CHECK(stored(NearInteger<4>(k)) == cln::cl_I(static_cast<long>(k)));
  }
  for (const double x : {0.3, -0.3, 1e300, -1e-300, 5e-324, 1e9 + 0.5}) {
    CHECK(stored(NearInteger<4>(x)) == reference::exact(x));
    CHECK(NearInteger<4>(x).rest.error == 0);
  }
}

TEST_CASE("every double is stored exactly", "[check]") {
  Generator generator(32);
  for (int i = 0; i < 2000; ++i) {
    const double x = std::ldexp(log_uniform(generator, 0.5, 1.0),
                                static_cast<int>(whole(generator, -1080, 1024)));
    REQUIRE(from_double<2>(x).error == 0);
    REQUIRE(stored(from_double<2>(x)) == reference::exact(x));
    REQUIRE(stored(from_double<3>(-x)) == reference::exact(-x));
  }
  CHECK(stored(from_double<2>(std::numeric_limits<double>::denorm_min())) == power_of_two(-1074));
  CHECK(stored(from_double<2>(std::numeric_limits<double>::max())) ==
        reference::exact(std::numeric_limits<double>::max()));
}

TEST_CASE("four words keep the smallest alpha", "[exam]") {
  const double alpha = std::numeric_limits<double>::denorm_min();
  const NearInteger<4> x = NearInteger<4>(1) / (NearInteger<4>(1) + NearInteger<4>(alpha));
  CHECK(x.whole == 1);
  CHECK(holds(x, cl_RA(1) / (1 + reference::exact(alpha))));
  CHECK((NearInteger<4>(1) - x).certain_sign() == 1);
}

TEST_CASE("few words leave a sign open that many decide, and never decide otherwise", "[check]") {
  Generator generator(42);
  int open = 0;
  for (int i = 0; i < 2000; ++i) {
    const double alpha = log_uniform(generator, 1e-12, 0.9);
    const double h = 2 * std::atan(std::sqrt(alpha / (2 + alpha)));
    const auto m =
        static_cast<std::uint64_t>(whole(generator, 1, static_cast<std::int64_t>(6.2 / h)));
    const int many = sine<16>(m, alpha).certain_sign();
    REQUIRE(many != 0);
    REQUIRE(sine<4>(m, alpha).certain_sign() == many);
    // less is known about it than two words hold
    NearInteger<2> few = sine<2>(m, alpha);
    few.rest.error *= 0x1p54;
    REQUIRE((few.certain_sign() == 0 || few.certain_sign() == many));
    open += few.certain_sign() == 0 ? 1 : 0;
    if (std::fabs(std::sin(static_cast<double>(m) * h)) > 1e-3) {
      REQUIRE(many == (std::sin(static_cast<double>(m) * h) > 0 ? 1 : -1));
    }
  }
  CHECK(open > 100);
}

TEST_CASE("an exact zero is never given a sign, nor what overflowed", "[exam]") {
  CHECK(sine<8>(3, 1.0).certain_sign() == 0);  // h = pi/3
  CHECK(sine<8>(3, 1.0).together().is_exact_zero());
  NearInteger<2> x(3.0);
  x.rest.error = std::numeric_limits<double>::infinity();
  CHECK(x.certain_sign() == 0);
  CHECK((x * NearInteger<2>(0.0) + x).certain_sign() == 0);
  CHECK((x - x).certain_sign() == 0);
}
