// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/kernel.hpp"

#include <algorithm>
#include <type_traits>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::matrix;

// Only the kernel makes theorems: nothing that a caller can hold converts to one.
static_assert(!std::is_default_constructible_v<Theorem>);
static_assert(!std::is_constructible_v<Theorem, Statement>);
static_assert(!std::is_constructible_v<Theorem, Statement, Step>);
static_assert(!std::is_constructible_v<Theorem, Step>);

namespace {

const ex alpha = symbol("alpha"), x = symbol("x"), y = symbol("y"), n = symbol("n"),
         q = symbol("q");
const std::map<std::string, long> from_zero{{"n", 0}}, from_one{{"n", 1}};

Kernel kernel_for_tests() { return Kernel({.positive = {"alpha", "q"}, .integer = {}}); }

}  // namespace

TEST_CASE("an identity holds or is refused with both sides and a counterexample", "[exam]") {
  Kernel kernel = kernel_for_tests();
  const Theorem theorem =
      kernel.identity({.id = "square", .statement = {pow(x + 1, 2), pow(x, 2) + 2 * x + 1}});
  CHECK(theorem.step().verdict == "proved");
  CHECK(theorem.step().rule == "identity");
  CHECK_THROWS_WITH(kernel.identity({.id = "wrong", .statement = {pow(x + 1, 2), pow(x, 2) + 1}}),
                    Catch::Contains("(1 + x)^2 = 1 + x^2") && Catch::Contains("at x = ") &&
                        Catch::Contains("the left side is"));
  CHECK(kernel.theorems().size() == 1);  // a refused claim leaves nothing behind
}

TEST_CASE("conditions of premises reach the conclusion", "[exam]") {
  Kernel kernel = kernel_for_tests();
  const Theorem supposed = kernel.hypothesis({.id = "supposed", .statement = {x, y}});
  const Theorem result =
      kernel.consequence({.id = "result", .statement = {2 * x + 1, 2 * y + 1}}, {{supposed, 2}});
  CHECK(result.step().conditions == std::vector<std::string>{"x = y"});
  CHECK(result.step().premises == std::vector<std::string>{"supposed"});
}

TEST_CASE("a consequence needs the right cofactors", "[exam]") {
  Kernel kernel = kernel_for_tests();
  const Theorem sum = kernel.law({.id = "sum", .statement = {x + y, 3}});
  const Theorem difference = kernel.law({.id = "difference", .statement = {x - y, 1}});
  const ex half = GiNaC::numeric(1, 2);
  CHECK_NOTHROW(
      kernel.consequence({.id = "x", .statement = {x, 2}}, {{sum, half}, {difference, half}}));
  CHECK_THROWS_AS(
      kernel.consequence({.id = "y", .statement = {y, 2}}, {{sum, half}, {difference, half}}),
      NotProved);
}

TEST_CASE("nothing is divided by what may be zero", "[exam]") {
  Kernel kernel = kernel_for_tests();
  const Theorem product =
      kernel.law({.id = "product", .statement = {(x - y) * (x + y - alpha), 0}});
  const Claim claim{.id = "factor", .statement = {x + y - alpha, 0}};
  CHECK_THROWS_WITH(kernel.cancellation(claim, product, x - y), Catch::Contains("never vanishes"));
  const Theorem irrelevant =
      kernel.law({.id = "irrelevant", .statement = {x, Relation::not_equal, 0}});
  CHECK_THROWS_AS(kernel.cancellation(claim, product, x - y, irrelevant), NotProved);
  const Theorem different =
      kernel.law({.id = "different", .statement = {x, Relation::not_equal, y}});
  const Theorem cancelled = kernel.cancellation(claim, product, x - y, different);
  CHECK(cancelled.step().conditions == std::vector<std::string>{"x != y"});
}

TEST_CASE("a special case must lie in the domain of the general one", "[exam]") {
  Kernel kernel = kernel_for_tests();
  const Theorem root = kernel.identity({.id = "root", .statement = {sqrt(pow(q, 2)), q}});
  CHECK_NOTHROW(kernel.instance({.id = "fine", .statement = {sqrt(pow(2 * alpha, 2)), 2 * alpha}},
                                root, {{q, 2 * alpha}}));
  CHECK_THROWS_WITH(kernel.instance({.id = "negative", .statement = {sqrt(pow(-alpha, 2)), -alpha}},
                                    root, {{q, -alpha}}),
                    Catch::Contains("not known to be positive"));
  const Theorem indexed =
      kernel.law({.id = "indexed", .statement = {a(n), a(n - 1) + 1}, .indices = from_one});
  CHECK_NOTHROW(
      kernel.instance({.id = "next", .statement = {a(n + 1), a(n) + 1}, .indices = from_zero},
                      indexed, {{n, n + 1}}));
  CHECK_THROWS_WITH(
      kernel.instance({.id = "too early", .statement = {a(0), a(-1) + 1}}, indexed, {{n, ex(0)}}),
      Catch::Contains("integer >= 1"));
  CHECK_THROWS_WITH(kernel.consequence(
                        {.id = "too wide", .statement = {a(n), a(n - 1) + 1}, .indices = from_zero},
                        {{indexed, 1}}),
                    Catch::Contains("n >= 1 only"));
}

TEST_CASE("induction checks the beginning, the step and its range", "[exam]") {
  Kernel kernel = kernel_for_tests();
  const Theorem start = kernel.law({.id = "start", .statement = {a(0), 0}});
  const Theorem next =
      kernel.law({.id = "next", .statement = {a(n), a(n - 1) + 2 * n - 1}, .indices = from_one});
  const Theorem squares = kernel.induction(
      {.id = "squares", .statement = {a(n), pow(n, 2)}, .indices = from_zero}, {start}, {next}, n);
  CHECK(squares.step().conditions == std::vector<std::string>{"n integer, n >= 0"});
  CHECK_THROWS_AS(
      kernel.induction({.id = "wrong step", .statement = {a(n), pow(n, 3)}, .indices = from_zero},
                       {start}, {next}, n),
      NotProved);
  CHECK_THROWS_AS(
      kernel.induction(
          {.id = "wrong start", .statement = {a(n), pow(n, 2) + 1}, .indices = from_zero}, {start},
          {next}, n),
      NotProved);
  const Theorem late =
      kernel.law({.id = "late", .statement = {a(n), a(n - 1) + 2 * n - 1}, .indices = {{"n", 2}}});
  CHECK_THROWS_WITH(
      kernel.induction({.id = "gap", .statement = {a(n), pow(n, 2)}, .indices = from_zero}, {start},
                       {late}, n),
      Catch::Contains("first step"));
}

TEST_CASE("powers of a matrix, right and wrong", "[exam]") {
  Kernel kernel = kernel_for_tests();
  const Theorem shear =
      kernel.definition({.id = "shear", .statement = {symbol("S"), matrix{{1, alpha}, {0, 1}}}});
  CHECK_NOTHROW(
      kernel.matrix_power({.id = "power",
                           .statement = {pow(symbol("S"), n), matrix{{1, n * alpha}, {0, 1}}},
                           .indices = from_zero},
                          shear, n));
  CHECK_THROWS_AS(kernel.matrix_power(
                      {.id = "wrong",
                       .statement = {pow(symbol("S"), n), matrix{{1, pow(n, 2) * alpha}, {0, 1}}},
                       .indices = from_zero},
                      shear, n),
                  NotProved);
}

TEST_CASE("angles are equal only if they lie where the cosine tells them apart", "[exam]") {
  Kernel kernel = kernel_for_tests();
  const ex t = sqrt(alpha / (2 + alpha));
  CHECK_NOTHROW(kernel.equal_angles(
      {.id = "double", .statement = {4 * atan(t), 2 * atan(sqrt(alpha * (2 + alpha)))}}));
  CHECK_THROWS_WITH(
      kernel.equal_angles({.id = "range", .statement = {4 * atan(1 / t), 4 * atan(1 / t)}}),
      Catch::Contains("not seen to lie in [0, pi]"));
  CHECK_THROWS_AS(
      kernel.equal_angles({.id = "wrong", .statement = {4 * atan(t), 2 * atan(sqrt(alpha))}}),
      NotProved);
}

TEST_CASE("names are given once, and not to what is in use", "[exam]") {
  Kernel kernel = kernel_for_tests();
  kernel.definition({.id = "z", .statement = {symbol("z"), alpha + 1}});
  CHECK_THROWS_AS(kernel.definition({.id = "again", .statement = {symbol("z"), alpha}}), NotProved);
  CHECK_THROWS_AS(kernel.definition({.id = "assumed", .statement = {alpha, x}}), NotProved);
  CHECK_THROWS_AS(kernel.identity({.id = "z", .statement = {x, x}}), std::logic_error);
}

TEST_CASE("a sign is proved or refused", "[exam]") {
  Kernel kernel = kernel_for_tests();
  CHECK_NOTHROW(
      kernel.positivity({.id = "yes", .statement = {1 / (1 + alpha), Relation::greater, 0}}));
  CHECK_THROWS_AS(kernel.positivity({.id = "no", .statement = {1 - alpha, Relation::greater, 0}}),
                  NotProved);
}
