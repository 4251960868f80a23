// SPDX-License-Identifier: GPL-2.0-or-later
// The energy that reaches B with restitution, against stepping in rational numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <cln/float.h>
#include <cln/rational.h>
#include <cln/real.h>

#include "batch/instruction_sets.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/fast.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using cln::cl_RA;

namespace {

/// Collisions one by one, typed from the restitution law; -1 if there are more than 300.
cl_RA stepped_rho(const cl_RA& alpha, const cl_RA& e) {
  cl_RA a = 1, b = 0, c = 0;
  for (int j = 0; j < 300; ++j) {
    cl_RA& block = j % 2 == 0 ? a : b;
    const cl_RA approach = j % 2 == 0 ? a - c : c - b;
    if (!cln::plusp(approach)) return b * b;
    const cl_RA to_ball = (1 + e) * (block - c) / (1 + alpha);
    block = block - alpha * to_ball;
    c = c + to_ball;
  }
  return -1;
}

std::vector<double> rhos(const std::vector<double>& alpha, double e, InstructionSet set) {
  std::vector<double> rho(alpha.size());
  fast::transmission(alpha, e, rho, set);
  return rho;
}

cl_RA exactly(double x) { return cln::rational(cln::cl_DF(x)); }
double as_double(const cl_RA& x) { return cln::double_approx(x); }

/// The error over max(1/2, cond/2) ulp, with slopes from differences; no more than `most` in any row.
void require_within(double most, const std::vector<double>& alphas, double e) {
  const cl_RA exact_e = exactly(e), step = exactly(0x1p-40);
  const auto got = rhos(alphas, e, best_instruction_set());
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    const cl_RA alpha = exactly(alphas[i]), rho = stepped_rho(alpha, exact_e);
    INFO("alpha = " << alphas[i] << ", e = " << e);
    REQUIRE(rho >= 0);
    const cl_RA in_alpha = stepped_rho(alpha * (1 + step), exact_e) - rho;
    const cl_RA in_e = e == 1.0 ? cl_RA(0) : stepped_rho(alpha, exact_e * (1 - step)) - rho;
    const double condition = as_double((cln::abs(in_alpha) + cln::abs(in_e)) / step / rho);
    const double nearest = as_double(rho);
    const double ulp = std::nextafter(nearest, 2.0) - nearest;
    const double error = std::fabs(as_double(exactly(got[i]) - rho)) / ulp;
    REQUIRE(error <= most * std::max(0.5, 0.5 * condition));
  }
}

double lightest(double e) {  // alpha_c, typed from the paper
  return (1.0 - std::sqrt(e)) * (1.0 - std::sqrt(e)) / (2.0 * std::sqrt(e));
}

}  // namespace

TEST_CASE("the energy that reaches B with restitution is that of stepping", "[check]") {
  testing::Generator generator(90);
  for (const double e : {1.0, 0.9, 0.8, 0.7, 0.5, 0.25, 0.071, 1e-3}) {
    std::vector<double> alphas{lightest(e) * 1.1 + 1e-3, 1e6, 1e60, 1e120};
    for (int i = 0; i < 60; ++i)
      alphas.push_back(lightest(e) + testing::log_uniform(generator, 3e-3, 1e3));
    require_within(4.0, alphas, e);
  }
}

TEST_CASE("no kink where a collision more comes in", "[exam]") {
  // N = pi/h is whole where cos(pi/(N + 1)) = (1 + e)/(2 sqrt(e) (1 + alpha)): doubles next to that.
  for (const double e : {1.0, 0.9, 0.5})
    for (int N = 2; N < 12; ++N) {
      const double alpha = (1.0 + e) / (2.0 * std::sqrt(e) * std::cos(M_PI / (N + 1))) - 1.0;
      require_within(4.0, {std::nextafter(alpha, 0.0), alpha, std::nextafter(alpha, 2.0)}, e);
    }
}

TEST_CASE("transmission has the same bits on every instruction set, tails and all", "[exam]") {
  testing::Generator generator(91);
  for (std::size_t size = 0; size < 40; ++size) {
    std::vector<double> alphas;
    for (std::size_t i = 0; i < size; ++i)
      alphas.push_back(0.01 + testing::log_uniform(generator, 1e-3, 1e3));
    for (const double e : {1.0, 0.85}) {
      const auto expected = rhos(alphas, e, InstructionSet::baseline);
      for (const InstructionSet set : testing::available_instruction_sets())
        CHECK(rhos(alphas, e, set) == expected);
    }
  }
}

TEST_CASE("elastic transmission is rho after the last collision", "[exam]") {
  const std::vector<double> alphas{
      std::numeric_limits<double>::denorm_min(), 1e-40, 1e-30, 1e-9, 0.12, 0.1, 1.0, 1e30, 1e200};
  const auto got = rhos(alphas, 1.0, best_instruction_set());
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    const auto one = fast::terminal(alphas[i]);
    INFO(alphas[i]);
    if (one)
      CHECK(std::fabs(got[i] - one->rho) <= 0x1p-50 * one->rho);
    else
      CHECK(std::isnan(got[i]));
  }
}

TEST_CASE("where there is no last collision there is no transmission", "[exam]") {
  // alpha_c(1/4) is 1/4, exactly
  const auto got = rhos({0.25, std::nextafter(0.25, 0.0), std::nextafter(0.25, 1.0), 1e-300, -1.0,
                         0.0, INFINITY, NAN, 0.26},
                        0.25, best_instruction_set());
  for (const std::size_t row : std::array<std::size_t, 7>{0, 1, 3, 4, 5, 6, 7})
    CHECK(std::isnan(got[row]));
  CHECK(got[2] > 0.0);
  CHECK(got[8] > 0.0);
}

TEST_CASE("a collapse is told from a last collision to the last bit of alpha", "[exam]") {
  // the collisions end where 4 e (1 + alpha)^2 > (1 + e)^2
  const auto ends = [](double alpha, double e) {
    const cl_RA x = exactly(e), heavy = 1 + exactly(alpha);
    return 4 * x * heavy * heavy > (1 + x) * (1 + x);
  };
  for (const double e : {0.99999, 0.9, 0.8, 0.7, 0.3, 0.01}) {
    std::vector<double> alphas{lightest(e)};
    for (int i = 0; i < 60; ++i) alphas[0] = std::nextafter(alphas[0], 0.0);
    while (alphas.size() < 120) alphas.push_back(std::nextafter(alphas.back(), 1e9));
    const bool first_ends = ends(alphas.front(), e), last_ends = ends(alphas.back(), e);
    if (e < 0.9999) CHECK((!first_ends && last_ends));
    for (const InstructionSet set : testing::available_instruction_sets()) {
      const auto got = rhos(alphas, e, set);
      for (std::size_t i = 0; i < alphas.size(); ++i) {
        INFO("alpha = " << alphas[i] << ", e = " << e << ", " << to_text(set));
        CHECK(std::isnan(got[i]) != ends(alphas[i], e));
      }
    }
  }
}

TEST_CASE("a restitution that is none is refused", "[exam]") {
  for (const double e : {0.0, -0.5, 1.0000001, double(NAN), double(INFINITY), 1e-300})
    CHECK_THROWS_AS(rhos({0.5}, e, best_instruction_set()), InvalidInput);
  CHECK_THROWS_WITH(rhos({0.5}, 1.5, best_instruction_set()),
                    "a restitution must be at least 2^-400 and at most 1, got 1.5");
}
