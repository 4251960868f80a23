// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/exact_velocities.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "random_numbers.hpp"
#include "report/last_collision.hpp"

using namespace magicmass;
using namespace magicmass::report;

namespace {

// |exact - (high + low)| <= 2^-120 |exact|
bool is_close(const ExactValue& value, const cln::cl_RA& exact) {
  const cln::cl_RA kept = reference::exact(value.high) + reference::exact(value.low);
  return !(cln::abs(exact) < cln::abs(kept - exact) * cln::cl_RA(cln::ash(cln::cl_I(1), 120)));
}

}  // namespace

TEST_CASE("velocities are those of exact rationals, on both sides of the short ones", "[check]") {
  testing::Generator generator(11);
  for (int i = 0; i < 60; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-5, 1.0);
    const std::int64_t n = testing::whole(generator, 0, last_collision(alpha).N_A);
    if (n > 60) continue;
    const auto found = exact_velocities({alpha, n});
    const auto exact =
        reference::exact_velocities(reference::exact(alpha), cln::cl_I(static_cast<long>(n)));
    const cln::cl_RA members[] = {exact.a, exact.b, exact.c, exact.c_prime};
    for (std::size_t m = 0; m < 4; ++m) {
      CHECK(is_close(found[m], members[m]));
      CHECK(found[m].nearest_double == reference::nearest<double>(members[m]));
      CHECK(found[m].nearest_float == reference::nearest<float>(members[m]));
      CHECK(found[m].high == reference::nearest<long double>(members[m]));
    }
  }
}

TEST_CASE("the condition is that of a_1 = (1-alpha)/(1+alpha) and b_1 = 4 alpha/(1+alpha)^2",
          "[exam]") {
  for (const double alpha : {1e-10, 0.3, 0.9, 7.0, 1e10}) {
    const auto found = exact_velocities({alpha, 1});
    const double of_a = std::fabs(2 * alpha / (1 - alpha * alpha));
    // certainly below 1/16 it is given as 0: the envelope is 1/2 there
    if (of_a > 0.1) CHECK(found[0].condition == Approx(of_a).epsilon(0.01));
    const double of_b = std::fabs((1 - alpha) / (1 + alpha));
    if (of_b > 0.1) CHECK(found[1].condition == Approx(of_b).epsilon(0.01));
  }
}

TEST_CASE("zeros, ties and ends are exact", "[exam]") {
  const auto at_one = exact_velocities({1.0, 1});  // everything to B
  CHECK(at_one[0].high == 0);
  CHECK(at_one[1].high == 1);
  CHECK(at_one[2].high == 1);
  CHECK(at_one[3].high == 0);
  const auto at_start = exact_velocities({0x1p-60, 0});
  CHECK(at_start[0].high == 1);
  CHECK(at_start[1].high == 0);
  const auto three = exact_velocities({3.0, 1});  // a_1 = -1/2
  CHECK(three[0].high == -0.5L);
  CHECK(three[0].low == 0);
}

TEST_CASE("the collision that does not take place does not exist", "[exam]") {
  // At 0.1 there are 4 A-C and 3 C-B collisions (Ee & Lee, sec. Results).
  const auto last = exact_velocities({0.1, 4});
  CHECK(last[0].exists);
  CHECK_FALSE(last[1].exists);
  CHECK(last[2].exists);
  CHECK_FALSE(last[3].exists);
}

TEST_CASE("the largest velocities are those of all collisions", "[exam]") {
  for (const double alpha : {1e-4, 0.003, 0.02, 0.1, 0.25, 0.3, 0.9, 1.0, 3.0, 1e6}) {
    const LastCollision last = last_collision(alpha);
    double B = 0, C = 0;
    for (std::int64_t n = 1; n <= last.N_A; ++n) {
      const auto v =
          reference::velocities_within(MassRatio(alpha), cln::cl_I(static_cast<long>(n)), 64);
      C = std::max(C, std::fabs(cln::double_approx(v.c)));
      if (n > last.N_B) continue;
      B = std::max(B, std::fabs(cln::double_approx(v.b)));
      C = std::max(C, std::fabs(cln::double_approx(v.c_prime)));
    }
    const LargestVelocities found = largest_velocities(alpha);
    CHECK(found.B == Approx(B).epsilon(1e-9));
    CHECK(found.C == Approx(C).epsilon(1e-9));
  }
  // the continuous limit, 1/sqrt(2 alpha) + 1/2
  CHECK(largest_velocities(1e-20).C == Approx(1 / std::sqrt(2e-20)).epsilon(1e-6));
  CHECK(std::isfinite(largest_velocities(5e-324).C));
}
