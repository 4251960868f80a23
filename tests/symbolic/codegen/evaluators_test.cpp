// SPDX-License-Identifier: GPL-2.0-or-later
// Emitted evaluators against the definitions, in floats of 90 digits: rounded results, counts, and
// each bound's margin. A bound that is too small, or twenty times too large, fails.
#include <cmath>
#include <map>
#include <random>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/real.h>

#include "catch.hpp"
#include "codegen/exact.hpp"
#include "magicmass/arithmetic/rounding_test.hpp"
#include "samples/evaluators/angle.hpp"
#include "samples/evaluators/deficient.hpp"
#include "samples/evaluators/magic.hpp"
#include "samples/evaluators/terminal.hpp"
#include "samples/evaluators/velocities.hpp"
#include "samples/plain/product.hpp"

namespace {
using namespace magicmass::generated;
using cln::cl_R;
using magicmass::arithmetic::DoubleDouble;
using Number = DoubleDouble<double>;

cl_R wide(double x) { return cln::cl_float(codegen::exact(x), cln::float_format(90)); }
cl_R wide(std::int64_t n) { return wide(double(n)); }
cl_R sine(const cl_R& x) { return cln::sin(x); }
cl_R cosine(const cl_R& x) { return cln::cos(x); }
/// cos h = 1/(1 + alpha), by the tangent.
cl_R half_psi(double alpha) {
  const cl_R a = wide(alpha);
  return cln::atan(cln::sqrt(a * (a + 2)));
}
/// a, b, c, c' after n cycles: the paper's formulas.
std::vector<cl_R> velocities(double alpha, const cl_R& n) {
  const cl_R a = wide(alpha);
  const cl_R h = half_psi(alpha);
  const cl_R v = 2 / (a + 2);
  const cl_R plus = (n + wide(0.5)) * h;
  const cl_R minus = (n - wide(0.5)) * h;
  const cl_R over = sine(n * h) / sine(h / 2);
  return {v * (a + 1) * cosine(plus) * cosine(minus), v * (a + 1) * sine((n + 1) * h) * sine(n * h),
          v * over * cosine(minus), -(v * over * cosine(plus))};
}
double rounded(const cl_R& x) { return codegen::nearest(cln::rational(x)); }
double off(const Number& got, const cl_R& exact) {
  const cln::cl_RA value = codegen::exact(got.high) + codegen::exact(got.low);
  return std::fabs(rounded(value - exact));
}

/// Runs one case, and notes the largest share of each bound that is seen.
class Margins {
public:
  template <template <class, class> class Case, class Tier, class Inputs>
  Case<Tier, Number> run(const Inputs& in) {
    Case<Tier, Number> k(in);
    k.stage_1();
    k.stage_2();
    k.stage_3();
    return k;
  }
  void note(const std::string& name, const Number& got, const cl_R& exact, double bound) {
    // The rounding test's own roundings are part of the bound.
    largest[name] = std::max(largest[name], off(got, exact) / bound);
  }
  std::map<std::string, double> largest;
};
double uniform(std::mt19937_64& random) { return double(random() >> 11) * 0x1p-53; }
}  // namespace

TEMPLATE_TEST_CASE("velocities are within their bounds, and rounded right", "", Accurate, Slow) {
  std::mt19937_64 random(11);
  Margins margins;
  using B = VelocitiesSmallBounds<TestType>;
  for (int row = 0; row < 400; ++row) {
    const double alpha = std::exp(std::log(1e-8) * uniform(random));
    const double last = std::floor(1.5707 / std::atan(std::sqrt(alpha * (2 + alpha))));
    const auto n = std::int64_t(1 + std::floor(last / 2 * uniform(random)));
    const std::vector<cl_R> v = velocities(alpha, wide(n));
    const auto k = margins.run<VelocitiesSmall, TestType>(VelocitiesInputs{alpha, n});
    const auto size = [](const Number& x) { return std::fabs(x.high); };
    const Number P = cancelling_sum(k.C, k.t * k.S);
    const Number M = cancelling_sum(k.C, -(k.t * k.S));
    const Number Q = cancelling_sum(k.C, k.w * k.S);
    const Number tS = k.t * k.S;
    const Number wS = k.w * k.S;
    margins.note("a", P * M, v[0], size(P) * B::E[0] + size(M) * B::E[1] + B::E[2]);
    margins.note("b", scaled(Q * tS, 2), v[1], size(tS) * (size(wS) * B::E[3] + B::E[4]));
    margins.note("c", scaled(P * wS, 2), v[2], size(wS) * B::E[5]);
    margins.note("c'", scaled(M * wS, -2), v[3], size(wS) * B::E[6]);
    if (k.doubt != 0.0) continue;
    REQUIRE(k.a == rounded(v[0]));
    REQUIRE(k.b == rounded(v[1]));
    REQUIRE(k.c == rounded(v[2]));
    REQUIRE(k.c_prime == rounded(v[3]));
  }
  for (const auto& [name, share] : margins.largest) {
    INFO(name);
    CHECK(share <= 1);
    // Slow's bounds allow for the low part of a turned angle at its worst, which is not seen.
    CHECK(share > (std::is_same_v<TestType, Slow> ? 0.003 : 0.04));
  }
}
TEST_CASE("terminal velocities and counts are right where nothing is in doubt") {
  std::mt19937_64 random(12);
  int in_doubt = 0;
  for (int row = 0; row < 400; ++row) {
    const double alpha = std::exp(std::log(1e-10) * uniform(random));
    const cln::cl_I last = cln::ceiling1(cln::pi(cln::float_format(90)) / half_psi(alpha)) - 1;
    const cln::cl_I N_A = cln::floor1(last + 1, 2);
    const cln::cl_I N_B = cln::floor1(last, 2);
    TerminalOutputs got{};
    const double doubt = Terminal::visit<false>({alpha}, [&]<template <class, class> class Case>() {
      const auto k = Margins().run<Case, Accurate>(TerminalInputs{alpha});
      got = k.outputs();
      return k.doubt;
    });
    if (doubt != 0.0) {
      ++in_doubt;
      continue;
    }
    REQUIRE(got.N_A == cln::cl_I_to_long(N_A));
    REQUIRE(got.N_B == cln::cl_I_to_long(N_B));
    const cln::float_format_t format = cln::float_format(90);
    const std::vector<cl_R> x = velocities(alpha, cln::cl_float(N_A, format));
    const std::vector<cl_R> y = velocities(alpha, cln::cl_float(N_B, format));
    REQUIRE(got.a_t == rounded(x[0]));
    REQUIRE(got.b_t == rounded(y[1]));
    REQUIRE(got.c_t == rounded(N_A == N_B ? y[3] : x[2]));
    REQUIRE(got.rho == rounded(y[1] * y[1]));
  }
  CHECK(in_doubt < 100);
}
TEST_CASE("ratios and the angle are rounded right") {
  std::mt19937_64 random(13);
  const cl_R pi = cln::pi(cln::float_format(90));
  for (int row = 0; row < 300; ++row) {
    const auto k = std::int64_t(2 + std::floor(std::exp(20 * uniform(random))));
    const auto ratio = [&](const cl_R& x) {
      const cl_R s = sine(x / 2);
      return 2 * s * s / cosine(x);
    };
    const auto magic = Margins().run<MagicGeneral, Accurate>(MagicInputs{k});
    if (magic.doubt == 0.0) REQUIRE(magic.magic == rounded(ratio(pi / (2 * wide(k) + 1))));
    const auto deficient = Margins().run<DeficientGeneral, Accurate>(DeficientInputs{k});
    if (deficient.doubt == 0.0) {
      REQUIRE(deficient.deficient == rounded(ratio(pi / (2 * (wide(k) + 1)))));
    }
    const double alpha = 1 / double(k);
    const auto angle = Margins().run<AngleSmall, Accurate>(AngleInputs{alpha});
    if (angle.doubt == 0.0) REQUIRE(angle.psi == rounded(2 * half_psi(alpha)));
  }
}
TEST_CASE("what is outside of a case's intervals is not answered") {
  const auto visited = [](double alpha, std::int64_t n) {
    return Velocities::visit<false>({alpha, n},
                                    []<template <class, class> class>() { return 0.0; });
  };
  CHECK(visited(0x1p-300, 0) == 0.0);
  CHECK(visited(std::nextafter(0x1p-300, 0), 0) == 1.0);
  CHECK(visited(0x1.fffffffffffffp-1, 0) == 0.0);
  CHECK(visited(1.0, 0) == 1.0);
  CHECK(visited(0.5, std::int64_t(1) << 50) == 0.0);
  CHECK(visited(0.5, (std::int64_t(1) << 50) + 1) == 1.0);
  CHECK(visited(0.5, -1) == 1.0);
  CHECK(visited(NAN, 0) == 1.0);
  // Past the last cycle the angle is beyond its guard: alpha = 1/2 has N_A = 2.
  CHECK(Margins().run<VelocitiesSmall, Accurate>(VelocitiesInputs{0.5, 2}).doubt == 0.0);
  CHECK(Margins().run<VelocitiesSmall, Accurate>(VelocitiesInputs{0.5, 5}).doubt != 0.0);
}
TEST_CASE("plain forms of any real type are near the definitions") {
  const double alpha = 0.1;
  const std::vector<cl_R> v = velocities(alpha, wide(2.0));
  const auto got = velocities_product<double>(alpha, 2);
  CHECK_THAT(got.a, WithinRel(rounded(v[0]), 0x1p-46));
  CHECK_THAT(got.c_prime, WithinRel(rounded(v[3]), 0x1p-46));
  const auto wider = velocities_product<long double>(0.1L, 2);
  CHECK_THAT(double(wider.b), WithinRel(got.b, 0x1p-46));
  CHECK(terminal_product<double>(alpha).N_A == 4);
}
