// SPDX-License-Identifier: GPL-2.0-or-later
// Pairs within their stated bounds, against rational numbers.
#include <algorithm>
#include <cmath>
#include <utility>

#include <catch2/catch.hpp>

#include "arithmetic/every_width.hpp"
#include "arithmetic/operands.hpp"
#include "magicmass/reference/rational.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using cln::cl_RA;
using reference::exact;

namespace {

Columns pairs(std::uint64_t seed, int low, int high) {
  Generator generator(seed);
  Columns in;
  for (int i = 0; i < 5000; ++i) {
    const TwoPairs two = two_pairs(generator, low, high);
    append(in, {two.x, two.x_low, two.y, two.y_low});
  }
  return in;
}

/// The largest error over `size`, which has to be at most 2^exponent; error and size come from the row's numbers.
template <class Truth, class Size>
void require_within(const char* name, const Columns& in, int exponent, const Truth& truth,
                    const Size& size) {
  const auto out = the_same_at_every_width(name, in);
  cl_RA worst = 0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA x = exact_pair(in, 0, i);
    const cl_RA y = in.size() == 4   ? exact_pair(in, 2, i)
                    : in.size() == 3 ? exact(in[2][i])
                                     : cl_RA(0);
    const cl_RA value = truth(x, y);
    const cl_RA error = cln::abs(exact_pair(out, 0, i) - value);
    INFO(name << " of " << in[0][i] << " and " << in.back()[i]);
    REQUIRE(error <= power(exponent) * size(x, y, value));
    if (size(x, y, value) != 0) worst = std::max(worst, cl_RA(error / size(x, y, value)));
  }
  CHECK(worst > power(exponent - 6));  // the bound says something
}

const auto result_size = [](const cl_RA&, const cl_RA&, const cl_RA& z) { return cln::abs(z); };
const auto operand_size = [](const cl_RA& x, const cl_RA& y, const cl_RA&) {
  return cln::abs(x) + cln::abs(y);
};

Columns without_last(Columns in) {
  in.pop_back();
  return in;
}

}  // namespace

TEST_CASE("sums of pairs are within 2^-103 of their operands, however much cancels", "[check]") {
  const auto sum = [](const cl_RA& x, const cl_RA& y) { return x + y; };
  require_within("pair_sum", pairs(21, -300, 300), -103, sum, operand_size);
  require_within(
      "pair_difference", pairs(22, -300, 300), -103,
      [](const cl_RA& x, const cl_RA& y) { return x - y; }, operand_size);
  require_within("pair_plus_number", without_last(pairs(23, -300, 300)), -103, sum, operand_size);
}

TEST_CASE("products, quotients and reciprocals of pairs are within 2^-100 of themselves",
          "[check]") {
  const auto product = [](const cl_RA& x, const cl_RA& y) { return x * y; };
  require_within("pair_product", pairs(24, -480, 490), -100, product, result_size);
  require_within("pair_times_number", without_last(pairs(25, -480, 490)), -100, product,
                 result_size);
  require_within(
      "pair_quotient", pairs(26, -300, 300), -100,
      [](const cl_RA& x, const cl_RA& y) { return x / y; }, result_size);
  Columns one = pairs(27, -800, 800);
  one.resize(2);
  require_within(
      "pair_reciprocal", one, -100, [](const cl_RA& x, const cl_RA&) { return cln::recip(x); },
      result_size);
}

TEST_CASE("reciprocal roots of pairs are within 2^-66 in lanes and 2^-100 of single doubles",
          "[check]") {
  Generator generator(28);
  Columns in;
  for (int i = 0; i < 4000; ++i) {
    const double w = std::fabs(any_double(generator, -120, 119));
    append(in, {w, any_low(generator, w)});
  }
  append(in, {0x1p120, 0.0});
  append(in, {0x1p-120, 0.0});
  // y off by e makes y^2 w off from 1 by 2 e
  const auto worst = [](const Columns& given, const Columns& roots) {
    cl_RA most = 0;
    for (std::size_t i = 0; i < given[0].size(); ++i) {
      const cl_RA root = exact_pair(roots, 0, i);
      most = std::max(most, cl_RA(cln::abs(root * root * exact_pair(given, 0, i) - 1) / 2));
    }
    return most;
  };
  const Results out = at_every_width("pair_root", in);
  CHECK(worst(in, out.lanes) <= power(-66));
  CHECK(worst(in, out.lanes) > power(-72));
  CHECK(worst(in, out.single) <= power(-100));
  Columns far;
  for (int i = 0; i < 2000; ++i) {
    const double w = std::fabs(any_double(generator, -1074, 1023));
    append(far, {w, std::ilogb(w) < -900 ? 0.0 : any_low(generator, w)});
  }
  for (const double w : {5e-324, 0x1p-1022, 0x1p-900, 0x1p900, 0x1.fffffffffffffp1023})
    append(far, {w, 0.0});
  CHECK(worst(far, of_single_doubles("pair_root", far)) <= power(-100));
}

TEST_CASE("a product that is only rounded is within an ulp", "[check]") {
  const Columns in = pairs(29, -300, 300);
  const auto out = the_same_at_every_width("rounded_product", in)[0];
  double worst = 0.0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const cl_RA value = -2 * exact_pair(in, 0, i) * exact_pair(in, 2, i);
    worst = std::max(worst, reference::ulp_error(out[i], value));
  }
  CHECK(worst <= 1.0 + 0x1p-40);
  CHECK(worst > 0.75);
}
