// SPDX-License-Identifier: GPL-2.0-or-later
// The exact evaluators against what never saw a formula: powers of the collision law, and the simulator.
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/encounters_exact.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "magicmass/velocities_exact.hpp"

using namespace magicmass;
using cln::cl_I;
using cln::cl_RA;

namespace {

struct Ratios {
  std::mt19937_64 random{5};
  cl_RA next() {  // p/q with p < q mostly: many collisions
    const auto q = static_cast<long>(random() % 400 + 1), p = static_cast<long>(random() % 40 + 1);
    return cl_RA(cl_I(p)) / cl_I(q);
  }
  long index(long last) {
    return static_cast<long>(random() % static_cast<unsigned long>(last + 1));
  }
};

}  // namespace

TEST_CASE("velocities at 1000 random rational ratios are those of the collision law", "[check]") {
  Ratios ratios;
  for (int i = 0; i < 1000; ++i) {
    const cl_RA alpha = ratios.next();
    const long n = ratios.index(40);
    INFO("alpha = " << reference::to_text(alpha) << ", n = " << n);
    const auto got = generated::velocities_exact(alpha, cl_I(n));
    const auto expected = reference::exact_velocities(alpha, cl_I(n));
    CHECK(got.a == expected.a);
    CHECK(got.b == expected.b);
    CHECK((n == 0 || got.c == expected.c));
    CHECK(got.c_prime == expected.c_prime);
  }
}

TEST_CASE("the simulator at exact ratios agrees in every velocity, time, distance and count",
          "[check]") {
  Ratios ratios;
  for (int i = 0; i < 60; ++i) {
    const cl_RA alpha = ratios.next();
    INFO("alpha = " << reference::to_text(alpha));
    long j = 0;
    for (const Event<cl_RA>& event : record_three_body(alpha).events) {
      const auto encounter = generated::encounters_exact(alpha, cl_I(j));
      const auto velocities = generated::velocities_exact(alpha, cl_I(static_cast<long>(event.n)));
      CHECK(event.time == encounter.t);
      CHECK(event.positions.b - event.positions.a == encounter.s);
      const bool at_P = j % 2 == 0;
      CHECK((event.body == Body::A) == at_P);
      CHECK((at_P ? event.after.a : event.after.b) == (at_P ? velocities.a : velocities.b));
      CHECK(event.after.c == (at_P ? velocities.c : velocities.c_prime));
      ++j;
    }
    const reference::LargeCounts counts = reference::count_collisions(alpha);
    CHECK(cl_I(j) == counts.N_A + counts.N_B);
  }
}

TEST_CASE("the single-output functions are the same functions", "[check]") {
  Ratios ratios;
  for (int i = 0; i < 50; ++i) {
    const cl_RA alpha = ratios.next();
    const cl_I n = ratios.index(20);
    const auto all = generated::velocities_exact(alpha, n);
    CHECK(generated::a_exact(alpha, n) == all.a);
    CHECK(generated::b_exact(alpha, n) == all.b);
    CHECK(generated::c_exact(alpha, n) == all.c);
    CHECK(generated::c_prime_exact(alpha, n) == all.c_prime);
  }
}
