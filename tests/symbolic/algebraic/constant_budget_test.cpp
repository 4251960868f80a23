// SPDX-License-Identifier: GPL-2.0-or-later
// Questions that cost too much are answered or given up within the budget.
#include <chrono>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "algebraic/constant.hpp"
#include "constants.hpp"

using namespace magicmass::algebraic;
using GiNaC::cos;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;
using GiNaC::pow;

TEST_CASE("large denominators, indices and exponents are answered", "[exam]") {
  CHECK(sign_of(cos(Pi / 1000003) - 1).sign == -1);
  CHECK(sign_of(cos(Pi / numeric(10).power(1000)) - 1).sign == -1);
  CHECK(sign_of(root(2, 9999) - root(3, 9998)).sign == -1);
  CHECK(sign_of(pow(root(2) + 1, numeric(10).power(9)) - 1).sign == 1);
  CHECK(sign_of(cos(Pi / 1000003) - cos(Pi / numeric("1000003000000000000000000000001"))).sign ==
        -1);
}

TEST_CASE("what is beyond the budget has no sign, and says how near 0 it is", "[exam]") {
  // too large a field for roots of unity, and for any separation bound
  const numeric large = numeric(10).power(40);
  const ex zero = root(2 + 2 * cos(Pi / large)) - 2 * cos(Pi / (2 * large));
  const Decision decision = sign_of(zero, {.time = std::chrono::milliseconds(300)});
  CHECK_FALSE(decision.sign.has_value());
  CHECK(decision.agreeing_digits > 1000);
  CHECK(decision.method.starts_with("beyond the budget: "));

  CHECK_FALSE(sign_of(root(2, 10001) - 1).sign.has_value());
  CHECK_FALSE(sign_of(pow(root(2) + 1, numeric(10).power(30)) - 1).sign.has_value());
  const Decision close =
      sign_of(root(2 + numeric(10).power(-100000)) - root(2), {.bits = 10000, .terms = 10});
  CHECK_FALSE(close.sign.has_value());
  CHECK(close.agreeing_digits > 2000);
}

TEST_CASE("deep and wide expressions are answered", "[exam]") {
  ex deep = 2;
  for (int i = 1; i <= 1000; ++i) deep = root(i + deep);
  CHECK(sign_of(deep - 32).sign == 1);
  CHECK_FALSE(sign_of(deep - 32, {.depth = 100}).sign.has_value());
  ex wide = 0;
  for (int i = 2; i <= 2000; ++i) wide += root(i) / i;
  CHECK(sign_of(wide - 80).sign == 1);
  CHECK_FALSE(sign_of(wide - 80, {.nodes = 100}).sign.has_value());
  ex narrow = 0;
  for (int i = 2; i <= 100; ++i) narrow += root(i) / i;
  CHECK(sign_of((narrow + root(2)) * (narrow - root(2)) - narrow * narrow + 2).sign == 0);
}

TEST_CASE("degrees explode only where a zero must be proved", "[exam]") {
  ex sum = 0;
  for (const int prime : {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67})
    sum += root(prime + root(prime));
  CHECK(sign_of(sum - 113).sign.has_value());
  // degree 4^19 for a bound, but it cancels term by term
  ex other = 0;
  for (const int prime : {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67})
    other += root(4 * prime + root(16 * prime)) / 2;
  const Decision decision = sign_of(sum - other);
  INFO(decision.method);
  CHECK((!decision.sign || decision.sign == 0));
}

TEST_CASE("what cannot be decided is given up in time", "[time]") {
  const numeric large = numeric(10).power(40);
  const Budget budget{.time = std::chrono::milliseconds(500)};
  ex sum = 0;
  for (int i = 2; i <= 60; ++i) sum += root(i + root(i));
  for (const ex& zero : {ex(root(2 + 2 * cos(Pi / large)) - 2 * cos(Pi / (2 * large))),
                         ex(pow(sum, 6) * (1 + root(2)) - pow(sum, 6) - root(2) * pow(sum, 6))}) {
    const auto start = std::chrono::steady_clock::now();
    CHECK_FALSE(sign_of(zero, budget).sign.has_value());
    // one operation of CLN is not interrupted, and the machine may be busy
    CHECK(std::chrono::steady_clock::now() - start < 4 * budget.time);
  }
}
