// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/families.hpp"
#include "proof/kernel.hpp"
#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::Pi;

namespace {

const ex n = symbol("n"), e = symbol("e"), V = symbol("V"), h = Pi / 5, y = symbol("y");
const std::map<std::string, long> from_zero{{"n", 0}};

// Counts with speeds even(n) sin((2 n + 1) h) and odd(n) sin((2 n + 2) h).
void count(const ex& even, const ex& odd, const std::map<std::string, long>& indices = {},
           const ex& number = symbol("N"), long from = 0) {
  Kernel kernel({.positive = {"V", "e"}, .integer = {}});
  kernel.definition({.id = "y", .statement = {y, n - 4}});
  const Theorem one = kernel.law(
      {.id = "one", .statement = {a(n), even * sin((2 * n + 1) * h)}, .indices = {{"n", from}}});
  const Theorem two = kernel.law(
      {.id = "two", .statement = {b(n), odd * sin((2 * n + 2) * h)}, .indices = {{"n", from}}});
  kernel.collision_count(
      {.id = "N", .statement = {number, ceiling(Pi / h) - 1}, .indices = indices}, one, two, n, h);
}

}  // namespace

TEST_CASE("factors of approach speeds may change from cycle to cycle, but not their sign",
          "[exam]") {
  CHECK_NOTHROW(count(V * pow(e, n), V * sqrt(e) * pow(e, n)));
  CHECK_NOTHROW(count(V, V * (n + 1)));
  CHECK_THROWS_AS(count(V * (n - 3), V), NotProved);
  CHECK_THROWS_AS(count(V * n, V), NotProved);  // zero at n = 0
  CHECK_THROWS_AS(count(V * (n - 3), V, {{"n", 5}}), NotProved);
  CHECK_THROWS_AS(count(V * y, V, {{"n", 5}}), NotProved);  // y = n - 4 by definition
  CHECK_THROWS_AS(count(-V * pow(e, n), V), NotProved);
  CHECK_THROWS_AS(count(V, V, {}, symbol("N"), 1), NotProved);
  CHECK_THROWS_AS(count(V, V, {}, symbol("N_A")), NotProved);
  CHECK_THROWS_AS(count(V, V, {}, N_C()), NotProved);
}

TEST_CASE("a condition that may fail on the way to the last collision is none on velocities",
          "[exam]") {
  Kernel kernel({.positive = {"V"}, .integer = {}});
  const auto speed = [&](const char* id, const ex& velocity, int shift) {
    const ex sine = sin((2 * n + shift) * h);
    return kernel.law({.id = id, .statement = {velocity, V * sine}, .indices = from_zero});
  };
  const Theorem even = speed("even", a(n), 1), odd = speed("odd", b(n), 2);
  const Theorem but_there =
      kernel.consequence({.id = "but there", .statement = even.statement(), .indices = from_zero},
                         {{even, 1 / (n - 3)}, {even, 1 - 1 / (n - 3)}});
  const Claim claim{.id = "N", .statement = {symbol("N"), ceiling(Pi / h) - 1}};
  CHECK_THROWS_WITH(kernel.collision_count(claim, but_there, odd, n, h),
                    Catch::Contains("but there holds only if n"));
  CHECK_NOTHROW(kernel.collision_count(claim, even, odd, n, h));
}

TEST_CASE("a threshold is of a ceiling that is 1 for large mass ratios", "[exam]") {
  const auto threshold = [](const ex& s) {
    Kernel kernel({.positive = {"alpha"}, .integer = {{"k", 1}}});
    const ex k = symbol("k"), alpha = symbol("alpha"), psi = symbol("psi");
    const std::map<std::string, long> from_one{{"k", 1}};
    const Theorem angle =
        kernel.definition({.id = "psi", .statement = {psi, 4 * atan(sqrt(alpha / (2 + alpha)))}});
    const Theorem count =
        kernel.law({.id = "count", .statement = {symbol("N_A"), ceiling(Pi / psi - s)}});
    const ex slope = angle.rhs().diff(GiNaC::ex_to<GiNaC::symbol>(alpha));
    const Theorem increasing =
        kernel.positivity({.id = "increasing", .statement = {slope, Relation::greater, 0}});
    const ex ratio = 1 / cos(Pi / (2 * (k + s))) - 1;
    const Theorem named = kernel.definition(
        {.id = "alpha_k", .statement = {symbol("alpha_k"), ratio}, .indices = from_one});
    const Theorem back = kernel.law({.id = "back",
                                     .statement = {angle.rhs().subs(alpha == ratio), Pi / (k + s)},
                                     .indices = from_one});
    kernel.threshold({.id = "range", .statement = {symbol("alpha_k"), ratio}, .indices = from_one},
                     count, increasing, back, k);
  };
  CHECK_NOTHROW(threshold(GiNaC::numeric(1, 2)));
  CHECK_NOTHROW(threshold(1));
  for (const ex& s : {ex(3), ex(0), ex(-1), ex(GiNaC::numeric(3, 2))})
    CHECK_THROWS_WITH(threshold(s), Catch::Contains("is not ceil(pi/psi - s), 0 < s <= 1"));
}
