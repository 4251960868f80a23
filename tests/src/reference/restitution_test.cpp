// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/restitution.hpp"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using namespace magicmass::reference;
using cln::cl_I;
using cln::cl_RA;

namespace {

MassRatio fraction(const cl_RA& x) {
  return Fraction{to_text(cln::numerator(x)), to_text(cln::denominator(x))};
}

/// Collisions one by one in rational numbers, typed from the restitution law; `most` if there are more.
long stepped(const cl_RA& alpha, const cl_RA& e, long most) {
  cl_RA a = 1, b = 0, c = 0;
  for (long j = 0; j < most; ++j) {
    cl_RA& block = j % 2 == 0 ? a : b;
    const cl_RA approach = j % 2 == 0 ? a - c : c - b;
    if (!cln::plusp(approach)) return j;
    const cl_RA to_ball = (1 + e) * (block - c) / (1 + alpha);
    block = block - alpha * to_ball;
    c = c + to_ball;
  }
  return most;
}

/// All collisions; -1 where they never end.
cl_I total(const cl_RA& alpha, const cl_RA& e) {
  const auto counts = count_collisions(fraction(alpha), e);
  if (!counts) return -1;
  CHECK(counts->N_A - counts->N_B >= 0);
  CHECK(counts->N_A - counts->N_B <= 1);
  return counts->N_A + counts->N_B;
}

}  // namespace

TEST_CASE("counts with restitution are those of stepping", "[check]") {
  testing::Generator generator(1);
  constexpr long most = 60;
  long finite = 0;
  long endless = 0;
  for (int i = 0; i < 600; ++i) {
    const cl_RA e = cl_RA(testing::whole(generator, 1, 40)) / 40;
    const cl_RA alpha = cl_RA(testing::whole(generator, 1, 60)) / testing::whole(generator, 1, 200);
    INFO("alpha = " << to_text(alpha) << ", e = " << to_text(e));
    const cl_I counted = total(alpha, e);
    const long steps = stepped(alpha, e, most);
    if (counted < 0) {
      CHECK(steps == most);
      ++endless;
    } else {
      CHECK(cln::min(counted, cl_I(most)) == cl_I(steps));
      ++finite;
    }
  }
  CHECK(finite > 100);
  CHECK(endless > 50);
}

TEST_CASE("where pi/h is whole the last pair no longer meets, and a hair below it does", "[exam]") {
  const cl_RA hair = cln::recip(cl_RA(cln::expt_pos(cl_I(10), cl_I(300))));
  const struct {
    cl_RA alpha, e;
    long collisions;
  } ties[] = {{cl_RA(3) / 2, cl_RA(1) / 4, 2},
              {cl_RA(1) / 2, cl_RA(1) / 2, 3},
              {cl_RA(1) / 3, cl_RA(1) / 3, 5},
              {1, 1, 2}};
  for (const auto& [alpha, e, collisions] : ties) {
    INFO("alpha = " << to_text(alpha) << ", e = " << to_text(e));
    CHECK(stepped(alpha, e, 20) == collisions);
    CHECK(total(alpha, e) == collisions);
    CHECK(total(alpha + hair, e) == collisions);
    CHECK(total(alpha - hair, e) == collisions + 1);
  }
}

TEST_CASE("the border of the collapse is exact", "[exam]") {
  const cl_RA hair = cln::recip(cl_RA(cln::expt_pos(cl_I(10), cl_I(30))));
  for (const long root : {2, 3, 5, 9}) {  // e = 1/root^2: alpha_c is rational
    const cl_RA e = cln::recip(cl_RA(root * root));
    const cl_RA alpha_c = (1 + e) * root / 2 - 1;
    CHECK(total(alpha_c, e) == -1);
    CHECK(total(alpha_c - hair, e) == -1);
    CHECK(total(alpha_c + hair, e) > cln::expt_pos(cl_I(10), cl_I(14)));
  }
  CHECK(total(hair, 1) > 0);  // elastic: never
}

TEST_CASE("elastic counts are those of the collision law", "[check]") {
  testing::Generator generator(2);
  for (int i = 0; i < 200; ++i) {
    const cl_RA alpha = exact(testing::log_uniform(generator, 1e-40, 1e3));
    const LargeCounts expected = count_collisions(alpha);
    const auto got = count_collisions(fraction(alpha), 1);
    REQUIRE(got);
    CHECK(got->N_A == expected.N_A);
    CHECK(got->N_B == expected.N_B);
  }
}

TEST_CASE("irrational mass ratios count, unless they are on a threshold", "[exam]") {
  CHECK_FALSE(count_collisions(Magic{3}, cl_RA(1) / 20));
  const cl_RA e = cl_RA(9) / 10;
  const auto counts = count_collisions(Magic{3}, e);
  REQUIRE(counts);
  CHECK(counts->N_A + counts->N_B == stepped(ratio_within(Magic{3}, 100), e, 60));
  CHECK_THROWS_AS(count_collisions(Magic{3}, 1), Undecided);
}

TEST_CASE("a restitution that is not above 0, or above 1, is refused", "[exam]") {
  for (const cl_RA& e : {cl_RA(0), cl_RA(-1) / 2, cl_RA(11) / 10})
    CHECK_THROWS_WITH(count_collisions(0.5, e), Catch::Contains("above 0 and at most 1"));
  CHECK_THROWS_AS(count_collisions(-0.5, cl_RA(1)), InvalidInput);
}
