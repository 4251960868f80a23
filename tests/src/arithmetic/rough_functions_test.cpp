// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of rough numbers within their stated bounds over their whole domains, against CLN's.
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

/// Numbers up to `most`: uniform, small, and the end, with lows of up to 2^most_low of them.
Columns arguments(std::uint64_t seed, double least, double most, int most_low) {
  Generator generator(seed);
  Columns in;
  const auto add = [&](double x) {
    if (!(x > least && x < most)) return;
    const bool is_pair = whole(generator, 0, 1) == 0;
    append(in, {x, is_pair ? any_low(generator, x)
                           : x * any_double(generator, most_low - 40, most_low - 1)});
  };
  for (int i = 0; i < 3000; ++i) {
    add(std::uniform_real_distribution<double>(least, most)(generator));
    add(log_uniform(generator, 0x1p-300, most));
    add(log_uniform(generator, 0x1p-10, most));
  }
  for (const double x : neighbourhood(0.8, 20)) add(x);
  for (const double x : neighbourhood(0x1.921fb54442d18p+0, 20)) add(x);
  for (const double x : neighbourhood(most, 20)) add(x);
  return in;
}

void require_within(const cl_RA& relative, const cl_RA& absolute, const cl_RA& got,
                    const cl_RA& truth, double& worst) {
  const cl_RA error = cln::abs(got - truth),
              allowed = std::max(cl_RA(relative * cln::abs(truth)), absolute);
  worst = std::max(worst, cln::double_approx(cl_RA(error / allowed)));
  REQUIRE(error <= allowed);
}

}  // namespace

TEST_CASE("polynomials in chains are those in one", "[check]") {
  Generator generator(81);
  Columns in(1);
  for (int i = 0; i < 1000; ++i) in[0].push_back(any_double(generator, -20, 3));
  const cl_RA coefficients[] = {
      exact(0.3), exact(-0.7), exact(0x1.1p-3), exact(5.0), exact(-0.01), exact(0x1.fp1), -1};
  for (const auto& [name, size] :
       {std::pair{"two_chains", 7}, std::pair{"two_even_chains", 4}, std::pair{"one_chain", 7}}) {
    const auto out = the_same_at_every_width(name, in);
    for (std::size_t i = 0; i < in[0].size(); ++i) {
      const cl_RA z = exact(in[0][i]);
      cl_RA value = 0, sizes = 0, z_power = 1;
      for (int k = 0; k < size; ++k, z_power = z_power * z) {
        value = value + coefficients[k] * z_power;
        sizes = sizes + cln::abs(coefficients[k] * z_power);
      }
      INFO(name << " of " << in[0][i]);
      REQUIRE(cln::abs(exact(out[0][i]) - value) <= power(-49) * sizes);
    }
  }
}

TEST_CASE("the rough root is that of alpha (2 + alpha), and of (1 + alpha)^2 from 1 on",
          "[check]") {
  Generator generator(82);
  Columns in(1);
  for (int i = 0; i < 3000; ++i) in[0].push_back(log_uniform(generator, 0x1p-120, 0x1p60));
  for (const double x : neighbourhood(1.0, 20)) in[0].push_back(x);
  for (const double x : {0x1p-120, 0x1p60}) in[0].push_back(x);
  const auto out = the_same_at_every_width("rough_root", in);
  double worst = 0.0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    INFO(in[0][i]);
    const cl_RA alpha = exact(in[0][i]);
    const cl_RA square = in[0][i] >= 1.0 ? cl_RA((1 + alpha) * (1 + alpha)) : alpha * (2 + alpha);
    REQUIRE(cln::abs(exact_pair(out, 0, i) - square) <= power(-100) * square);
    // 1/sqrt(square) = r (1 - e)^(-1/2), e = 1 - r^2 square: its half to the first order
    const cl_RA root = exact_pair(out, 2, i);
    const cl_RA e = 1 - root * root * square;
    worst = std::max(worst, std::fabs(cln::double_approx(cl_RA(e / 2))) * 0x1p66);
    REQUIRE(cln::abs(e / 2) <= power(-66));
    REQUIRE(std::fabs(out[3][i]) <= 0x1p-22 * out[2][i]);
    REQUIRE(static_cast<double>(static_cast<float>(out[2][i])) == out[2][i]);
  }
  CHECK(worst > 0x1p-5);
}

TEST_CASE("the reciprocal of a rough number is within 2^-66 of itself", "[check]") {
  Generator generator(88);
  Columns in(1);
  for (int i = 0; i < 3000; ++i) in[0].push_back(log_uniform(generator, 1.0, 0x1p60));
  for (int i = 0; i < 1000; ++i) in[0].push_back(log_uniform(generator, 0x1p-119, 1.0));
  for (const double x : neighbourhood(1.0, 20)) in[0].push_back(x);
  const auto out = the_same_at_every_width("rough_reciprocal", in);
  double worst = 0.0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    INFO(in[0][i]);
    const cl_RA sum = 1 + exact(in[0][i]);
    REQUIRE(exact_pair(out, 0, i) == sum);
    const cl_RA e = 1 - exact_pair(out, 2, i) * sum;
    worst = std::max(worst, std::fabs(cln::double_approx(e)) * 0x1p66);
    REQUIRE(cln::abs(e) <= power(-66));
    REQUIRE(std::fabs(out[3][i]) <= 0x1p-22 * out[2][i]);
    REQUIRE(static_cast<double>(static_cast<float>(out[2][i])) == out[2][i]);
  }
  CHECK(worst > 0x1p-5);
}

TEST_CASE("the tangent of half an arcsecant is within 2^-59 of itself below 1", "[check]") {
  Generator generator(89);
  Columns in(1);
  for (int i = 0; i < 3000; ++i) in[0].push_back(log_uniform(generator, 0x1p-120, 1.0));
  for (int i = 0; i < 6000; ++i) in[0].push_back(log_uniform(generator, 0x1p-10, 1.0));
  for (const double x : {0x1p-120, std::nextafter(0x1p-120, 1.0), std::nextafter(1.0, 0.0)})
    in[0].push_back(x);
  const auto out = the_same_at_every_width("rough_tangent", in);
  double worst = 0.0, worst_angle = 0.0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    INFO(in[0][i]);
    const cl_RA x = exact(in[0][i]), tangent = exact_pair(out, 0, i);
    const cl_RA e = (tangent * tangent * (2 + x) / x - 1) / 2;  // to the first order
    worst = std::max(worst, std::fabs(cln::double_approx(e)) * 0x1p59);
    REQUIRE(cln::abs(e) <= power(-59));
    REQUIRE(std::fabs(out[1][i]) <= 0x1p-22 * out[0][i]);
    REQUIRE(static_cast<double>(static_cast<float>(out[0][i])) == out[0][i]);
    require_within(power(-53) * 4 / 10, power(-400), exact_pair(out, 2, i),
                   exact_arctangent(tangent), worst_angle);
    REQUIRE(std::fabs(out[3][i]) <= 0x1p-52 * out[2][i]);
  }
  CHECK(worst > 0x1p-4);
  CHECK(worst_angle > 0x1p-2);
}

TEST_CASE("the arctangent of a rough number is within 0.35 2^-53 of itself up to 0.577",
          "[check]") {
  Columns in = arguments(83, 0.0, 0.577, -53);
  Generator generator(84);
  for (std::size_t i = 0; i < in[0].size(); ++i) in[1][i] = any_low(generator, in[0][i]);
  const auto out = the_same_at_every_width("rough_arctangent", in);
  double worst = 0.0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    INFO(in[0][i] << " + " << in[1][i]);
    require_within(power(-53) * 35 / 100, power(-400), exact_pair(out, 0, i),
                   exact_arctangent(exact_pair(in, 0, i)), worst);
    REQUIRE(std::fabs(out[1][i]) <= 0x1p-6 * out[0][i]);
  }
  CHECK(worst > 0x1p-4);
}

TEST_CASE("sine and cosine of a rough number are within 0.5 2^-53 of themselves up to 2.35",
          "[check]") {
  const Columns in = arguments(85, 0.0, 2.35, -6);
  const auto out = the_same_at_every_width("rough_sine_cosine", in);
  double worst = 0.0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    INFO(in[0][i] << " + " << in[1][i]);
    const cl_RA x = exact_pair(in, 0, i);
    if (x > exact(2.35)) continue;
    require_within(power(-54), power(-57), exact_pair(out, 0, i), exact_sine(x), worst);
    require_within(power(-54), power(-57), exact_pair(out, 2, i), exact_cosine(x), worst);
    for (const std::size_t k : {0U, 2U})
      REQUIRE(std::fabs(out[k + 1][i]) <= 0x1p-5 * std::fabs(out[k][i]) + 0x1p-50);
  }
  CHECK(worst > 0x1p-4);
}

TEST_CASE("sine and cosine of a small angle are within 0.3 and 0.35 2^-53", "[check]") {
  Columns in = arguments(86, 0.0, 0x1.0c1524p-1, -53);
  Generator generator(87);
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    // lows of a quarter turn's rounding, which may be all there is
    in[1][i] = whole(generator, 0, 1) == 0 ? any_low(generator, in[0][i])
                                           : any_double(generator, -60, -52);
    if (whole(generator, 0, 9) == 0) in[0][i] = 0.0;
    if (whole(generator, 0, 1) != 0) continue;
    for (const std::size_t k : {0U, 1U}) in[k][i] = -in[k][i];
  }
  const auto out = the_same_at_every_width("rough_sine_cosine", in);
  double worst = 0.0, worst_below = 0.0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    INFO(in[0][i] << " + " << in[1][i]);
    const cl_RA x = exact_pair(in, 0, i);
    require_within(power(-53) * 3 / 10, power(-104), exact_pair(out, 4, i), exact_sine(cln::abs(x)),
                   worst);
    require_within(0, power(-53) * 35 / 100, exact(out[6][i]), 1 - exact_cosine(x), worst_below);
  }
  CHECK(worst > 0x1p-4);
  CHECK(worst_below > 0x1p-4);
}
