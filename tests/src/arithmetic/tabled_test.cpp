// SPDX-License-Identifier: GPL-2.0-or-later
// What works on one double at a time, within the stated bounds, against CLN's functions; and the same bits on every machine.
#include "magicmass/arithmetic/tabled.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <cln/real.h>

#include "arithmetic/every_width.hpp"
#include "arithmetic/operands.hpp"
#include "arithmetic/real_functions.hpp"
#include "magicmass/reference/rational.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using cln::cl_RA;
using reference::exact;

namespace {

/// Pairs from 2^-300 to `most`: uniform, small, next to a table's nodes and half way between two.
Columns arguments(std::uint64_t seed, double most) {
  Generator generator(seed);
  Columns in;
  const auto add = [&](double x) {
    if (x > 0.0 && x <= most) append(in, {x, any_low(generator, x)});
  };
  for (int i = 0; i < 2000; ++i) {
    add(std::uniform_real_distribution<double>(0.0, most)(generator));
    add(log_uniform(generator, i % 3 == 0 ? 0x1p-300 : 0x1p-30, most));
  }
  for (int j = 1; j <= 2000; ++j)
    for (const double x : neighbourhood(j * 0x1p-9, 1)) add(x);
  for (int j = 1; j <= 512; ++j)  // of the square
    for (const double x : neighbourhood(std::sqrt(j * 0x1p-9), 1)) add(x);
  for (const double x : neighbourhood(0x1.921fb54442d18p+0, 3)) add(x);
  append(in, {most, 0.0});
  return in;
}

cl_RA root(const cl_RA& x) { return cln::rational(cln::realpart(cln::sqrt(real(x)))); }

/// 1/cos(pi/m) - 1.
cl_RA secant_less_one(const cl_RA& m) {
  const cl_RA half = exact_sine(cln::rational(cln::pi(real(m)) / real(2 * m)));
  return 2 * half * half / (1 - 2 * half * half);
}

/// |got - value| <= allowed, which is not far from what is seen.
struct Worst {
  double over_allowed = 0.0;

  void require(const cl_RA& got, const cl_RA& value, const cl_RA& allowed) {
    const cl_RA error = cln::abs(got - value);
    INFO("off by 2^" << std::log2(cln::double_approx(error)) << " of "
                     << cln::double_approx(value));
    REQUIRE(error <= allowed);
    over_allowed = std::max(over_allowed, cln::double_approx(error / allowed));
  }
};

}  // namespace

TEST_CASE("a tabled arctangent is within 2^-61 and within 2^-51 t^2 + 2^-100 of itself",
          "[check]") {
  const Columns in = arguments(161, 1.0);
  const Columns out = of_single_doubles("tabled_arctangent", in);
  Worst worst;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA t = exact_pair(in, 0, i), value = exact_arctangent(t);
    INFO(in[0][i] << " + " << in[1][i]);
    worst.require(exact_pair(out, 0, i), value,
                  value * std::min(power(-61), cl_RA(power(-51) * t * t + power(-100))));
    REQUIRE(std::fabs(out[1][i]) <= 0x1p-53 * out[0][i]);
  }
  CHECK(worst.over_allowed > 1 / 8.0);
}

TEST_CASE(
    "a tabled sine is within 2^-59 of itself up to pi and of its sign beyond, a cosine within "
    "2^-60",
    "[check]") {
  const Columns pairs = arguments(162, 3.14);
  Generator generator(165);
  std::uniform_real_distribution<double> low(-0x1p-51, 0x1p-51), off(-0x1p-17, 0x1p-17);
  Columns in;
  const auto add = [&](double x, double x_low) {
    append(in, {x, x_low, std::fabs(x + (x < 1.0 ? x : 1.0) * off(generator))});
  };
  for (std::size_t i = 0; i < pairs[0].size(); ++i) add(pairs[0][i], pairs[1][i]);
  // next to pi on both sides
  for (int i = 0; i < 4000; ++i) {
    const double x = M_PI - (i % 2 == 0 ? 1.0 : -0.003) * log_uniform(generator, 0x1p-52, 1.0);
    add(x, low(generator) * x);
  }
  for (int j = -8; j <= 8; ++j)
    for (const double x_low : {-0x1p-50, -0x1p-53, 0.0, 0x1p-53, 0x1p-50})
      add(M_PI + j * 0x1p-51, x_low);
  const Columns out = of_single_doubles("tabled_sine_cosine", in);
  const cl_RA pi = cln::rational(cln::pi(real(cl_RA(1))));
  Worst worst;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA x = exact_pair(in, 0, i);
    INFO(in[0][i] << " + " << in[1][i] << ", early " << in[2][i]);
    if (x > pi) {
      REQUIRE(exact_pair(out, 0, i) < power(-102));
      continue;
    }
    const cl_RA sine = exact_sine(pi - x);
    worst.require(exact_pair(out, 0, i), sine, power(-59) * sine + power(-102));
    worst.require(exact_pair(out, 2, i), exact_cosine(x), power(-60));
  }
  CHECK(worst.over_allowed > 1 / 8.0);
}

TEST_CASE("outside of the tables nothing is read beside them", "[exam]") {
  Columns in, numbers;
  for (const double x : {3.15, 4.0, 1e3, 1e17, 1e300, HUGE_VAL, -1.0, -HUGE_VAL, std::nan("")}) {
    append(numbers, {x, 0.0});
    for (const double early : {x, 0.1, 3.1, -1.0, 1e300, std::nan("")}) append(in, {x, 0.0, early});
  }
  of_single_doubles("tabled_sine_cosine", in);
  of_single_doubles("tabled_arctangent", numbers);
}

TEST_CASE("a tabled reciprocal is within 2^-100 and a root within 2^-98 of itself", "[check]") {
  Generator generator(163);
  Columns in;
  for (int i = 0; i < 4000; ++i) {
    const double x = log_uniform(generator, 0x1p-300, 0x1p300);
    append(in, {x, any_low(generator, x)});
  }
  const Columns inverse = of_single_doubles("tabled_reciprocal", in);
  const Columns inverse_root = of_single_doubles("tabled_root", in);
  Worst worst;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA x = exact_pair(in, 0, i), of_root = 1 / root(x);
    INFO(in[0][i] << " + " << in[1][i]);
    worst.require(exact_pair(inverse, 0, i), 1 / x, power(-100) / x);
    worst.require(exact_pair(inverse_root, 0, i), of_root, power(-98) * of_root);
  }
  CHECK(worst.over_allowed > 1 / 32.0);
}

TEST_CASE("atan(sqrt z) of a double is within 2.01 2^-53 of itself", "[check]") {
  const Columns pairs = arguments(164, 1.0), in{pairs[0]};
  const Columns out = of_single_doubles("root_arctangent", in);
  Worst worst;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA value = exact_arctangent(root(exact(in[0][i])));
    INFO(in[0][i]);
    worst.require(exact(out[0][i]), value, value * power(-53) * 201 / 100);
  }
  CHECK(worst.over_allowed > 0.5);
}

TEST_CASE(
    "asec(1 + x)/2 of a double is within 2.01 2^-53, as a pair within 2^-60 and 2^-51 x + 2^-100 "
    "of itself",
    "[check]") {
  Columns in{arguments(166, 1.0)[0]};
  for (int k = -1074; k < 0; k += 7) append(in, {std::ldexp(1.0, k)});
  const Columns rounded = of_single_doubles("rounded_half_arcsecant", in);
  const Columns pairs = of_single_doubles("half_arcsecant", in);
  Worst worst_rounded, worst;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA x = exact(in[0][i]), value = exact_arctangent(root(x / (2 + x)));
    INFO(in[0][i]);
    worst_rounded.require(exact(rounded[0][i]), value, value * power(-53) * 201 / 100);
    worst.require(exact_pair(pairs, 0, i), value,
                  value * std::min(power(-60), cl_RA(power(-51) * x + power(-100))));
    REQUIRE(std::fabs(pairs[1][i]) <= 0x1p-9 * pairs[0][i]);
  }
  CHECK(worst_rounded.over_allowed > 0.5);
  CHECK(worst.over_allowed > 1 / 8.0);
}

TEST_CASE("an early angle is within 2^-19 of the angle, and the angle's low part within 2^-52",
          "[check]") {
  Columns in{arguments(167, 1.0)[0]};
  std::erase_if(in[0], [](double x) { return x < 0x1p-120; });
  const Columns out = of_single_doubles("early_half_arcsecant", in);
  CHECK(Columns{out[0], out[1]} == of_single_doubles("half_arcsecant", in));
  Worst worst;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    INFO(in[0][i]);
    const cl_RA angle = exact_pair(out, 0, i);
    worst.require(exact(out[2][i]), angle, power(-19) * angle);
    REQUIRE(std::fabs(out[1][i]) <= 0x1p-52 * out[0][i]);
  }
  CHECK(worst.over_allowed > 1 / 8.0);
}

TEST_CASE(
    "tan(psi/4) of a usual alpha is within 2^-100 of itself, of a vanishing one within alpha/4",
    "[check]") {
  Columns usual{arguments(168, 0x1.fffffffffffffp-1)[0]}, vanishing{usual};
  std::erase_if(usual[0], [](double x) { return x < 0x1p-120; });
  std::erase_if(vanishing[0], [](double x) { return x > 0x1p-90; });
  const auto worst_of = [](const char* name, const Columns& in, const auto& allowed) {
    const Columns out = of_single_doubles(name, in);
    Worst worst;
    for (std::size_t i = 0; i < in[0].size(); ++i) {
      INFO(in[0][i]);
      const cl_RA alpha = exact(in[0][i]), value = root(alpha / (2 + alpha));
      worst.require(exact_pair(out, 0, i), value, allowed(alpha) * value);
      REQUIRE(std::fabs(out[1][i]) <= 0x1p-51 * out[0][i]);
    }
    return worst.over_allowed;
  };
  CHECK(worst_of("usual_tangent", usual, [](const cl_RA&) { return power(-100); }) > 1 / 64.0);
  CHECK(worst_of("vanishing_tangent", vanishing,
                 [](const cl_RA& alpha) -> cl_RA { return alpha / 4 + power(-104); }) > 1 / 64.0);
}

TEST_CASE(
    "sine and cosine of a small offset are those of its magnitude, within 2^-60 of themselves",
    "[check]") {
  Generator generator(169);
  std::uniform_real_distribution<double> low(-0x1p-51, 0x1p-51), off(-0x1p-18, 0x1p-18);
  Columns in, both_parts;
  const auto add = [&](double x, double x_low) {
    for (const double sign : {1.0, -1.0}) {
      append(in, {sign * x, sign * x_low, sign * x + off(generator)});
      append(both_parts, {sign * x, sign * x_low});
    }
  };
  for (int i = 0; i < 4000; ++i)
    add(0x1p-53 * std::floor(log_uniform(generator, 0.5, 0.8 * 0x1p53)), low(generator));
  for (int j = 0; j <= 400; ++j)
    for (const double more : {-0x1p-53, 0.0, 0x1p-53})
      if (j * 0x1p-9 + more >= 0.0) add(j * 0x1p-9 + more, low(generator));
  const Columns usual = of_single_doubles("usual_small_sine_cosine", in);
  const Columns vanishing = of_single_doubles("vanishing_small_sine", both_parts);
  Worst worst;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA x = cln::abs(exact_pair(in, 0, i)), sine = exact_sine(x);
    INFO(in[0][i] << " + " << in[1][i] << ", early " << in[2][i]);
    worst.require(exact_pair(usual, 0, i), sine, power(-60) * sine);
    worst.require(exact_pair(usual, 2, i), exact_cosine(x), power(-60));
    REQUIRE(exact_pair(vanishing, 0, i) == x);
    REQUIRE(std::fabs(vanishing[1][i]) <= 0x1p-53 * vanishing[0][i]);
  }
  CHECK(worst.over_allowed > 1 / 8.0);
}

TEST_CASE("1/cos(pi/m) - 1 is within 2^-52/m^2 + 2^-98 of itself", "[check]") {
  Generator generator(165);
  Columns in;
  for (int m = 3; m <= 2000; m += 2) append(in, {1.0 * m, 0.0, 1.0 + m, 0.0});
  for (int i = 0; i < 1000; ++i) {
    const double m = std::ceil(log_uniform(generator, 3.0, 0x1p63));
    append(in, {m, m < 0x1p53 ? 0.0 : any_low(generator, m), m + 1, 0.0});
  }
  const Columns out = of_single_doubles("secants", in);
  Worst worst;
  for (const std::size_t side : {0U, 2U})
    for (std::size_t i = 0; i < in[0].size(); ++i) {
      const cl_RA m = exact_pair(in, side, i), value = secant_less_one(m);
      INFO("m = " << in[side][i] << " + " << in[side + 1][i]);
      worst.require(exact_pair(out, side, i), value, value * (power(-52) / (m * m) + power(-98)));
    }
  CHECK(worst.over_allowed > 1 / 32.0);

  // the same bits for whole numbers that need no low part
  Columns whole(2), of_pairs(4);
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    if (in[0][i] >= 0x1p26) continue;
    append(whole, {in[0][i], in[2][i]});
    for (std::size_t k = 0; k < 4; ++k) of_pairs[k].push_back(out[k][i]);
  }
  CHECK(of_single_doubles("whole_secants", whole) == of_pairs);
}

TEST_CASE("the tables of atan(sqrt z)/sqrt z and asec(1 + x)/(2 sqrt x) are within 2^-104 of them",
          "[exam]") {
  constexpr int rows = sizeof arithmetic::root_arctangent_table / sizeof(double) / 8;
  CHECK(rows == 257);
  CHECK(sizeof arithmetic::root_arcsecant_table == sizeof arithmetic::root_arctangent_table);
  const auto compare = [](const double* row, const cl_RA& value) {
    REQUIRE(cln::abs(exact(row[0]) + exact(row[1]) - value) <= power(-104) * value);
  };
  for (int j = 1; j < rows; ++j) {
    const cl_RA x = cl_RA(j) / 256, s = root(x);
    compare(arithmetic::root_arctangent_table + 8 * j, exact_arctangent(s) / s);
    compare(arithmetic::root_arcsecant_table + 8 * j, exact_arctangent(root(x / (2 + x))) / s);
  }
}
