// SPDX-License-Identifier: GPL-2.0-or-later
// The arctangents within their stated bounds over their whole domains, against CLN's.
#include "magicmass/arithmetic/arctangent.hpp"

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

/// Numbers up to `most` as pairs: uniform, small, next to the table's nodes and half way between two, the ends.
Columns arguments(std::uint64_t seed, double most) {
  Generator generator(seed);
  Columns in;
  const auto add = [&](double t) {
    if (t > 0.0 && t <= most) append(in, {t, any_low(generator, t)});
  };
  for (int i = 0; i < 1500; ++i) {
    add(std::uniform_real_distribution<double>(0.0, most)(generator));
    add(log_uniform(generator, i % 3 == 0 ? 0x1p-300 : 0x1p-30, most));
  }
  for (int j = 1; j <= 512; ++j)
    for (const double t : neighbourhood(j * 0x1p-9, 1)) add(t);
  add(most);
  append(in, {most, 0.0});
  return in;
}

void require_within(const cl_RA& allowed, const Columns& in, const Columns& out) {
  cl_RA worst = 0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cl_RA value = exact_arctangent(exact_pair(in, 0, i));
    const cl_RA error = cln::abs(exact_pair(out, 0, i) - value) / value;
    INFO(in[0][i] << " + " << in[1][i]);
    INFO("off by 2^" << std::log2(cln::double_approx(error)));
    REQUIRE(error <= allowed);
    worst = std::max(worst, error);
  }
  CHECK(worst > allowed / 32);
}

}  // namespace

TEST_CASE("the arctangent of a pair is within 0.25 2^-53 of itself up to 0.577", "[check]") {
  const Columns in = arguments(61, 0.577);
  require_within(power(-53) / 4, in, the_same_at_every_width("pair_arctangent", in));
}

TEST_CASE("the arctangent of a tracked number is within 2^-84 of itself up to 1", "[check]") {
  Columns in = arguments(62, 1.0);
  in.push_back(in[0]);
  for (const char* name : {"tracked_arctangent", "fused_arctangent"})
    for (const Columns& out : at_every_rounding(name, in)) {
      require_within(power(-84), in, out);
      CHECK(out[2] == out[0]);
    }
}

TEST_CASE("the arctangent of a bounded number is within its bound up to 1", "[check]") {
  Columns in = arguments(63, 1.0);
  Generator generator(64);
  std::vector<double> errors;
  for (const double t : in[0])
    errors.push_back(static_cast<double>(whole(generator, 0, 1)) * t *
                     std::exp2(-static_cast<double>(whole(generator, 60, 100))));
  in.push_back(errors);
  const auto out = the_same_at_every_width("bounded_arctangent", in);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const cl_RA t = exact_pair(in, 0, i) + place(generator) * exact(errors[i]);
    INFO(in[0][i] << ", error " << errors[i]);
    REQUIRE(cln::abs(exact_pair(out, 0, i) - exact_arctangent(t)) <=
            exact(out[2][i]) * (1 + power(-50)));
  }
  in[2].assign(errors.size(), 0.0);
  require_within(power(-88), in, the_same_at_every_width("bounded_arctangent", in));
}

TEST_CASE("the table of arctangents is within 2^-104 of them", "[exam]") {
  constexpr int size = sizeof arithmetic::arctangent_table / sizeof(double) / 2;
  CHECK(size == 257);
  for (int j = 1; j < size; ++j) {
    const double* node = arithmetic::arctangent_table + 2 * j;
    const cl_RA value = exact_arctangent(cl_RA(j) / 256);
    REQUIRE(cln::abs(exact(node[0]) + exact(node[1]) - value) <= power(-104) * value);
    REQUIRE(node[0] == reference::nearest<double>(value));
  }
}
