// SPDX-License-Identifier: GPL-2.0-or-later
// Sums and products with their error, against rational numbers.
#include <algorithm>
#include <cmath>
#include <utility>

#include <catch2/catch.hpp>

#include "arithmetic/every_width.hpp"
#include "magicmass/reference/rational.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using reference::exact;

namespace {

/// Pairs of numbers of like size, far apart, nearly opposite, equal, or one of them 0.
Columns addends(std::uint64_t seed, int low, int high) {
  Generator generator(seed);
  Columns in(2);
  for (int i = 0; i < 4000; ++i) {
    const double x = any_double(generator, low, high);
    const int exponent = std::ilogb(x);
    double y = any_double(generator, std::max(low, exponent - 110), std::min(high, exponent + 110));
    const auto kind = whole(generator, 0, 9);
    if (kind == 0) y = -std::nextafter(x, 0.0);
    if (kind == 1) y = -x * (1 + 0x1p-30);
    if (kind == 2) y = x;
    if (kind == 3) y = std::ldexp(x, -53);
    if (kind == 4) y = 0.0;
    in[0].push_back(kind == 5 ? 0.0 : x);
    in[1].push_back(y);
  }
  return in;
}

Columns by_size(Columns in) {
  for (std::size_t i = 0; i < in[0].size(); ++i)
    if (std::fabs(in[0][i]) < std::fabs(in[1][i])) std::swap(in[0][i], in[1][i]);
  return in;
}

template <class Truth>
void require_exact(const char* name, const Columns& in, const Truth& truth) {
  const auto out = the_same_at_every_width(name, in);
  std::size_t inexact = 0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cln::cl_RA value = truth(exact(in[0][i]), exact(in[1][i]));
    INFO(name << " of " << in[0][i] << " and " << in[1][i]);
    REQUIRE(exact_pair(out, 0, i) == value);
    REQUIRE(out[0][i] == reference::nearest<double>(value));
    inexact += exact(out[0][i]) == value ? 0 : 1;
  }
  CHECK(inexact > in[0].size() / 4);  // without the second part most would be wrong
}

const auto sum = [](const cln::cl_RA& x, const cln::cl_RA& y) { return x + y; };
const auto difference = [](const cln::cl_RA& x, const cln::cl_RA& y) { return x - y; };
const auto product = [](const cln::cl_RA& x, const cln::cl_RA& y) { return x * y; };

}  // namespace

TEST_CASE("a sum and its error are exact whatever the operands, subnormal ones too", "[check]") {
  for (const auto& [low, high] : {std::pair(-1000, 1000), std::pair(-1074 + 53, -900)}) {
    require_exact("two_sum", addends(11, low, high), sum);
    require_exact("two_difference", addends(12, low, high), difference);
  }
}

TEST_CASE("a sum of ordered operands and its error are exact", "[check]") {
  require_exact("ordered_sum", by_size(addends(13, -1000, 1000)), sum);
  require_exact("ordered_difference", by_size(addends(14, -1000, 1000)), difference);
  const auto zero = the_same_at_every_width("ordered_sum", {{0.0, 0.0}, {0.3, -1e300}});
  CHECK((zero[0] == std::vector{0.3, -1e300} && zero[1] == std::vector{0.0, 0.0}));
}

TEST_CASE("a product and its error are exact from 2^-968 to 2^996", "[check]") {
  Generator generator(15);
  Columns in(2);
  for (int i = 0; i < 6000; ++i) {
    const double x = any_double(generator, -960, 990);
    // of y's exponents those that keep the product in its range, its ends often
    const int from = std::max(-1020, -968 - std::ilogb(x)), to = std::min(990, 994 - std::ilogb(x));
    const auto kind = whole(generator, 0, 5);
    in[0].push_back(x);
    in[1].push_back(
        any_double(generator, kind == 0 ? to : from, kind == 1 ? from : std::max(from, to)));
  }
  require_exact("two_product", in, product);
}

TEST_CASE("1 - x y is rounded once where x y is near 1", "[check]") {
  Generator generator(16);
  Columns in(2);
  for (int i = 0; i < 6000; ++i) {
    const double x = any_double(generator, -400, 400);
    double y = 1.0 / x;
    const auto kind = whole(generator, 0, 3);
    if (kind == 1) y *= 1 + any_double(generator, -51, -21);
    if (kind == 2 && std::fabs(std::log2(std::fabs(x))) < 120) y = static_cast<float>(y);
    if (kind == 3) y = std::nextafter(y, HUGE_VAL);
    in[0].push_back(x);
    in[1].push_back(y);
  }
  const auto out = the_same_at_every_width("one_minus_product", in)[0];
  for (std::size_t i = 0; i < out.size(); ++i) {
    INFO(in[0][i] << ", " << in[1][i]);
    REQUIRE(out[i] == reference::nearest<double>(1 - exact(in[0][i]) * exact(in[1][i])));
  }
}
