// SPDX-License-Identifier: GPL-2.0-or-later
// |pair - number| <= error after each operation where it was so before, with the number anywhere in its enclosure.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "arithmetic/every_width.hpp"
#include "arithmetic/operands.hpp"
#include "magicmass/reference/rational.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using cln::cl_RA;
using reference::exact;

namespace {

struct Operands {
  Columns columns;
  std::vector<cl_RA> x, y;  ///< what they stand for
};

Operands operands(std::uint64_t seed, int low, int high) {
  Generator generator(seed);
  Operands all;
  for (int i = 0; i < 4000; ++i) {
    const TwoPairs two = two_pairs(generator, low, high);
    const auto error = [&](double x) {
      if (whole(generator, 0, 3) == 0) return 0.0;
      return std::fabs(x) * std::fabs(any_double(generator, -110, -20));
    };
    const double x_error = error(two.x), y_error = error(two.y);
    append(all.columns, {two.x, two.x_low, x_error, two.y, two.y_low, y_error});
    all.x.push_back(exact(two.x) + exact(two.x_low) + place(generator) * exact(x_error));
    all.y.push_back(exact(two.y) + exact(two.y_low) + place(generator) * exact(y_error));
  }
  return all;
}

Operands with_number(Operands in) {
  in.columns.resize(4);
  for (std::size_t i = 0; i < in.y.size(); ++i) in.y[i] = exact(in.columns[3][i]);
  return in;
}

/// As the rounding test takes it.
cl_RA bound(const Columns& out, std::size_t row) {
  return exact(out[2][row]) * (1 + power(-40)) + power(-104) * cln::abs(exact(out[0][row]));
}

template <class Truth>
void require_within(const char* name, const Operands& in, const Truth& truth) {
  const auto out = the_same_at_every_width(name, in.columns);
  cl_RA worst = 0;
  for (std::size_t i = 0; i < in.x.size(); ++i) {
    if (!std::isfinite(out[2][i])) continue;
    const cl_RA error = cln::abs(exact_pair(out, 0, i) - truth(in.x[i], in.y[i]));
    INFO(name << ", row " << i << ": " << in.columns[0][i] << " and " << in.columns.back()[i]);
    REQUIRE(error <= bound(out, i));
    if (out[2][i] > 0.0) worst = std::max(worst, cl_RA(error / exact(out[2][i])));
  }
  CHECK(worst > cl_RA(9) / 10);  // a number at the end of its enclosure uses up the bound
}

}  // namespace

TEST_CASE("error bounds of sums, products and quotients hold", "[check]") {
  const auto sum = [](const cl_RA& x, const cl_RA& y) { return x + y; };
  const auto product = [](const cl_RA& x, const cl_RA& y) { return x * y; };
  require_within("bounded_sum", operands(41, -300, 300), sum);
  require_within("bounded_plus_number", with_number(operands(42, -300, 300)), sum);
  require_within("bounded_product", operands(43, -300, 300), product);
  require_within("bounded_times_number", with_number(operands(44, -300, 300)), product);
  require_within("bounded_quotient", operands(45, -300, 300),
                 [](const cl_RA& x, const cl_RA& y) { return x / y; });
}

TEST_CASE("a quotient by what may be zero has no bound", "[exam]") {
  const auto out = the_same_at_every_width("bounded_quotient", {{1.0, 1.0, 1.0},
                                                                {0.0, 0.0, 0.0},
                                                                {0.0, 0.0, 0.0},
                                                                {1.0, 1.0, 0.0},
                                                                {0.0, 0.0, 0.0},
                                                                {0.5, 2.0, 0.0}});
  for (const double error : out[2]) CHECK_FALSE(std::isfinite(error));
}

TEST_CASE("a bounded reciprocal root is within its bound", "[check]") {
  Generator generator(46);
  Columns in;
  std::vector<cl_RA> numbers;
  for (int i = 0; i < 4000; ++i) {
    const double w = std::fabs(any_double(generator, -120, 119));
    const double error = i % 2 == 0 ? 0.0 : w * std::fabs(any_double(generator, -104, -60));
    append(in, {w, any_low(generator, w), error});
    numbers.push_back(exact_pair(in, 0, static_cast<std::size_t>(i)) +
                      place(generator) * exact(error));
  }
  const Results results = at_every_width("bounded_root", in);
  for (const Columns& out : {results.single, results.lanes}) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      // root (1 - e) <= 1/sqrt(w) <= root (1 + e)
      const cl_RA root = exact_pair(out, 0, i), error = bound(out, i);
      INFO(in[0][i] << ", error " << in[2][i]);
      REQUIRE((root - error) * (root - error) * numbers[i] <= 1);
      REQUIRE((root + error) * (root + error) * numbers[i] >= 1);
    }
  }
}
