// SPDX-License-Identifier: GPL-2.0-or-later
// The evaluators with restitution against an oracle of the test's own: contact after contact by the restitution law, in
// 150 digits, and exactly that number of contacts, so that derivatives can be taken at a threshold too.
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
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/restitution.hpp"

using namespace magicmass;
using cln::cl_F;
using cln::cl_I;
using cln::cl_RA;

namespace {

const cln::float_format_t many_digits = cln::float_format(150);

cl_F number(double x) { return cln::cl_float(reference::exact(x), many_digits); }

struct State {
  cl_F a, b, c;
};

/// A hits the ball, the ball hits B, and so on; typed from mechanics, block masses 1.
State stepped(const cl_F& alpha, const cl_F& e, long contacts) {
  const cl_F zero = cln::cl_float(0, many_digits), one = cln::cl_float(1, many_digits);
  State s{one, zero, zero};
  for (long j = 0; j < contacts; ++j) {
    cl_F& block = j % 2 == 0 ? s.a : s.b;
    const cl_F impulse = (1 + e) * (block - s.c) * alpha / (1 + alpha);
    block = block - impulse;
    s.c = s.c + impulse / alpha;
  }
  return s;
}

std::array<cl_F, 4> exact_values(const cl_F& alpha, const cl_F& e, long contacts) {
  const State s = stepped(alpha, e, contacts);
  return {s.a, s.b, s.c, s.b * s.b};
}

/// |x y'(x)/y|, to many digits more than it takes.
double condition(const cl_F& x, const cl_F& below, const cl_F& at, const cl_F& above,
                 const cl_F& step) {
  (void)x;
  return std::fabs(cln::double_approx((above - below) / (2 * step * at)));
}

struct Sample {
  double alpha, e;
};

/// Largest error in units of max(1/2, cond/2) ulp, cond the sum of both condition numbers, and where.
struct Worst {
  double over_envelope = 0.0;
  double ulp = 0.0;
  std::string where;
};

template <class Real>
Worst worst_of(const std::vector<Sample>& samples) {
  Worst worst;
  const cl_F step = cln::scale_float(cln::cl_float(1, many_digits), -160);
  for (const auto& [alpha, e] : samples) {
    const auto counts = reference::count_collisions(MassRatio(alpha), reference::exact(e));
    if (!counts) continue;
    const long k = cln::cl_I_to_long(counts->N_B), N = k + cln::cl_I_to_long(counts->N_A);
    const auto got =
        N == 2 ? generated::two_collisions_rational<Real>(static_cast<Real>(alpha),
                                                          static_cast<Real>(e))
        : counts->N_A == counts->N_B
            ? generated::terminal_after_Q<Real>(static_cast<Real>(alpha), static_cast<Real>(e), k)
            : generated::terminal_after_P<Real>(static_cast<Real>(alpha), static_cast<Real>(e), k);
    const cl_F x = number(alpha), y = number(e);
    const auto at = exact_values(x, y, N), less = exact_values(x * (1 - step), y, N),
               more = exact_values(x * (1 + step), y, N),
               lower = exact_values(x, y * (1 - step), N),
               higher = exact_values(x, y * (1 + step), N);
    const std::array<Real, 4> values{got.a_t, got.b_t, got.c_t, got.rho};
    for (std::size_t i = 0; i < 4; ++i) {
      const double cond = condition(x, less[i], at[i], more[i], step) +
                          condition(y, lower[i], at[i], higher[i], step);
      const double error =
          reference::ulp_error(static_cast<double>(values[i]), cln::rational(at[i]));
      const double relative = error / std::max(0.5, cond / 2);
      worst.ulp = std::max(worst.ulp, error);
      if (!(relative > worst.over_envelope)) continue;
      worst.over_envelope = relative;
      worst.where = "member " + std::to_string(i) + " at alpha = " + std::to_string(alpha) +
                    ", e = " + std::to_string(e) + ", N = " + std::to_string(N) + " cond " +
                    std::to_string(cond) + " err " + std::to_string(error);
    }
  }
  return worst;
}

double alpha_c(double e) {
  return static_cast<double>((1 - std::sqrt(static_cast<long double>(e))) *
                             (1 - std::sqrt(static_cast<long double>(e))) /
                             (2 * std::sqrt(static_cast<long double>(e))));
}

std::vector<Sample> everyday(int count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-3.5, 2), part(0.05, 1);
  std::vector<Sample> all;
  for (int i = 0; i < count; ++i) {
    const double e = i % 4 == 0 ? 1 - std::exp2(-30 * part(random)) : part(random);
    all.push_back({alpha_c(e) + std::pow(10, exponent(random)), e});
  }
  return all;
}

std::vector<Sample> near_collapse(int count) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> part(0.02, 0.98), bits(1, 20);
  std::vector<Sample> all;
  for (int i = 0; i < count; ++i) {
    const double e = part(random);
    all.push_back({alpha_c(e) * (1 + std::exp2(-bits(random))), e});
  }
  return all;
}
}  // namespace

TEST_CASE("terminal velocities with restitution keep within 4 envelopes", "[check]") {
  for (const auto& [name, samples] :
       {std::pair{"everyday", everyday(4000)}, {"near collapse", near_collapse(400)}}) {
    const Worst wide = worst_of<long double>(samples), narrow = worst_of<double>(samples);
    WARN(name << " long double: " << wide.over_envelope << " " << wide.ulp << " " << wide.where);
    WARN(name << " double: " << narrow.over_envelope << " " << narrow.ulp << " " << narrow.where);
  }
}
