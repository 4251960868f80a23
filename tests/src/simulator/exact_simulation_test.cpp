// SPDX-License-Identifier: GPL-2.0-or-later
// The simulator over exact rationals: nothing is rounded, so everything must hold to the letter.
#include <cstddef>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "magicmass/simulator/contact.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "magicmass/simulator/velocity_stepping.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using cln::cl_RA;

namespace {

cl_RA random_rational(testing::Generator& generator, std::int64_t size) {
  return cl_RA(testing::whole(generator, 1, size)) / testing::whole(generator, 1, size);
}

}  // namespace

TEST_CASE("a contact keeps momentum and energy exactly", "[check]") {
  testing::Generator generator(23);
  for (int i = 0; i < 1000; ++i) {
    const cl_RA m1 = random_rational(generator, 100);
    const cl_RA m2 = random_rational(generator, 100);
    const cl_RA u1 = random_rational(generator, 100) - 1;
    const cl_RA u2 = random_rational(generator, 100) - 1;
    const auto after = collide(m1, u1, m2, u2);
    REQUIRE(m1 * after.first + m2 * after.second == m1 * u1 + m2 * u2);
    REQUIRE(m1 * after.first * after.first + m2 * after.second * after.second ==
            m1 * u1 * u1 + m2 * u2 * u2);
    REQUIRE(after.first - after.second == u2 - u1);  // and it is not the trivial solution
  }
}

TEST_CASE("nothing drifts, bodies take turns and meet where they are, at random V and L",
          "[check]") {
  testing::Generator generator(24);
  for (int i = 0; i < 200; ++i) {
    const cl_RA alpha = random_rational(generator, 100);
    const cl_RA V = random_rational(generator, 10);
    const cl_RA L = random_rational(generator, 10);
    const auto [run, events] = record_three_body(alpha, V, L);
    REQUIRE(run.drift.energy == 0);
    REQUIRE(run.drift.momentum == 0);
    BodyPositions<cl_RA> x{0, L, 0};
    BodyVelocities<cl_RA> v{V, 0, 0};
    cl_RA time = 0;
    for (std::size_t j = 0; j < events.size(); ++j) {
      const Event<cl_RA>& event = events[j];
      const cl_RA passed = event.time - time;
      REQUIRE(event.body == (j % 2 == 0 ? Body::A : Body::B));
      REQUIRE(event.n == static_cast<std::int64_t>(j / 2 + 1));
      REQUIRE((j == 0 ? event.time == 0 : passed > 0));
      REQUIRE(event.positions ==
              BodyPositions<cl_RA>{x.a + v.a * passed, x.b + v.b * passed, x.c + v.c * passed});
      REQUIRE(event.position == event.positions.c);
      REQUIRE(event.position == (event.body == Body::A ? event.positions.a : event.positions.b));
      x = event.positions;
      v = event.after;
      time = event.time;
    }
    REQUIRE(run.terminal == v);
    REQUIRE_FALSE(v.c < v.a);
    REQUIRE_FALSE(v.b < v.c);
    REQUIRE(run.counts == step_velocities(alpha).counts);
  }
}

TEST_CASE("double events follow the exact ones", "[check]") {
  testing::Generator generator(25);
  for (int i = 0; i < 200; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-3, 1e3);
    const auto rounded = record_three_body(alpha);
    const auto exactly = record_three_body(reference::exact(alpha));
    REQUIRE(rounded.run.counts == exactly.run.counts);
    // speeds are at most 2; a few eps a contact add up
    const double bound = 16 * 0x1p-52 * static_cast<double>(exactly.events.size());
    for (std::size_t j = 0; j < exactly.events.size(); ++j) {
      const auto off = [&](double got, const cl_RA& want) {
        return reference::nearest<double>(cln::abs(reference::exact(got) - want));
      };
      REQUIRE(off(rounded.events[j].after.a, exactly.events[j].after.a) <= bound);
      REQUIRE(off(rounded.events[j].after.b, exactly.events[j].after.b) <= bound);
      REQUIRE(off(rounded.events[j].after.c, exactly.events[j].after.c) <=
              bound / std::sqrt(std::min(alpha, 1.0)));
    }
  }
}

TEST_CASE("bad rationals are refused too", "[exam]") {
  CHECK_THROWS_AS(record_three_body(cl_RA(0)), InvalidInput);
  CHECK_THROWS_AS(record_three_body(cl_RA(1), cl_RA(-1)), InvalidInput);
}
