// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/evaluators/multiword_functions.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <catch2/catch.hpp>
#include <cln/float.h>
#include <cln/real.h>

#include "evaluators/exact_words.hpp"
#include "magicmass/evaluators/multiword_pi.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using cln::cl_F;
using cln::cl_RA;

namespace {

constexpr unsigned long digits = 700;

cl_F as_float(const cl_RA& x) { return cln::cl_float(x, cln::float_format(digits)); }

/// |stored - function(x)| is within the bound, made smaller by a factor; x is the true argument.
template <std::size_t Words, class Function>
bool holds_value(const Multiword<Words>& got, const Function& function, const cl_RA& x,
                 double factor) {
  const cl_RA exact = cln::rational(function(as_float(x)));
  const cl_RA slack = cln::abs(exact) / cln::expt_pos(cln::cl_I(2), cln::cl_I(2200));
  return cln::abs(stored(got) - exact) <= bound(got) * reference::exact(factor) + slack;
}

/// How many bounds, made smaller by a factor, do not hold, and the largest relative bound.
template <std::size_t Words>
std::pair<int, double> broken_function_bounds(double factor) {
  Generator generator(81 + Words);
  int broken = 0;
  double widest = 0;
  for (int i = 0; i < 60; ++i) {
    auto x = from_double<Words>(log_uniform(generator, i % 3 == 0 ? 1e-160 : 1e-3, 1.2));
    x = x + multiword<Words>(generator(), -200);
    if (i % 2 == 0) x.error += 3;
    const cl_RA true_x = possible(generator, x);
    const auto expect = [&](const Multiword<Words>& got, const auto& function) {
      broken += holds_value(got, function, true_x, factor) ? 0 : 1;
      widest = std::max(
          widest,
          static_cast<double>(got.error * words_down<typename Multiword<Words>::Bound>(Words)) /
              size_below(got));
    };
    expect(sine(x), [](const cl_F& y) { return cln::sin(y); });
    expect(cosine_less_one(x), [](const cl_F& y) {
      const cl_F half = cln::sin(y / 2);
      return -2 * half * half;
    });
    expect(square_root(x), [](const cl_F& y) { return cln::cl_float(cln::sqrt(y), y); });
    expect(arctangent(x), [](const cl_F& y) { return cln::cl_float(cln::atan(y), y); });
  }
  return {broken, widest};
}

}  // namespace

TEST_CASE("the functions' bounds hold the true values, and are narrow", "[check]") {
  const auto two = broken_function_bounds<2>(1.0);
  const auto four = broken_function_bounds<4>(1.0);
  const auto ten = broken_function_bounds<10>(1.0);
  const auto most = broken_function_bounds<24>(1.0);
  CHECK(two.first == 0);
  CHECK(four.first == 0);
  CHECK(ten.first == 0);
  CHECK(most.first == 0);
  // a word, the top one, may hold a single bit
  CHECK(two.second < 0x1p-50);
  CHECK(four.second < 0x1p-178);
  CHECK(ten.second < 0x1p-560);
}

TEST_CASE("bounds a thousand times too small would be seen", "[check]") {
  CHECK(broken_function_bounds<4>(0.001).first > 20);
}

TEST_CASE("where a function has no certain value there is none", "[exam]") {
  CHECK(std::isinf(square_root(multiword<4>(2, 0, true)).error));
  CHECK(std::isinf(sine(multiword<4>(2)).error));
  CHECK(std::isinf(cosine_less_one(multiword<4>(5)).error));
  auto open = multiword<4>(1, -300);
  open.error = 1e70;
  CHECK(std::isinf(square_root(open).error));
  CHECK(square_root(multiword<4>(9)).error == 0);
  CHECK(stored(square_root(multiword<4>(9, -100))) == 3 * power_of_two(-50));
  CHECK(square_root(Multiword<4>()).is_exact_zero());
  CHECK(arctangent(Multiword<4>()).is_exact_zero());
  CHECK(sine(Multiword<4>()).is_exact_zero());
}

TEST_CASE("pi in words is pi", "[exam]") {
  const cl_RA pi = cln::rational(cln::pi(cln::float_format(digits)));
  CHECK(holds(std::numbers::pi_v<NearInteger<2>>, pi));
  CHECK(holds(std::numbers::pi_v<NearInteger<4>>, pi));
  CHECK(holds(std::numbers::pi_v<NearInteger<24>>, pi));
  CHECK_FALSE(holds(std::numbers::pi_v<NearInteger<4>>, pi + power_of_two(-253)));
}
