// SPDX-License-Identifier: GPL-2.0-or-later
// Rough numbers within their stated bounds, against rational numbers.
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

/// high + low with a low of up to 2^most of it, sometimes a pair's.
void append_number(std::vector<double>& row, Generator& generator, int most) {
  const double x = any_double(generator, -100, 100);
  row.push_back(x);
  row.push_back(whole(generator, 0, 2) == 0 ? any_low(generator, x)
                                            : x * any_double(generator, most - 40, most));
}

Columns numbers(std::uint64_t seed, std::size_t columns, int most) {
  Generator generator(seed);
  Columns in(columns);
  for (int i = 0; i < 4000; ++i) {
    std::vector<double> row;
    while (row.size() < columns) append_number(row, generator, most);
    for (std::size_t k = 0; k < columns; ++k) in[k].push_back(row[k]);
  }
  return in;
}

/// The error of the pair in the first two columns out, as a part of what bound(i) allows.
template <class Truth, class Bound>
void require_within(const Columns& in, const Columns& out, const Truth& truth, const Bound& bound) {
  double worst = 0.0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA error = cln::abs(exact_pair(out, 0, i) - truth(i));
    INFO(in[0][i] << " + " << in[1][i] << ", " << in.back()[i]);
    REQUIRE(error <= bound(i));
    if (bound(i) != 0) worst = std::max(worst, cln::double_approx(cl_RA(error / bound(i))));
  }
  CHECK(worst > 0x1p-6);  // the bound says something
}

cl_RA size(const cl_RA& x) { return cln::abs(x); }

}  // namespace

TEST_CASE("a product of two rough numbers is as good as its lows", "[check]") {
  const Columns in = numbers(1, 4, -5);
  const auto high = [&](std::size_t k, std::size_t i) { return exact(in[k][i]); };
  require_within(
      in, the_same_at_every_width("rough_product", in),
      [&](std::size_t i) { return exact_pair(in, 0, i) * exact_pair(in, 2, i); },
      [&](std::size_t i) -> cl_RA {
        const cl_RA of_lows =
            size(high(0, i) * high(3, i)) + size(high(1, i) * exact_pair(in, 2, i));
        return power(-51) * of_lows + power(-103) * size(high(0, i) * high(2, i));
      });
}

TEST_CASE("a product of a rough number and a double is as good as its low", "[check]") {
  Columns in = numbers(2, 4, -5);
  in.pop_back();
  const auto number = [&](std::size_t i) { return exact(in[2][i]); };
  require_within(
      in, the_same_at_every_width("rough_times_number", in),
      [&](std::size_t i) { return exact_pair(in, 0, i) * number(i); },
      [&](std::size_t i) -> cl_RA {
        return size(number(i)) *
               (power(-52) * size(exact(in[1][i])) + power(-103) * size(exact(in[0][i])));
      });
  // cut in two, a number times the leading half of a double is exact
  Columns pairs = in;
  Generator generator(3);
  for (std::size_t i = 0; i < in[0].size(); ++i) pairs[1][i] = any_low(generator, in[0][i]);
  require_within(
      pairs, the_same_at_every_width("cut_times_number", pairs),
      [&](std::size_t i) { return exact_pair(pairs, 0, i) * number(i); },
      [&](std::size_t i) { return power(-73) * size(exact(in[0][i]) * number(i)); });
}

TEST_CASE("an angle times a whole number is the product of any two, however many digits that has",
          "[check]") {
  Columns in = numbers(11, 4, -6);
  in.pop_back();
  Generator generator(12);
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    // eight at a time of one kind: below 2^26, at the edge, and beyond
    const int most = (i / 8) % 3 == 0 ? 25 : (i / 8) % 3 == 1 ? 26 : 52;
    in[2][i] = std::trunc(std::fabs(any_double(generator, 0, most)));
  }
  const auto out = the_same_at_every_width("angle_times_whole", in);
  const auto product = the_same_at_every_width("rough_times_number", in);
  CHECK(same_bits(out[0], product[0]));
  CHECK(same_bits(out[1], product[1]));
}

TEST_CASE("products of numbers cut in two need no fused operation", "[check]") {
  const Columns in = numbers(4, 4, -2);
  const Columns out = the_same_at_every_width("cut_product", in);
  const auto lead = the_same_at_every_width("leading_half", {in[0]});
  const auto other_lead = the_same_at_every_width("leading_half", {in[2]});
  for (std::size_t i = 0; i < in[0].size(); ++i)
    REQUIRE(exact(out[0][i]) == exact(lead[0][i]) * exact(other_lead[0][i]));
  require_within(
      in, out, [&](std::size_t i) { return exact_pair(in, 0, i) * exact_pair(in, 2, i); },
      [&](std::size_t i) -> cl_RA {
        const cl_RA x = exact_pair(in, 0, i), y = exact_pair(in, 2, i);
        return power(-50) * (size(x - exact(lead[0][i])) * size(y) +
                             size(x) * size(y - exact(other_lead[0][i])));
      });
}

TEST_CASE("a square is the product with itself", "[check]") {
  Columns in = numbers(13, 4, -5);
  in.resize(2);
  const Columns out = the_same_at_every_width("rough_square", in);
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA x = exact_pair(in, 0, i), high = exact(in[0][i]), low = exact(in[1][i]);
    REQUIRE(size(exact_pair(out, 0, i) - x * x) <=
            power(-51) * size(2 * high * low + low * low) + power(-103) * high * high);
  }
}

TEST_CASE("what two results leave of 1, and a quotient, are rounded once or twice", "[check]") {
  const Columns in = [] {
    Columns made = numbers(14, 4, -5);
    made.pop_back();
    return made;
  }();
  const Columns out = the_same_at_every_width("rounded_rest", in);
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA x = exact_pair(in, 0, i), y = exact(in[2][i]);
    REQUIRE(size(exact(out[0][i]) - (1 + x - y)) <=
            power(-53) * (size(1 + x - y) + (size(x - y) + size(x)) * 2));
    REQUIRE(out[1][i] == in[0][i] / in[2][i]);
    REQUIRE(size(exact(out[2][i]) + x) <= power(-53) * size(x));
  }
}

TEST_CASE("numbers cut in two add up with others", "[check]") {
  const Columns in = numbers(16, 4, -5);
  const Columns out = the_same_at_every_width("cut_sums", in);
  const auto lead = the_same_at_every_width("leading_half", {in[0]});
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA x = exact_pair(in, 0, i), y = exact_pair(in, 2, i);
    const cl_RA rest = x - exact(lead[0][i]);
    REQUIRE(size(exact_pair(out, 0, i) - (1 + 4 * x)) <=
            power(-53) * (1 + 4 * size(exact(lead[0][i])) + 8 * size(rest)));
    const cl_RA all = size(x) + size(y) + size(rest);
    REQUIRE(size(exact(out[2][i]) - (x + y)) <= power(-52) * all);
    REQUIRE(size(exact(out[3][i]) - (x + y)) <= power(-51) * all);
  }
}

TEST_CASE("leads subtract exactly, and nearby ones need few bits", "[check]") {
  Columns in = numbers(9, 4, -30);
  Generator generator(10);
  for (std::size_t i = 0; i < in[0].size(); ++i)
    in[2][i] = in[0][i] * std::uniform_real_distribution<double>(0.125, 1.0)(generator);
  const Columns out = the_same_at_every_width("cut_difference", in);
  const auto lead = the_same_at_every_width("leading_half", {in[0]});
  const auto other_lead = the_same_at_every_width("leading_half", {in[2]});
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    REQUIRE(exact(out[0][i]) == exact(lead[0][i]) - exact(other_lead[0][i]));
    REQUIRE(exact(out[2][i]) == exact(lead[0][i]) + exact(other_lead[0][i]));
    REQUIRE(out[3][i] ==
            (in[0][i] - lead[0][i] + in[1][i]) + (in[2][i] - other_lead[0][i] + in[3][i]));
    // 29 bits: times 24 they fit a double
    int exponent;
    const double bits = std::ldexp(std::frexp(out[0][i], &exponent), 29);
    REQUIRE(bits == std::trunc(bits));
  }
  require_within(
      in, out, [&](std::size_t i) -> cl_RA { return exact_pair(in, 0, i) - exact_pair(in, 2, i); },
      [&](std::size_t i) -> cl_RA {
        return power(-52) * (size(exact_pair(in, 0, i) - exact(lead[0][i])) +
                             size(exact_pair(in, 2, i) - exact(other_lead[0][i])));
      });
}

TEST_CASE("a number near 1 costs what it is below 1", "[check]") {
  Columns in = numbers(5, 4, -3);
  in.pop_back();
  Generator generator(6);
  for (double& below : in[2])
    below = whole(generator, 0, 4) == 0 ? 0.0 : std::fabs(any_double(generator, -40, -3));
  const Columns out = the_same_at_every_width("cut_times_near_one", in);
  require_within(
      in, out, [&](std::size_t i) -> cl_RA { return exact_pair(in, 0, i) * (1 - exact(in[2][i])); },
      [&](std::size_t i) -> cl_RA {
        const cl_RA x = exact_pair(in, 0, i);
        return power(-51) *
               (size(x) * exact(in[2][i]) + size(exact(in[1][i])) + power(-25) * size(x));
      });
}

TEST_CASE("a sum of two products is rounded twice", "[check]") {
  const Columns in = numbers(7, 4, -5);
  const Columns out = the_same_at_every_width("wide_sums", in);
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA x = exact_pair(in, 0, i), y = exact_pair(in, 2, i);
    const auto allowed = [&](const cl_RA& sum, const cl_RA& highs, const cl_RA& lows) -> cl_RA {
      return power(-53) * (size(sum) + size(highs) + size(lows)) * (1 + power(-50));
    };
    const cl_RA x_high = exact(in[0][i]), y_high = exact(in[2][i]);
    const cl_RA x_low = exact(in[1][i]), y_low = exact(in[3][i]);
    REQUIRE(size(exact(out[0][i]) / -2 - (x + y)) <=
            allowed(x + y, x_high + y_high, x_low + y_low));
    REQUIRE(size(exact(out[1][i]) - (x - y)) <= allowed(x - y, x_high - y_high, x_low - y_low));
  }
}

TEST_CASE("a number is taken from half of pi without error but for its low", "[check]") {
  Columns in(2);
  Generator generator(8);
  for (int i = 0; i < 4000; ++i) {
    const double x = std::uniform_real_distribution<double>(0.8, 3.1)(generator);
    append(in, {x, x * any_double(generator, -60, -6)});
  }
  const Columns out = the_same_at_every_width("rough_from_pi", in);
  const cl_RA half_pi = exact(0x1.921fb54442d18p+0) + exact(0x1.1a62633145c07p-54);
  require_within(
      in, out, [&](std::size_t i) { return half_pi - exact_pair(in, 0, i); },
      [&](std::size_t i) -> cl_RA {
        return power(-53) *
               (size(exact(in[1][i])) + power(-53) + power(-53) * size(exact(out[0][i])));
      });
}
