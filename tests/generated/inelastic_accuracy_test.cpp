// SPDX-License-Identifier: GPL-2.0-or-later
// The evaluators with restitution against an oracle of the test's own: contact after contact by the restitution law, in
// 150 digits, and as many contacts as asked for, so that derivatives can be taken at a threshold too.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <cln/float.h>
#include <cln/lfloat.h>
#include <cln/real.h>

#include "magicmass/evaluators.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/restitution.hpp"

using namespace magicmass;
using cln::cl_F;
using cln::cl_I;
using cln::cl_RA;

namespace {

const cln::float_format_t many_digits = cln::float_format(150);

cl_F number(double x) { return cln::cl_float(reference::exact(x), many_digits); }

/// a, b, c and b^2 after so many contacts: A hits the ball, the ball hits B, and so on; typed from mechanics, V = 1.
std::array<cl_F, 4> stepped(const cl_F& alpha, const cl_F& e, long contacts) {
  cl_F a = cln::cl_float(1, many_digits), b = cln::cl_float(0, many_digits), c = b;
  for (long j = 0; j < contacts; ++j) {
    cl_F& block = j % 2 == 0 ? a : b;
    const cl_F loss = (1 + e) * (block - c) / (1 + alpha);
    block = block - alpha * loss;
    c = c + loss;
  }
  return {a, b, c, b * b};
}

struct Sample {
  double alpha, e;
};

/// |x y'(x)/y| from y at x (1 -+ step).
double condition(const cl_F& below, const cl_F& at, const cl_F& above, const cl_F& step) {
  return std::fabs(cln::double_approx((above - below) / (2 * step * at)));
}

/// The larger of this and before: an error in units of max(1/2, cond/2) ulp.
void keep_largest(double& before, double got, const cl_F& exact, double cond) {
  before =
      std::max(before, reference::ulp_error(got, cln::rational(exact)) / std::max(0.5, cond / 2));
}

struct Largest {
  double rounded_once = 0.0;  // fast::terminal
  double in_double = 0.0;     // the generated evaluators in double
};

Largest largest_errors(const std::vector<Sample>& samples) {
  Largest largest;
  const cl_F step = cln::scale_float(cln::cl_float(1, many_digits), -160);
  int compared = 0;
  for (const auto& [alpha, e] : samples) {
    const auto large = reference::count_collisions(MassRatio(alpha), reference::exact(e));
    REQUIRE(large);
    const Counts counts{cln::cl_I_to_long(large->N_A), cln::cl_I_to_long(large->N_B)};
    const long N = counts.N_A + counts.N_B;
    if (N > 2000) continue;
    ++compared;
    INFO("alpha = " << alpha << ", e = " << e << ", N = " << N);
    const auto once = fast::terminal(alpha, e, counts);
    const auto plain = N == 2 ? generated::two_collisions_rational(alpha, e)
                       : counts.N_A == counts.N_B
                           ? generated::terminal_after_Q(alpha, e, counts.N_B)
                           : generated::terminal_after_P(alpha, e, counts.N_B);
    const cl_F x = number(alpha), y = number(e);
    const auto at = stepped(x, y, N), less = stepped(x * (1 - step), y, N),
               more = stepped(x * (1 + step), y, N), lower = stepped(x, y * (1 - step), N),
               higher = stepped(x, y * (1 + step), N);
    const double rounded[] = {once.a_t, once.b_t, once.c_t, once.rho};
    const double doubles[] = {plain.a_t, plain.b_t, plain.c_t, plain.rho};
    for (std::size_t i = 0; i < 4; ++i) {
      if (cln::zerop(cln::rational(at[i])) ||
          cln::abs(at[i]) < cln::cl_float(reference::exact(1e-290), many_digits))
        continue;
      const double cond =
          condition(less[i], at[i], more[i], step) + condition(lower[i], at[i], higher[i], step);
      keep_largest(largest.rounded_once, rounded[i], at[i], cond);
      keep_largest(largest.in_double, doubles[i], at[i], cond);
    }
  }
  CHECK(compared > 50);
  return largest;
}

double alpha_c(double e) {
  const long double root = std::sqrt(static_cast<long double>(e));
  return static_cast<double>((1 - root) * (1 - root) / (2 * root));
}

class Samples {
public:
  explicit Samples(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double restitution() {
    switch (random_() % 4) {
      case 0:
        return 1 - std::exp2(between(-40, -1));
      case 1:
        return std::exp2(between(-20, -1));
      case 2:
        return random_() % 4 == 0 ? 1.0 : 0.5;
      default:
        return between(0.05, 1);
    }
  }
  template <class Ratio>
  std::vector<Sample> of(int count, const Ratio& ratio) {
    std::vector<Sample> all;
    while (count-- > 0) {
      const double e = restitution();
      const double alpha = ratio(e);
      if (alpha > alpha_c(e) * (1 + 1e-12)) all.push_back({alpha, e});
    }
    return all;
  }

private:
  std::mt19937_64 random_;
};

}  // namespace

TEST_CASE("terminal velocities with restitution keep the errors that are stated", "[check]") {
  Samples samples(1);
  const auto check = [](const char* family, const std::vector<Sample>& all) {
    INFO(family);
    const Largest largest = largest_errors(all);
    CHECK(largest.rounded_once <= 4);
    CHECK(largest.in_double <= 16);
    CHECK(largest.in_double > 4);  // so the check can fail
  };
  check("everyday", samples.of(500, [&](double e) {
    return alpha_c(e) + std::pow(10, samples.between(-3, 2));
  }));
  check("large alpha",
        samples.of(100, [&](double) { return std::pow(10, samples.between(1, 70)); }));
  check("near the collapse", samples.of(80, [&](double e) {
    return alpha_c(e) * (1 + std::exp2(samples.between(-16, 2)));
  }));
  check("thresholds", samples.of(200, [&](double e) {
    const double m = std::floor(std::exp2(samples.between(1.6, 7)));
    const double at = (1 + e) / (2 * std::sqrt(e) * std::cos(std::acos(-1) / m)) - 1;
    return at * (1 + std::floor(samples.between(-3, 4)) * 0x1p-52);
  }));
}

namespace {

/// When so many contacts have happened, by flights and contacts, L = V = 1. With C = cosh(eta) what is left of the
/// time falls by exp(-4 eta) a cycle.
cl_F time_of(const cl_F& alpha, const cl_F& e, long contacts) {
  const cl_F zero = cln::cl_float(0, many_digits);
  cl_F a = cln::cl_float(1, many_digits), b = zero, c = zero, time = zero;
  cl_F gap_A = zero, gap_B = a;
  for (long j = 0; j < contacts; ++j) {
    const cl_F wait = j % 2 == 0 ? cl_F(gap_A / (a - c)) : cl_F(gap_B / (c - b));
    time = time + wait;
    gap_A = gap_A + (c - a) * wait;
    gap_B = gap_B + (b - c) * wait;
    cl_F& block = j % 2 == 0 ? a : b;
    const cl_F loss = (1 + e) * (block - c) / (1 + alpha);
    block = block - alpha * loss;
    c = c + loss;
  }
  return time;
}

}  // namespace

TEST_CASE("the time of a collapse is the limit of stepping, within the errors that are stated",
          "[check]") {
  Samples samples(2);
  Largest largest;
  const cl_F step = cln::scale_float(cln::cl_float(1, many_digits), -40);
  for (int i = 0; i < 200; ++i) {
    const double e = samples.between(0.001, 0.3), alpha = alpha_c(e) * samples.between(0.01, 0.9);
    INFO("alpha = " << alpha << ", e = " << e);
    const double growth = std::acosh((1 + e) / (2 * std::sqrt(e) * (1 + alpha)));
    const auto contacts = static_cast<long>(60 / growth);  // exp(-120): 52 digits
    const auto time = [&](const cl_F& x, const cl_F& y) { return time_of(x, y, contacts); };
    const cl_F x = number(alpha), y = number(e), at = time(x, y);
    const double cond = condition(time(x * (1 - step), y), at, time(x * (1 + step), y), step) +
                        condition(time(x, y * (1 - step)), at, time(x, y * (1 + step)), step);
    keep_largest(largest.rounded_once, fast::collapse_time(alpha, e), at, cond);
    keep_largest(largest.in_double, generated::collapse_product(alpha, e), at, cond);
  }
  CHECK(largest.rounded_once <= 4);
  CHECK(largest.in_double <= 16);
}
