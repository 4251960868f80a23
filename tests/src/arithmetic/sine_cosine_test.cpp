// SPDX-License-Identifier: GPL-2.0-or-later
// Sines and cosines within their stated bounds over their whole domains, against CLN's.
#include "magicmass/arithmetic/sine_cosine.hpp"

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

/// Numbers from `least` to `most` as pairs: uniform, small, next to the table's nodes, half way between two, next to
/// multiples of a quarter of pi and where pieces meet, and the ends.
Columns arguments(std::uint64_t seed, double least, double most) {
  Generator generator(seed);
  Columns in;
  const auto add = [&](double x) {
    if (x != 0.0 && x >= least && x <= most) append(in, {x, any_low(generator, x)});
  };
  const auto add_both = [&](double x) {
    add(x);
    add(-x);
  };
  for (int i = 0; i < 1200; ++i) {
    add(std::uniform_real_distribution<double>(least, most)(generator));
    add_both(log_uniform(generator, i % 3 == 0 ? 0x1p-300 : 0x1p-30, most));
  }
  for (int j = 0; j <= 2000; ++j) add_both(std::nextafter(j * 0x1p-9, j % 2 * 4.0));
  for (int quarter = 1; quarter <= 5; ++quarter)
    for (const double x : neighbourhood(quarter * 0x1.921fb54442d18p-1, 3)) add_both(x);
  for (const double x : neighbourhood(0.8, 2)) add_both(x);
  for (const double end : {least, most})
    if (end != 0.0) append(in, {end, 0.0});
  // as near to a quarter turn as a pair can be
  append(in, {arithmetic::half_pi[0], arithmetic::half_pi[1]});
  return in;
}

void require_within(const cl_RA& relative, const cl_RA& absolute, const Columns& in,
                    const Columns& out, std::size_t of_cosine) {
  cl_RA worst = 0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA x = exact_pair(in, 0, i);
    const cl_RA sine = exact_sine(x), cosine = exact_cosine(x);
    const cl_RA of_sine = cln::abs(exact_pair(out, 0, i) - sine);
    const cl_RA of_cosine_ = cln::abs(exact_pair(out, of_cosine, i) - cosine);
    INFO(in[0][i] << " + " << in[1][i]);
    INFO("sine off by " << std::log2(cln::double_approx(of_sine / cln::abs(sine))) << ", cosine by "
                        << std::log2(cln::double_approx(of_cosine_ / cln::abs(cosine))));
    REQUIRE(of_sine <= std::max(cl_RA(relative * cln::abs(sine)), absolute));
    REQUIRE(of_cosine_ <= std::max(cl_RA(relative * cln::abs(cosine)), absolute));
    worst = std::max(worst, cl_RA(of_cosine_ / cln::abs(cosine)));
  }
  CHECK(worst > relative / 32);
}

}  // namespace

TEST_CASE("sine and cosine of a pair are within 0.2 2^-53 of themselves up to 2.35", "[check]") {
  const Columns in = arguments(71, 0.0, 2.35);
  require_within(power(-53) / 5, power(-109), in, the_same_at_every_width("pair_sine_cosine", in),
                 2);
}

TEST_CASE("sine and cosine of a tracked number are within 2^-70.1 or 2^-80 up to 3.14", "[check]") {
  Columns in = arguments(72, -0x1p-11, 3.14);
  in.emplace_back(in[0].size(), 0.0);
  for (const char* name : {"tracked_sine_cosine", "fused_sine_cosine"})
    for (const Columns& out : at_every_rounding(name, in))
      require_within(exact(std::exp2(-70.1)), power(-80), in, out, 3);
  // and of an argument that is known to 2^-84 of its size, within a unit of theirs
  for (std::size_t i = 0; i < in[0].size(); ++i)
    in[2][i] = std::fabs(in[0][i]) * (i % 3 == 0 ? 64 : 1);
  Generator generator(73);
  for (const char* name : {"tracked_sine_cosine", "fused_sine_cosine"})
    for (const Columns& out : at_every_rounding(name, in))
      for (std::size_t i = 0; i < in[0].size(); ++i) {
        const cl_RA x = exact_pair(in, 0, i) + place(generator) * power(-84) * exact(in[2][i]);
        INFO(name << " of " << in[0][i]);
        REQUIRE(cln::abs(exact_pair(out, 0, i) - exact_sine(x)) <= power(-70) * exact(out[2][i]));
        REQUIRE(cln::abs(exact_pair(out, 3, i) - exact_cosine(x)) <= power(-70) * exact(out[5][i]));
      }
}

TEST_CASE("outside of their domains nothing is certain of a sine or cosine", "[exam]") {
  const double outside[] = {3.15, 4.0, 1e300, -0x1p-9, -1.0, HUGE_VAL, -HUGE_VAL, std::nan("")};
  Columns in(3);
  for (const double x : outside) append(in, {x, 0.0, 1.0});
  for (const char* name : {"tracked_sine_cosine", "fused_sine_cosine"})
    for (const Columns& out : at_every_rounding(name, in))
      for (const std::size_t size : {2U, 5U})
        for (const double x : out[size]) CHECK_FALSE(x < HUGE_VAL);
  for (double& x : in[0])
    if (std::fabs(x) < 3.9) x = 3.95;
  const auto bounded = the_same_at_every_width("bounded_sine_cosine", in);
  for (const std::size_t error : {2U, 5U})
    for (const double x : bounded[error]) CHECK_FALSE(x < HUGE_VAL);
}

TEST_CASE("sine and cosine of a bounded number are within their bounds up to 3.9", "[check]") {
  Columns in = arguments(74, -3.9, 3.9);
  Generator generator(75);
  std::vector<double> errors;
  for (const double x : in[0])
    errors.push_back(static_cast<double>(whole(generator, 0, 1)) * std::fabs(x) *
                     std::exp2(-static_cast<double>(whole(generator, 60, 100))));
  in.push_back(errors);
  const auto out = the_same_at_every_width("bounded_sine_cosine", in);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const cl_RA x = exact_pair(in, 0, i) + place(generator) * exact(errors[i]);
    INFO(in[0][i] << ", error " << errors[i]);
    REQUIRE(cln::abs(exact_pair(out, 0, i) - exact_sine(x)) <= exact(out[2][i]) * (1 + power(-50)));
    REQUIRE(cln::abs(exact_pair(out, 3, i) - exact_cosine(x)) <=
            exact(out[5][i]) * (1 + power(-50)));
  }
  in[2].assign(errors.size(), 0.0);
  require_within(power(-88), power(-158), in, the_same_at_every_width("bounded_sine_cosine", in),
                 3);
}

TEST_CASE("the table of sines and cosines is within 2^-104 of them", "[exam]") {
  constexpr int size = sizeof arithmetic::sine_cosine_table / sizeof(double) / 4;
  CHECK(size == 807);
  for (int j = 1; j < size; ++j) {
    const double* node = arithmetic::sine_cosine_table + 4 * j;
    const cl_RA angle = cl_RA(j) / 256, sine = exact_sine(angle), cosine = exact_cosine(angle);
    REQUIRE(cln::abs(exact(node[0]) + exact(node[2]) - sine) <= power(-104) * cln::abs(sine));
    REQUIRE(cln::abs(exact(node[1]) + exact(node[3]) - cosine) <= power(-104) * cln::abs(cosine));
  }
}
