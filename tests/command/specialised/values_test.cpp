// SPDX-License-Identifier: GPL-2.0-or-later
// The numbers of generated specialised headers against oracles that see no formula: powers of the collision law, exact counts.
#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <cln/integer.h>
#include <cln/real.h>

#include "magicmass/N_B.hpp"
#include "magicmass/a_c_prime.hpp"
#include "magicmass/a_t_b_t_c_t_rho_N_A_N_B_psi.hpp"
#include "magicmass/a_t_rho.hpp"
#include "magicmass/accurate.hpp"
#include "magicmass/b_psi.hpp"
#include "magicmass/beta_k.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"
#include "magicmass/reference/velocities.hpp"
#include "magicmass/scene_trajectory_a.hpp"
#include "magicmass/t_s.hpp"

using namespace magicmass;

namespace {

double some_alpha(std::mt19937_64& random) {
  return std::pow(10, std::uniform_real_distribution<double>(-5, 1)(random));
}

/// Ulps that half an ulp of alpha is worth at least: 4 times this is what the headers promise. `other` is the exact value
/// a relative step of 2^-30 in alpha further.
double envelope(const cln::cl_RA& value, const cln::cl_RA& other) {
  const double change =
      cln::double_approx(cln::abs(other - value)) / std::fabs(cln::double_approx(value)) * 0x1p30;
  return std::max(0.5, change / 2 * 1.01);
}

struct Last {
  cln::cl_RA a, b, c;
};
Last last_velocities(const cln::cl_RA& alpha, const reference::LargeCounts& counts) {
  const auto at_A = reference::exact_velocities(alpha, counts.N_A);
  const auto at_B = reference::exact_velocities(alpha, counts.N_B);
  return {at_A.a, at_B.b, counts.N_A == counts.N_B ? at_B.c_prime : at_A.c};
}

}  // namespace

TEST_CASE("terminal quantities keep their bound against the collision law", "[check]") {
  std::mt19937_64 random(11);
  for (int i = 0; i < 400; ++i) {
    const double alpha = some_alpha(random);
    if (alpha < 1e-4) continue;  // fractions of megabytes
    const cln::cl_RA exact = reference::exact(alpha);
    const cln::cl_RA further = exact * (1 + cln::cl_RA(1) / (cln::cl_I(1) << 30));
    const reference::LargeCounts counts = reference::count_collisions(exact);
    const Last expected = last_velocities(exact, counts), beside = last_velocities(further, counts);
    INFO("alpha = " << alpha);
    const auto part = generated::a_t_rho::evaluate(alpha).value();
    const auto all = generated::a_t_b_t_c_t_rho_N_A_N_B_psi::evaluate(alpha).value();
    CHECK(cln::cl_I(static_cast<long>(all.N_A)) == counts.N_A);
    CHECK(cln::cl_I(static_cast<long>(all.N_B)) == counts.N_B);
    CHECK(generated::N_B::evaluate(alpha).value().N_B == all.N_B);
    const auto check = [&](double got, const cln::cl_RA& value, const cln::cl_RA& other) {
      CHECK(reference::ulp_error(got, value) <= 4 * envelope(value, other));
    };
    for (const double a_t : {part.a_t, all.a_t}) check(a_t, expected.a, beside.a);
    for (const double rho : {part.rho, all.rho})
      check(rho, expected.b * expected.b, beside.b * beside.b);
    check(all.b_t, expected.b, beside.b);
    check(all.c_t, expected.c, beside.c);
    CHECK(std::fabs(all.psi - accurate::angle(alpha)) <= 1e-15 * all.psi);
  }
}

TEST_CASE("velocities, encounters and ratios keep theirs", "[check]") {
  std::mt19937_64 random(12);
  for (int i = 0; i < 400; ++i) {
    const double alpha = some_alpha(random);
    const cln::cl_RA exact = reference::exact(alpha);
    const cln::cl_RA further = exact * (1 + cln::cl_RA(1) / (cln::cl_I(1) << 30));
    const auto last = static_cast<long>(count_collisions(alpha).value().N_A);
    const long n = std::min(last, 1 + static_cast<long>(random() % 60));
    INFO("alpha = " << alpha << ", n = " << n);
    const auto expected = reference::exact_velocities(exact, cln::cl_I(n));
    const auto beside = reference::exact_velocities(further, cln::cl_I(n));
    const auto got = generated::a_c_prime::evaluate(alpha, n);
    CHECK(reference::ulp_error(got.a, expected.a) <= 4 * envelope(expected.a, beside.a));
    CHECK(reference::ulp_error(got.c_prime, expected.c_prime) <=
          4 * envelope(expected.c_prime, beside.c_prime));
    const auto with_psi = generated::b_psi::evaluate(alpha, n);
    CHECK(reference::ulp_error(with_psi.b, expected.b) <= 4 * envelope(expected.b, beside.b));
    CHECK(std::fabs(with_psi.psi - accurate::angle(alpha)) <= 1e-15 * with_psi.psi);
    const auto encounter = generated::t_s::evaluate(alpha, n);
    const auto nearest = accurate::encounters(alpha, n);
    CHECK(std::fabs(encounter.t - nearest.t) <= 1e-15 * nearest.t);
    CHECK(std::fabs(encounter.s - nearest.s) <= 1e-15 * nearest.s);
  }
  for (std::int64_t k = 1; k < 1000000; k += 1 + k / 3)
    CHECK(reference::ulp_error(generated::beta_k::evaluate(k).beta_k,
                               reference::ratio_within(Deficient{k}, 200)) <= 1);
}

TEST_CASE("a scene's header has a function for each set of inputs", "[exam]") {
  namespace scene = generated::scene_trajectory_a;
  const double alpha = 0.12;
  const auto last = scene::a_t_b_t_c_t_rho_N_A_N_B::evaluate(alpha).value();
  CHECK(last.N_A == 3);
  CHECK(last.rho == Approx(last.b_t * last.b_t));
  CHECK(scene::a_b_c_c_prime::evaluate(alpha, 3).b == Approx(last.b_t));
  CHECK(scene::t_s::evaluate(alpha, 0).s == 1.0);
}

TEST_CASE("what has no answer says so", "[exam]") {
  CHECK_FALSE(generated::a_t_rho::evaluate(1e-40).has_value());
  CHECK_THROWS(generated::a_t_rho::evaluate(-1));
}
