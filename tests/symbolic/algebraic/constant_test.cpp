// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/constant.hpp"

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "constants.hpp"

using namespace magicmass::algebraic;
using GiNaC::cos;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;
using GiNaC::pow;
using GiNaC::sin;
using GiNaC::tan;

namespace {

ex sec(const ex& x) { return 1 / cos(x); }

void check_sign(const std::string& name, const ex& constant, int sign) {
  const Decision decision = sign_of(constant);
  INFO(name << ": " << decision.method);
  CHECK(decision.sign == sign);
  CHECK_FALSE(decision.method.empty());
  // The same number with the other sign, and moved off by very little.
  CHECK(sign_of(-constant).sign == -sign);
  if (sign != 0) return;
  const numeric tiny = numeric(10).power(-60);
  CHECK(sign_of(constant + tiny).sign == 1);
  CHECK(sign_of(constant - tiny).sign == -1);
}

}  // namespace

TEST_CASE("equal constants are proved equal", "[exam]") {
  const ex s2 = root(2);
  const ex s3 = root(3);
  const ex s5 = root(5);
  check_sign("sec(pi/5)", sec(Pi / 5) - 1 - (s5 - 2), 0);
  check_sign("sec(pi/8)", sec(Pi / 8) - 1 - (root(4 - 2 * s2) - 1), 0);
  check_sign("sec(pi/12)", sec(Pi / 12) - 1 - (root(6) - s2 - 1), 0);
  check_sign("heptagon", cos(Pi / 7) + cos(3 * Pi / 7) + cos(5 * Pi / 7) - numeric(1, 2), 0);
  check_sign("alpha_3", sec(Pi / 7) - 1 - tan(Pi / 7) * tan(Pi / 14), 0);
  check_sign("nested", root(5 + 2 * root(6)) - s2 - s3, 0);
  check_sign("cube root", root(2 + s5, 3) - (1 + s5) / 2, 0);
  check_sign("square",
             pow(s2 + s3 + s5 + root(7), 2) - 17 - 2 * root(6) - 2 * root(10) - 2 * root(14) -
                 2 * root(15) - 2 * root(21) - 2 * root(35),
             0);
  check_sign("Ramanujan",
             root(root(2, 3) - 1, 3) - root(numeric(1, 9), 3) + root(numeric(2, 9), 3) -
                 root(numeric(4, 9), 3),
             0);
  check_sign("Shanks",
             root(11 + 2 * root(29)) + root(16 - 2 * root(29) + 2 * root(55 - 10 * root(29))) - s5 -
                 root(22 + 2 * s5),
             0);
  check_sign("Gauss",
             16 * cos(2 * Pi / 17) - (-1 + root(17) + root(34 - 2 * root(17)) +
                                      2 * root(17 + 3 * root(17) - root(34 - 2 * root(17)) -
                                               2 * root(34 + 2 * root(17)))),
             0);
  check_sign("six roots",
             root(8) + root(12) + root(20) + root(28) + root(44) + root(52) -
                 2 * (s2 + s3 + s5 + root(7) + root(11) + root(13)),
             0);
  check_sign("denominators", 1 / (s2 + s3 + s5) - (2 * s3 + 3 * s2 - root(30)) / 12, 0);
  check_sign("roots of fractions",
             root((1 - s2) / (s2 - s3), 3) - root(s2 - 1, 3) * root(s3 + s2, 3), 0);
  check_sign("absolute value", abs(s2 - s3) + s2 - s3, 0);
  check_sign("angle doubled", cos(Pi / 1000003) - 2 * pow(cos(Pi / 2000006), 2) + 1, 0);
  check_sign("angle halved", root(2 + 2 * cos(Pi / 1000003)) - 2 * cos(Pi / 2000006), 0);
}

TEST_CASE("the product of 2 sin(k pi/n) for 0 < k < n is n", "[exam]") {
  for (int n = 2; n <= 40; ++n) {
    ex product = 1;
    for (int k = 1; k < n; ++k) product *= 2 * sin(k * Pi / n);
    INFO(n);
    CHECK(sign_of(product - n).sign == 0);
    CHECK(sign_of(product - n - numeric(1, 1000000)).sign == -1);
  }
}

TEST_CASE("a square root tower of depth 20 is a cosine", "[exam]") {
  ex tower = root(2);
  for (int i = 1; i < 20; ++i) tower = root(2 + tower);
  check_sign("2 cos(pi/2^21)", tower - 2 * cos(Pi / (1 << 21)), 0);
  CHECK(sign_of(tower - 2 * cos(Pi / ((1 << 21) + 1))).sign == -1);
  CHECK(sign_of(tower - 2).sign == -1);
}

TEST_CASE("numbers that agree to many digits are told apart", "[exam]") {
  for (const long digits : {40L, 100L, 1000L}) {
    INFO(digits);
    const numeric unit = numeric(10).power(digits);
    const Decimals near = decimals(root(2) * unit, 0);
    CHECK(sign_of(root(2) - numeric(near.below.c_str()) / unit).sign == 1);
    CHECK(sign_of(root(2) - numeric(near.above.c_str()) / unit).sign == -1);
    CHECK(sign_of(root(2 + 1 / unit) - root(2)).sign == 1);
    CHECK(
        sign_of(cos(Pi / 7) + cos(3 * Pi / 7) + cos(5 * Pi / 7) - numeric(1, 2) - 1 / unit).sign ==
        -1);
    CHECK(sign_of(cos(Pi / unit) - 1).sign == -1);
  }
  // sums of square roots that are close: 5 + 11 + ... without a pattern, known from a search
  CHECK(sign_of(root(10) + root(11) - root(5) - root(18)).sign == 1);
  // Ramanujan's constant's little brother: a near miss of 1e-18
  CHECK(sign_of(cos(Pi / 1000003) - cos(Pi / 1000002)).sign == 1);
}

TEST_CASE("what is not in the class is refused, by name", "[exam]") {
  const GiNaC::symbol x("x");
  const auto refusal = [](const ex& e) -> std::string {
    try {
      return "decided: " + sign_of(e).method;
    } catch (const NotAlgebraic& reason) {
      return reason.what();
    }
  };
  CHECK(refusal(x + 1) == "not an algebraic number: x");
  CHECK(refusal(Pi - 3) == "not an algebraic number: Pi");
  CHECK(refusal(exp(ex(2))) == "not a function of the class: exp(2)");
  CHECK(refusal(cos(ex(1))).starts_with("not an angle that is a rational multiple of Pi"));
  CHECK(refusal(cos(Pi * root(2))).starts_with("not an angle that is a rational multiple of Pi"));
  CHECK(refusal(ex(0.5) * root(2)).starts_with("not an exact number"));
  CHECK(refusal(root(2) * GiNaC::I).starts_with("not a real number"));
  CHECK(refusal(root(1 - root(2))).starts_with("a root of a negative number"));
  CHECK(refusal(root(1 - root(2), 3)).starts_with("a root of a negative number"));
  CHECK(refusal(pow(ex(2), root(2))).starts_with("a power whose exponent"));
  const ex zero = root(5 + 2 * root(6)) - root(2) - root(3);
  CHECK(refusal(1 / zero).starts_with("division by zero"));
  CHECK(refusal(pow(zero, numeric(-1, 2))).starts_with("division by zero"));
  // a radicand that is exactly 0 is fine, and one that is below 0 by 10^-100 is not
  CHECK(sign_of(root(zero)).sign == 0);
  CHECK(refusal(root(zero - numeric(10).power(-100))).starts_with("a root of a negative number"));
  CHECK(sign_of(root(zero + numeric(10).power(-100))).sign == 1);
}

TEST_CASE("the method is named", "[exam]") {
  CHECK(sign_of(root(2) - 1).method == "interval arithmetic at 19 digits");
  CHECK(sign_of(ex(0)).method == "exact arithmetic with rational numbers");
  CHECK(sign_of(cos(Pi / 7) + cos(3 * Pi / 7) + cos(5 * Pi / 7) - numeric(1, 2)).method ==
        "exact arithmetic: with cosines in powers of exp(2 pi i/14), everything cancels");
  CHECK(sign_of(root(5 + 2 * root(6)) - root(2) - root(3)).method ==
        "exact arithmetic: multiplied out, all radicals cancel");
}

TEST_CASE("decimals enclose the number", "[exam]") {
  const Decimals half = decimals(ex(numeric(-1, 2)), 3);
  CHECK(half.below == "-0.500");
  CHECK(half.above == "-0.500");
  const Decimals near = decimals(root(2), 30);
  CHECK(near.below == "1.414213562373095048801688724209");
  CHECK(near.above == "1.414213562373095048801688724210");
  CHECK(decimals(root(2) / 100 - 1, 2).below == "-0.99");
}
