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
