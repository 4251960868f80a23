// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/velocities.hpp"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/reference/decimal.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/velocity_stepping.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using namespace magicmass::reference;
using cln::cl_I;
using cln::cl_RA;

namespace {

cl_RA random_ratio(testing::Generator& generator) {
  const std::int64_t size = testing::whole(generator, 1, 3) == 1 ? 20 : 1000;
  return cl_RA(testing::whole(generator, 1, size)) / testing::whole(generator, 1, size);
}

}  // namespace

TEST_CASE("alpha = 1/7 by hand", "[exam]") {
  // P_1: 3/4, 7/4. Q_1: 7/32, hence 7/16 and 7/16 - 7/4 = -21/16.
  CHECK(exact_velocities(cl_RA(1) / 7, 1) ==
        CycleVelocities<cl_RA>{cl_RA(3) / 4, cl_RA(7) / 16, cl_RA(7) / 4, cl_RA(-21) / 16});
  CHECK(
      exact_velocities(cl_RA(1) / 7, 2) ==
      CycleVelocities<cl_RA>{cl_RA(15) / 64, cl_RA(231) / 256, cl_RA(147) / 64, cl_RA(-245) / 256});
}

TEST_CASE("n = 0 is the initial condition, for any alpha and exactly", "[exam]") {
  CHECK(exact_velocities(cl_RA(5) / 3, 0) == CycleVelocities<cl_RA>{1, 0, 0, 0});
  CHECK(velocities_within(Magic{3}, 0, 50) == CycleVelocities<cl_RA>{1, 0, 0, 0});
  CHECK(certified_digits(Deficient{3}, 0, 4) ==
        CycleVelocities<std::string>{"1.000", "0", "0", "0"});
}

TEST_CASE("equal masses go round in three cycles, for an n of any size", "[exam]") {
  const cl_I huge = 3 * cln::expt_pos(cl_I(10), cl_I(40));
  CHECK(exact_velocities(1, huge) == CycleVelocities<cl_RA>{1, 0, 0, 0});
  CHECK(exact_velocities(1, huge + 1) == CycleVelocities<cl_RA>{0, 1, 1, 0});
  CHECK(certified_digits(Magic{1}, huge + 2, 3) == certified_digits(1.0, 2, 3));
  CHECK(certified_digits(1.0, 2, 3) == CycleVelocities<std::string>{"0", "0", "0", "1.00"});
}

TEST_CASE("the matrix power is what stepping the collisions gives, for 1000 random alpha and n",
          "[check]") {
  testing::Generator generator(17);
  for (int i = 0; i < 1000; ++i) {
    const cl_RA alpha = random_ratio(generator);
    const std::int64_t last = testing::whole(generator, 1, 30);
    CycleVelocities<cl_RA> stepped{1, 0, 0, 0};
    std::int64_t reached = 0;
    step_velocities<cl_RA>(alpha, 1, 2 * last, [&](const VelocityEvent<cl_RA>& event) {
      if (event.body == Body::A) {
        stepped.a = event.after.a;
        stepped.c = event.after.c;
      } else {
        stepped.b = event.after.b;
        stepped.c_prime = event.after.c;
        reached = event.n;
        REQUIRE(exact_velocities(alpha, reached) == stepped);
      }
    });
    REQUIRE(reached >= 1);
  }
}

TEST_CASE("beyond the last collision the power still keeps energy and momentum", "[check]") {
  testing::Generator generator(18);
  for (int i = 0; i < 200; ++i) {
    const cl_RA alpha = random_ratio(generator);
    const auto v = exact_velocities(alpha, testing::whole(generator, 1, 200));
    REQUIRE(v.a + v.b + alpha * v.c_prime == 1);
    REQUIRE(v.a * v.a + v.b * v.b + alpha * v.c_prime * v.c_prime == 1);
  }
}

TEST_CASE("certified digits are those of the exact rational", "[check]") {
  testing::Generator generator(19);
  for (int i = 0; i < 100; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-6, 1e6);
    const cl_I n = testing::whole(generator, 300, 400);  // too long for the short exact way
    const auto exactly = exact_velocities(exact(alpha), n);
    const auto digits = certified_digits(alpha, n, 40);
    REQUIRE(digits.a == to_decimal(exactly.a, 40));
    REQUIRE(digits.b == to_decimal(exactly.b, 40));
    REQUIRE(digits.c == to_decimal(exactly.c, 40));
    REQUIRE(digits.c_prime == to_decimal(exactly.c_prime, 40));
    const auto near = velocities_within(alpha, n, 80);
    REQUIRE(cln::abs(near.c_prime - exactly.c_prime) * cln::ash(cl_I(1), 80) <=
            cln::abs(exactly.c_prime));
    REQUIRE(near.c_prime != exactly.c_prime);  // the enclosures are what is tested here
    const auto held = enclosed_velocities(enclosure(exact(alpha)), n, 500);
    REQUIRE((held.a.low() <= exactly.a && exactly.a <= held.a.high()));
    REQUIRE((held.b.low() <= exactly.b && exactly.b <= held.b.high()));
    REQUIRE((held.c.low() <= exactly.c && exactly.c <= held.c.high()));
    REQUIRE((held.c_prime.low() <= exactly.c_prime && exactly.c_prime <= held.c_prime.high()));
  }
}

TEST_CASE("a decimal tie is settled exactly", "[exam]") {
  // alpha = 3, n = 1: -1/2, 3/4, 1/2, 1/4 end after two digits
  CHECK(certified_digits(3.0, 1, 1) == CycleVelocities<std::string>{"-0.5", "0.8", "0.5", "0.2"});
}

TEST_CASE("an irrational alpha and an n of any size have certain digits", "[exam]") {
  // at sqrt(2) - 1: 1 + alpha = sqrt(2), a_1 = (1 - alpha)/(1 + alpha) = sqrt(2) - 1, c_1 = 2/(1 + alpha) = sqrt(2)
  const auto first = certified_digits(Deficient{1}, 1, 30);
  CHECK(first.a == "0.414213562373095048801688724210");
  CHECK(first.c == "1.41421356237309504880168872421");
  const auto far =
      certified_digits(1e-30, cl_I("555360367269796"), 20);  // the last collision but none
  CHECK(far.a.substr(0, 2) == "0.");
  // after 2k + 1 cycles at magic:k the rotation is a whole turn, which digits alone cannot tell from nearly one
  CHECK_THROWS_AS(certified_digits(Magic{3}, 7, 20), Undecided);
}

TEST_CASE("an exact zero at an irrational alpha is given up, not guessed", "[exam]") {
  CHECK_THROWS_AS(certified_digits(Magic{3}, 3, 20), Undecided);  // a_3 = c'_3 = 0
  CHECK_THROWS_AS(velocities_within(Magic{3}, 3, 53), Undecided);
  CHECK_THROWS_AS(certified_digits(Magic{3}, 3, 10000),
                  Undecided);  // and soon: the cap is on guard bits
}

TEST_CASE("what has no answer or too long a one is refused", "[exam]") {
  CHECK_THROWS_WITH(exact_velocities(cl_RA(1) / 7, -1), "n must be 0 or more, got -1");
  CHECK_THROWS_WITH(exact_velocities(cl_RA(-1) / 7, 1),
                    "alpha must be a positive finite number, got -1/7");
  CHECK_THROWS_AS(exact_velocities(cl_RA(1) / 7, cl_I(1000000000)), Undecided);
  CHECK_THROWS_AS(certified_digits(0.1, 1, 0), InvalidInput);
  CHECK_THROWS_AS(certified_digits(-0.1, 1, 5), InvalidInput);
  CHECK_THROWS_AS(velocities_within(0.1, 1, 0), InvalidInput);
  CHECK_THROWS_AS(velocities_within(0.1, -1, 50), InvalidInput);
}
