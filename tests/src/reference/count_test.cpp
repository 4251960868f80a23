// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/count.hpp"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <cln/real.h>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/velocity_stepping.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using namespace magicmass::reference;
using cln::cl_I;
using cln::cl_RA;

TEST_CASE("the paper's counts, in rationals", "[exam]") {
  CHECK(count_collisions(cl_RA(12) / 100).N_A == 3);
  CHECK(count_collisions(cl_RA(12) / 100).N_B == 3);
  CHECK(count_collisions(cl_RA(10) / 100).N_A == 4);
  CHECK(count_collisions(cl_RA(10) / 100).N_B == 3);
}

TEST_CASE("the exact tie at equal masses, and a hair beside it", "[exam]") {
  const cl_RA hair = cl_RA(1) / cln::expt_pos(cl_I(10), cl_I(500));
  CHECK(count_collisions(cl_RA(1)).N_A == 1);
  CHECK(count_collisions(cl_RA(1)).N_B == 1);
  CHECK(count_collisions(1 + hair).N_A == 1);
  CHECK(count_collisions(1 - hair).N_A == 2);
  CHECK(count_collisions(1 - hair).N_B == 1);
  CHECK(count_collisions(cln::recip(hair)).N_B == 1);
}

TEST_CASE("a hundred digits of collisions", "[exam]") {
  // total = floor(pi / h) with h = sqrt(2 alpha) (1 - 5 alpha/12 + ...): at 1e-200 that is pi 10^100 / sqrt 2
  const LargeCounts counts = count_collisions(parse_rational("1/1" + std::string(200, '0')));
  const std::string half =
      "111072073453959156175397024751517342465365542234392255577134890173"
      "91086982748684776438317336911913093";
  CHECK(to_text(counts.N_A) == half);
  CHECK(to_text(counts.N_B) == half);
}

TEST_CASE("the search agrees with exact stepping where that is still quick", "[check]") {
  testing::Generator generator(20);
  for (int i = 0; i < 300; ++i) {
    const cl_RA alpha =
        cl_RA(testing::whole(generator, 1, 9)) / testing::whole(generator, 901, 9000);
    const LargeCounts found = count_collisions(alpha);
    const Counts stepped = step_velocities<cl_RA>(alpha).counts;
    REQUIRE(found.N_A == stepped.N_A);
    REQUIRE(found.N_B == stepped.N_B);
  }
}

TEST_CASE("alpha that is no mass ratio has no count", "[exam]") {
  CHECK_THROWS_WITH(count_collisions(0), "alpha must be a positive finite number, got 0");
  CHECK_THROWS_WITH(count_collisions(cl_RA(-1) / 7),
                    "alpha must be a positive finite number, got -1/7");
}
