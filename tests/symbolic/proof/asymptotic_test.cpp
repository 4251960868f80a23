// SPDX-License-Identifier: GPL-2.0-or-later
// Expansions as alpha -> 0: what is accepted, and the falsehoods that are refused.
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

const ex alpha = symbol("alpha"), x = symbol("x"), N = symbol("N_x");

Kernel fresh() { return Kernel({.positive = {"alpha"}, .integer = {}}); }

}  // namespace

TEST_CASE("a series up to its last term", "[exam]") {
  Kernel kernel = fresh();
  int steps = 0;
  const auto expanded = [&](const ex& function, const ex& terms) {
    return kernel.expansion({.id = "step_" + std::to_string(++steps),
                             .statement = {function, Relation::asymptotic, terms}});
  };
  CHECK_NOTHROW(expanded(1 / (1 + alpha), 1 - alpha));
  CHECK_NOTHROW(expanded(sqrt(alpha * (2 + alpha)), sqrt(2 * alpha)));
  CHECK_NOTHROW(expanded(atan(sqrt(alpha)) / alpha, 1 / sqrt(alpha) - sqrt(alpha) / 3));
  CHECK_NOTHROW(expanded(cos(sqrt(alpha)), 1 - alpha / 2));
  CHECK_THROWS_AS(expanded(1 / (1 + alpha), 1 + alpha), NotProved);
  CHECK_THROWS_AS(expanded(1 / (1 + alpha), 1 - alpha - pow(alpha, 2)), NotProved);
  CHECK_THROWS_AS(expanded(1 / (1 + alpha), -alpha), NotProved);  // the first term is missing
  CHECK_THROWS_AS(expanded(1 / alpha + 1, 1), NotProved);         // so is the pole
  CHECK_THROWS_AS(expanded(sqrt(alpha * (2 + alpha)), sqrt(alpha)), NotProved);
  CHECK_THROWS_AS(expanded(1 / (1 + alpha), 0), NotProved);
  CHECK_THROWS_AS(expanded(1 / (1 + alpha), 1 / (1 + alpha)), NotProved);  // no sum of powers
  CHECK_THROWS_AS(expanded(1 / (1 + alpha), 1 - x * alpha), NotProved);
  CHECK_THROWS_AS(kernel.expansion({.id = "equation", .statement = {1 / (1 + alpha), 1 - alpha}}),
                  NotProved);
}

TEST_CASE("what holds in the limit is no equation and has no instances", "[exam]") {
  Kernel kernel = fresh();
  const Theorem limit = kernel.expansion(
      {.id = "limit", .statement = {1 / (1 + alpha), Relation::asymptotic, 1 - alpha}});
  CHECK_THROWS_AS(
      kernel.consequence({.id = "equal", .statement = {1 / (1 + alpha), 1 - alpha}}, {{limit, 1}}),
      NotProved);
  CHECK_THROWS_AS(
      kernel.instance({.id = "at_one", .statement = {numeric(1, 2), Relation::asymptotic, 0}},
                      limit, {{alpha, 1}}),
      NotProved);
}

TEST_CASE("a count follows what it counts", "[exam]") {
  Kernel kernel = fresh();
  const ex angle = atan(sqrt(alpha));
  const Theorem grows = kernel.expansion(
      {.id = "grows", .statement = {Pi / angle, Relation::asymptotic, Pi / sqrt(alpha)}});
  const Theorem bounded = kernel.expansion(
      {.id = "bounded", .statement = {angle / sqrt(alpha), Relation::asymptotic, 1}});
  const Theorem count = kernel.hypothesis(
      {.id = "count", .statement = {N, ceiling(2 * Pi / angle - numeric(1, 2)) - 1}});
  const Theorem few =
      kernel.hypothesis({.id = "few", .statement = {symbol("N_y"), ceiling(angle / sqrt(alpha))}});
  CHECK_NOTHROW(kernel.expansion_of_count(
      {.id = "N", .statement = {N, Relation::asymptotic, 2 * Pi / sqrt(alpha)}}, count, grows));
  CHECK_THROWS_AS(
      kernel.expansion_of_count(
          {.id = "half", .statement = {N, Relation::asymptotic, Pi / sqrt(alpha)}}, count, grows),
      NotProved);
  CHECK_THROWS_AS(
      kernel.expansion_of_count(
          {.id = "one", .statement = {symbol("N_y"), Relation::asymptotic, 1}}, few, bounded),
      NotProved);
  CHECK_THROWS_AS(
      kernel.expansion_of_count(
          {.id = "other", .statement = {symbol("N_y"), Relation::asymptotic, 2 * Pi / sqrt(alpha)}},
          count, grows),
      NotProved);
}
