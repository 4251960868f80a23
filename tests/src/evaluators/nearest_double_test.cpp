// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/evaluators/nearest_double.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

#include "evaluators/exact_words.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using cln::cl_RA;

namespace {

/// A number near a double or half way between two, in three words, with a bound.
Multiword<3> near_a_boundary(Generator& generator) {
  const int exponent = static_cast<int>(
      whole(generator, 0, 2) == 0 ? whole(generator, -1140, -1050) : whole(generator, -1140, 1020));
  const std::int64_t kind = whole(generator, 0, 3);
  const std::uint64_t whole_part =
      kind == 0 ? std::uint64_t{1} << 53U : (std::uint64_t{1} << 53U) | (generator() >> 11U);
  const Multiword<3> centre = multiword<3>(whole_part, exponent, whole(generator, 0, 1) == 1);
  const Multiword<3> aside = multiword<3>(
      generator() >> static_cast<unsigned>(whole(generator, 1, 63)),
      exponent - static_cast<int>(whole(generator, 20, 110)), whole(generator, 0, 1) == 1);
  Multiword<3> x = kind == 1 ? centre : centre + aside;
  if (kind != 1) {
    x.error = log_uniform(generator, 1e-3, 1e30);
  }
  return x;
}

}  // namespace

TEST_CASE("a rounding said to be certain is that of every number within the bound", "[check]") {
  Generator generator(51);
  int certain = 0;
  int open = 0;
  int too_wide = 0;
  for (int i = 0; i < 20000; ++i) {
    Multiword<3> x = near_a_boundary(generator);
    const cl_RA low = stored(x) - bound(x);
    const cl_RA high = stored(x) + bound(x);
    const auto got = nearest_double(x);
    const auto from_low = reference::nearest<double>(low);
    const auto from_high = reference::nearest<double>(high);
    if (got) {
      REQUIRE(*got == from_low);
      REQUIRE(*got == from_high);
      ++certain;
    } else {
      open += from_low != from_high ? 1 : 0;
    }
    // with the bound taken for less than it is, some answers are not those of all numbers in it
    x.error /= 1024;
    const auto rash = nearest_double(x);
    too_wide += rash && (*rash != from_low || *rash != from_high) ? 1 : 0;
  }
  CHECK(certain > 5000);
  CHECK(open > 1000);
  CHECK(too_wide > 100);
}

TEST_CASE("ties go to even, subnormals and the largest are rounded as they are spaced", "[exam]") {
  const auto nearest = [](std::uint64_t magnitude, int exponent) {
    return nearest_double(multiword<2>(magnitude, exponent)).value();
  };
  const std::uint64_t two_53 = std::uint64_t{1} << 53U;
  CHECK(nearest(two_53 + 1, 0) == 0x1p53);
  CHECK(nearest(two_53 + 3, 0) == 0x1p53 + 4);
  CHECK(nearest(5, -1075) == 0x1p-1073);
  CHECK(nearest(7, -1075) == 0x1p-1072);
  CHECK(nearest(2 * two_53 - 1, -1075 - 1) == std::numeric_limits<double>::min());
  CHECK(nearest(two_53 - 1, 1023 - 52) == std::numeric_limits<double>::max());
  CHECK(std::isinf(nearest(2 * two_53 - 1, 1023 - 53)));
  CHECK(nearest_double(Multiword<2>()) == 0.0);
  CHECK(nearest(1, -1075) == 0.0);
  CHECK(nearest(3, -1076) == 0x1p-1074);
  for (int exponent = -1200; exponent < -1074; ++exponent) {
    CHECK(nearest(1, exponent) == 0.0);
  }
  CHECK(std::signbit(nearest_double(multiword<2>(1, -1076, true)).value()));
  auto open = multiword<2>(1, -1200);
  open.error = 1e40;  // it may as well be negative
  CHECK_FALSE(nearest_double(open).has_value());
}

TEST_CASE("a multiple of a grid is known exactly once the bound is below half of it", "[check]") {
  Generator generator(52);
  for (int i = 0; i < 5000; ++i) {
    const int grid = static_cast<int>(whole(generator, -70, 100));
    const auto exact = multiword<3>(generator() >> static_cast<unsigned>(whole(generator, 1, 60)),
                                    -grid, whole(generator, 0, 1) == 1);
    Multiword<3> x = exact;
    const auto off = multiword<3>(1, -grid - static_cast<int>(whole(generator, 2, 30)),
                                  whole(generator, 0, 1) == 1);
    x = x + off;
    const cl_RA error = bound(x) + cln::abs(stored(off));
    x.error = reference::nearest<double>(error / unit(x)) * 1.01;
    const auto snapped = on_grid(x, grid);
    REQUIRE(holds(snapped, stored(exact)));
    if (stored(x) - bound(x) > stored(exact) - power_of_two(-grid - 1) && snapped.error == 0) {
      REQUIRE(stored(snapped) == stored(exact));
    }
    x.error = reference::nearest<double>(power_of_two(-grid) / unit(x));
    REQUIRE(on_grid(x, grid).error == x.error);
  }
}
