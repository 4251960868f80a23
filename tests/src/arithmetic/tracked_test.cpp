// SPDX-License-Identifier: GPL-2.0-or-later
// |pair - number| <= degree unit size after each operation where it was so before, with the number anywhere in its enclosure.
#include "magicmass/arithmetic/tracked.hpp"

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

using Number = arithmetic::Tracked<double>;
const cl_RA unit = exact(Number::unit);
/// Products of two errors, and pairs' own rounding, are this part of a bound at most: highest_degree unit, and
/// 2^-100/unit.
const cl_RA further = 1 + power(-28);

struct Row {
  cl_RA x, y;  ///< what the operands stand for
  long x_degree, y_degree;
};

struct Operands {
  Columns columns;
  std::vector<Row> rows;
};

Operands operands(std::uint64_t seed, int low, int high) {
  Generator generator(seed);
  Operands all;
  for (int i = 0; i < 4000; ++i) {
    const TwoPairs two = two_pairs(generator, low, high);
    // as large as the number itself, or larger: what is left of a difference
    const auto size = [&](double x) {
      return std::ldexp(std::fabs(x),
                        static_cast<int>(whole(generator, 0, 1) * whole(generator, 1, 30)));
    };
    const double x_size = size(two.x) * (1 + 0x1p-52), y_size = size(two.y) * (1 + 0x1p-52);
    append(all.columns, {two.x, two.x_low, x_size, two.y, two.y_low, y_size});
    Row row{exact(two.x) + exact(two.x_low), exact(two.y) + exact(two.y_low),
            static_cast<long>(whole(generator, 1, 4)), static_cast<long>(whole(generator, 1, 4))};
    row.x = row.x + place(generator) * row.x_degree * unit * exact(x_size);
    row.y = row.y + place(generator) * row.y_degree * unit * exact(y_size);
    all.rows.push_back(row);
  }
  return all;
}

template <class Truth, class Degree>
void require_within(const char* name, const Operands& in, const Truth& truth,
                    const Degree& degree) {
  for (const Columns& out : at_every_rounding(name, in.columns)) {
    cl_RA worst = 0;
    for (std::size_t i = 0; i < in.rows.size(); ++i) {
      const Row& row = in.rows[i];
      if (std::isinf(out[2][i])) continue;
      const cl_RA bound = degree(row.x_degree, row.y_degree) * unit * exact(out[2][i]);
      const cl_RA error = cln::abs(exact_pair(out, 0, i) - truth(row.x, row.y));
      INFO(name << ", row " << i << ": " << in.columns[0][i] << " and " << in.columns.back()[i]);
      REQUIRE(error <= bound * further);
      worst = std::max(worst, cl_RA(error / bound));
    }
    CHECK(worst > power(-1));  // a number at the end of its enclosure uses up the bound
  }
}

const auto larger = [](long x, long y) { return std::max(x, y); };
const auto together = [](long x, long y) { return x + y; };

/// The second operand a plain double: its three columns become one.
Operands with_number(Operands in) {
  in.columns.resize(4);
  for (std::size_t i = 0; i < in.rows.size(); ++i) in.rows[i].y = exact(in.columns[3][i]);
  return in;
}

}  // namespace

TEST_CASE("sizes of sums, products and quotients bound their errors", "[check]") {
  const auto sum = [](const cl_RA& x, const cl_RA& y) { return x + y; };
  const auto product = [](const cl_RA& x, const cl_RA& y) { return x * y; };
  const auto first = [](long x, long) { return x; };
  require_within("tracked_sum", operands(31, -300, 300), sum, larger);
  require_within(
      "tracked_difference", operands(32, -300, 300),
      [](const cl_RA& x, const cl_RA& y) { return x - y; }, larger);
  require_within("tracked_plus_number", with_number(operands(33, -300, 300)), sum, first);
  for (const char* name : {"tracked_product", "fused_product"})
    require_within(name, operands(34, -300, 300), product, together);
  for (const char* name : {"tracked_times_number", "fused_times_number"})
    require_within(name, with_number(operands(35, -300, 300)), product, first);
  require_within(
      "tracked_quotient", operands(36, -300, 300),
      [](const cl_RA& x, const cl_RA& y) { return x / y; }, together);
}

TEST_CASE("a quotient by what may be zero is not known at all", "[exam]") {
  // 8 units of the size are 2^-20 of the divisor
  const double size = 0x1p47;
  const auto out = the_same_at_every_width("tracked_quotient", {{1.0, 1.0, 1.0},
                                                                {0.0, 0.0, 0.0},
                                                                {1.0, 1.0, 1.0},
                                                                {1.0, 1.0, 0.0},
                                                                {0.0, 0.0, 0.0},
                                                                {size, size / 2, 1.0}});
  CHECK(out[2][0] == HUGE_VAL);
  CHECK(std::isfinite(out[2][1]));
  CHECK(out[2][2] == HUGE_VAL);
}

TEST_CASE("a tracked reciprocal root is within 2^-98", "[check]") {
  Generator generator(37);
  Columns narrow, wide;
  for (int i = 0; i < 4000; ++i) {
    const bool is_narrow = i % 2 == 0;
    const double w =
        std::fabs(any_double(generator, is_narrow ? -120 : -900, is_narrow ? 120 : 900));
    append(is_narrow ? narrow : wide, {w, any_low(generator, w), w});
  }
  const auto require_root = [](const Columns& in, const std::vector<Columns>& results) {
    for (const Columns& out : results)
      for (std::size_t i = 0; i < in[0].size(); ++i) {
        const cl_RA root = exact_pair(out, 0, i), w = exact_pair(in, 0, i);
        INFO("w = " << in[0][i]);
        REQUIRE(cln::abs(root * root * w - 1) <= power(-97));
        REQUIRE(exact(out[2][i]) * (1 + power(-50)) >= cln::abs(root));
      }
  };
  require_root(narrow, at_every_rounding("tracked_root", narrow));
  require_root(wide, at_every_rounding("tracked_root", wide));
  require_root(narrow, at_each_width("fused_root", narrow));
}

TEST_CASE("the root's argument in lanes is (2 + alpha) alpha, and (1 + alpha)^2 from 1 on",
          "[check]") {
  Generator generator(38);
  Columns in;
  for (int i = 0; i < 4000; ++i) {
    const double alpha =
        std::fabs(any_double(generator, i % 2 == 0 ? -120 : -4, i % 3 == 0 ? 3 : 59));
    append(in, {alpha, 1.0});
  }
  append(in, {1.0, 1.0});
  append(in, {0x1.fffffffffffffp-1, 1.0});
  for (const Columns& out : at_every_rounding("fused_root_argument", in))
    for (std::size_t i = 0; i < in[0].size(); ++i) {
      const cl_RA alpha = exact(in[0][i]), w = exact_pair(out, 0, i);
      const cl_RA argument = in[0][i] >= 1.0 ? (1 + alpha) * (1 + alpha) : (2 + alpha) * alpha;
      INFO("alpha = " << in[0][i]);
      REQUIRE(cln::abs(w - argument) <= argument * power(-100));
      REQUIRE(exact(out[2][i]) * (1 + power(-50)) >= argument);
    }
}
