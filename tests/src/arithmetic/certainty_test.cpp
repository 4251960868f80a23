// SPDX-License-Identifier: GPL-2.0-or-later
// A rounding said to be certain is that of every number in the enclosure: near ties, where doubles begin to be spaced
// otherwise, and with enclosures of every width. Blocks keep the same of many numbers.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "arithmetic/every_width.hpp"
#include "arithmetic/operands.hpp"
#include "magicmass/arithmetic/block.hpp"
#include "magicmass/reference/rational.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using cln::cl_RA;
using reference::exact;

namespace {

using Tracked = arithmetic::Tracked<double>;

/// A pair next to half way between two doubles, or next to a double, and a width of about the distance.
struct NearTie {
  double high, low, width;
};
NearTie near_tie(Generator& generator) {
  NearTie y{};
  y.high = whole(generator, 0, 4) == 0
               ? std::ldexp(1.0, static_cast<int>(whole(generator, -300, 300)))
               : any_double(generator, -300, 300);
  const double half_ulp = std::ldexp(1.0, std::ilogb(y.high) - 53);
  const double distance = half_ulp * std::fabs(any_double(generator, -50, -1));
  const double ties[] = {half_ulp, -half_ulp, half_ulp / 2, -half_ulp / 2, 0.0};
  y.low = ties[whole(generator, 0, 4)] + (whole(generator, 0, 1) == 0 ? distance : -distance);
  y.width = distance * std::ldexp(1.0, static_cast<int>(whole(generator, -2, 2)));
  if (whole(generator, 0, 3) == 0) y.width = distance;
  return y;
}

struct Found {
  int certain = 0, open = 0, rash = 0;
};

/// `width` of the enclosure for which the third column of `in` is what the number type takes.
Found require_true(const char* name, const Columns& in, const std::vector<cl_RA>& width) {
  const auto out = the_same_at_every_width(name, in);
  Found found;
  for (std::size_t i = 0; i < width.size(); ++i) {
    const cl_RA centre = exact_pair(in, 0, i);
    const auto low = reference::nearest<double>(centre - width[i]);
    const auto high = reference::nearest<double>(centre + width[i]);
    INFO(in[0][i] << " + " << in[1][i] << ", " << in[2][i]);
    if (out[1][i] != 0.0) {
      REQUIRE((out[0][i] == low && out[0][i] == high));
      ++found.certain;
      // an enclosure 16 times as wide is not what was asked
      found.rash += reference::nearest<double>(centre - 16 * width[i]) != low ||
                            reference::nearest<double>(centre + 16 * width[i]) != high
                        ? 1
                        : 0;
    } else {
      found.open += low != high ? 1 : 0;
    }
  }
  return found;
}

void check_enough(const Found& found) {
  CHECK(found.certain > 3000);
  CHECK(found.open > 3000);
  CHECK(found.rash > 500);
}

}  // namespace

TEST_CASE("tracked numbers: a certain rounding is certain", "[check]") {
  Generator generator(51);
  Columns in;
  std::vector<cl_RA> width;
  // the highest degree, less the 2^-30 part that pairs' roundings may be
  const cl_RA margin = exact(Tracked::highest_degree * Tracked::unit) * (1 - power(-30));
  for (int i = 0; i < 20000; ++i) {
    const NearTie y = near_tie(generator);
    // a size is never less than the number's own
    const double size =
        std::max(y.width / (Tracked::highest_degree * Tracked::unit), std::fabs(y.high));
    append(in, {y.high, y.low, size});
    width.push_back(margin * exact(size));
  }
  for (const char* name : {"tracked_rounding", "fused_rounding"})
    check_enough(require_true(name, in, width));
}

TEST_CASE("nothing is certain of a sum of which little is left", "[check]") {
  // the high part cancelled to less than the low part, of numbers 2^40 of that or more
  Generator generator(53);
  Columns in;
  for (int i = 0; i < 5000; ++i) {
    const double low = any_double(generator, -200, 200);
    const double high = whole(generator, 0, 3) == 0 ? 0.0 : low * any_double(generator, -60, 0);
    append(in, {high, low,
                std::fabs(low) * std::ldexp(1.0, static_cast<int>(whole(generator, 40, 60)))});
  }
  for (const char* name : {"tracked_rounding", "fused_rounding"}) {
    const auto out = the_same_at_every_width(name, in);
    for (const double is_certain : out[1]) REQUIRE(is_certain == 0.0);
  }
}

TEST_CASE("bounded numbers: a certain rounding is certain", "[check]") {
  Generator generator(52);
  Columns in;
  std::vector<cl_RA> width;
  for (int i = 0; i < 20000; ++i) {
    const NearTie y = near_tie(generator);
    append(in, {y.high, y.low, y.width});
    width.push_back(exact(y.width));
  }
  check_enough(require_true("bounded_rounding", in, width));
}

TEST_CASE("nothing is certain of what has no bound or is no number", "[exam]") {
  const double nan = std::nan(""), infinity = HUGE_VAL;
  const Columns in{{1.5, 1.5, nan, 0.0}, {0.0, 0.0, 0.0, 0.0}, {infinity, nan, 1.0, infinity}};
  for (const char* name : {"tracked_rounding", "fused_rounding", "bounded_rounding"})
    CHECK(the_same_at_every_width(name, in)[1] == std::vector(4, 0.0));
}

TEST_CASE("a tie is never certain", "[exam]") {
  const Columns tie{{1.0, 3.0}, {0x1p-53, 0x1p-52}, {1.0, 3.0}};
  for (const char* name : {"tracked_rounding", "fused_rounding", "bounded_rounding"})
    CHECK(the_same_at_every_width(name, tie)[1] == std::vector(2, 0.0));
}

TEST_CASE("a block knows of each of its elements whether all results are certain", "[exam]") {
  using T = arithmetic::Lanes<2>;
  using Number = arithmetic::Tracked<T>;
  const auto numbers = std::make_unique<arithmetic::Block<Number>>();
  arithmetic::Certainty<Number> certain;
  double rounded[4] = {};
  // certain, certain, a tie, certain; then the second as unknown as can be
  const double high[] = {1.0, 3.0, 1.0, 5.0}, low[] = {0x1p-55, 0.0, 0x1p-53, 0x1.8p-52};
  for (std::size_t i = 0; i < 4; i += 2) {
    numbers->put(i, {{arithmetic::load<T>(high + i), arithmetic::load<T>(low + i)}, T(1.0)});
    certain.put(i, certain.store<8>(numbers->get(i), rounded, i));
  }
  CHECK((rounded[0] == 1.0 && rounded[1] == 3.0 && rounded[3] == 5.0));
  CHECK((certain.all[0] == -1 && certain.all[1] == -1 && certain.all[2] == 0));
  CHECK(certain.is_all(0, 2));
  CHECK_FALSE(certain.is_all(0, 3));
  CHECK_FALSE(certain.is_all(2, 3));
  // one result that is open is enough; one that is not wanted is not looked at
  const double huge[] = {1.0, HUGE_VAL};
  const Number unknown{{T(2.0), T(0.0)}, arithmetic::load<T>(huge)};
  auto known = certain.store<8>(unknown, rounded, 0);
  known &= certain.store<8>(Number{{T(2.0), T(0.0)}, T(1.0)}, rounded, 0);
  certain.put(0, known);
  CHECK((certain.all[0] == -1 && certain.all[1] == 0));
  certain.put(0, certain.store<8>(unknown, nullptr, 0));
  CHECK((certain.all[0] == -1 && certain.all[1] == -1));
  // further from a tie than a number of degree 1 may be off, and not as far as one of degree 2
  const double next_to_a_tie = 0x1p-53 - 1.5 * Number::unit;
  const Number close{{T(1.0), T(next_to_a_tie)}, T(1.0)};
  certain.put(0, certain.store<1>(close, rounded, 0));
  CHECK(certain.all[0] == -1);
  certain.put(0, certain.store<2>(close, rounded, 0));
  CHECK(certain.all[0] == 0);
  // of -2 x y the nearest double is -2 times that of x y, and as certain; nor is it looked at where it is not wanted
  const Number three{{T(3.0), T(0.0)}, T(3.0)};
  // 3/4 and 9/16 of an ulp above 3 and 15
  const arithmetic::Product<Number> product{numbers->get(2), three, -2.0};
  certain.put(0, certain.store<8>(product, rounded, 0));
  CHECK((certain.all[0] == -1 && rounded[0] == -6.0 - 0x1p-50));
  CHECK((certain.all[1] == -1 && rounded[1] == -30.0 - 0x1p-48));
  const arithmetic::Product<Number> tie{numbers->get(2), Number{{T(1.0), T(0.0)}, T(1.0)}, -2.0};
  certain.put(0, certain.store<8>(tie, rounded, 0));
  CHECK((certain.all[0] == 0 && rounded[1] == -10.0));
  certain.put(0, certain.store<8>(tie, nullptr, 0));
  CHECK(certain.all[0] == -1);
}
