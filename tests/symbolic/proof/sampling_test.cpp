// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/sampling.hpp"

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;

namespace {
const ex alpha = symbol("alpha"), beta = symbol("beta"), n = symbol("n");
const Domain domain{.positive = {"alpha"}, .integer = {{"n", 0}}};
}  // namespace

TEST_CASE("two different expressions are told apart, with a point and both values", "[exam]") {
  const auto found = counterexample(sqrt(1 + alpha), 1 + alpha / 2, domain, {}, "seed");
  REQUIRE(found);
  CHECK_THAT(*found, Catch::Contains("alpha = ") && Catch::Contains("left side") &&
                         Catch::Contains("right side"));
}

TEST_CASE("a difference in the fortieth digit is seen", "[exam]") {
  const ex tiny = GiNaC::pow(ex(10), -40);
  CHECK(counterexample(alpha, alpha + tiny, domain, {}, "seed"));
}

TEST_CASE("identities agree, also between elements of sequences", "[exam]") {
  CHECK_FALSE(counterexample(pow(sin(beta), 2) + pow(cos(beta), 2), 1, domain, {}, "seed"));
  CHECK_FALSE(counterexample(a(n) * 2 - a(n), a(n), domain, {}, "seed"));
  CHECK(counterexample(a(n), a(n - 1), domain, {}, "seed"));
}

TEST_CASE("points keep what the domain assumes, and only those", "[exam]") {
  const ex root = sqrt(pow(1 - alpha, 2));
  const auto differs = [&](const ex& rhs, const Statement& assumption) {
    Domain assuming = domain;
    assuming.assumed = {assumption};
    return counterexample(root, rhs, assuming, {}, "seed").has_value();
  };
  const Statement is_light(alpha, Relation::less_equal, 1);
  const Statement is_heavy(alpha, Relation::greater, 1);
  CHECK_FALSE(differs(1 - alpha, is_light));
  CHECK_FALSE(differs(alpha - 1, is_heavy));
  CHECK(differs(1 - alpha, is_heavy));
  CHECK(differs(alpha - 1, is_light));
}

TEST_CASE("matrices are compared entry by entry", "[exam]") {
  const GiNaC::matrix left{{1, alpha}, {0, 1}}, right{{1, alpha}, {0, 2}};
  CHECK_FALSE(counterexample(left, left, domain, {}, "seed"));
  CHECK_THAT(counterexample(left, right, domain, {}, "seed").value(),
             Catch::StartsWith("row 2, column 2"));
}

TEST_CASE("the points depend on the seed alone", "[check]") {
  const auto once = counterexample(alpha, beta, domain, {}, "one"),
             again = counterexample(alpha, beta, domain, {}, "one");
  const auto other = counterexample(alpha, beta, domain, {}, "two");
  CHECK(once == again);
  CHECK(once != other);
}
