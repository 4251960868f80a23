// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/families.hpp"
#include "proof/kernel.hpp"
#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;

namespace {

const ex x = symbol("x"), y = symbol("y"), q = symbol("q"), n = symbol("n"), e = symbol("e"),
         V = symbol("V"), mu_A = symbol("mu_A");
const std::map<std::string, long> from_zero{{"n", 0}};

Kernel new_kernel() { return Kernel({.positive = {"q", "e", "mu_A", "mu_B", "V"}, .integer = {}}); }

bool has_condition(const Theorem& theorem, const std::string& text) {
  const auto& all = theorem.step().conditions;
  return std::find(all.begin(), all.end(), text) != all.end();
}

}  // namespace

TEST_CASE("an assumption is used, recorded, and handed on", "[exam]") {
  Kernel kernel = new_kernel();
  CHECK_THROWS_AS(kernel.positivity({.id = "no", .statement = {1 - q, Relation::greater, 0}}),
                  NotProved);
  const Theorem below = kernel.positivity({.id = "yes",
                                           .statement = {(1 - q) / q, Relation::greater, 0},
                                           .assuming = {{1, Relation::greater, q}}});
  CHECK(has_condition(below, "1 > q"));
  CHECK_THROWS_AS(kernel.positivity({.id = "other side",
                                     .statement = {q - 1, Relation::greater, 0},
                                     .assuming = {{1, Relation::greater, q}}}),
                  NotProved);
  CHECK_THROWS_AS(kernel.positivity({.id = "not strict",
                                     .statement = {1 - q, Relation::greater, 0},
                                     .assuming = {{q, Relation::less_equal, 1}}}),
                  NotProved);
  const Theorem root = kernel.identity({.id = "root",
                                        .statement = {sqrt(pow(1 - q, 2)), 1 - q},
                                        .assuming = {{1, Relation::greater, q}}});
  const Theorem double_root = kernel.consequence(
      {.id = "double", .statement = {2 * sqrt(pow(1 - q, 2)), 2 - 2 * q}}, {{root, 2}});
  CHECK(has_condition(double_root, "1 > q"));
  const Theorem at_two =
      kernel.instance({.id = "at two", .statement = {1, -1}}, root, {{q, ex(2)}});  // only if 1 > 2
  CHECK(has_condition(at_two, "1 > 2"));
}

TEST_CASE("assumptions are inequalities between constants", "[exam]") {
  Kernel kernel = new_kernel();
  const auto refused = [&](const Statement& assumption) {
    CHECK_THROWS_AS(
        kernel.identity(
            {.id = "p", .statement = {x, x}, .indices = from_zero, .assuming = {assumption}}),
        NotProved);
  };
  refused({q, 1});
  refused({q, Relation::not_equal, 1});
  refused({n, Relation::greater, 3});
  refused({v_A(n), Relation::greater, 0});
}

TEST_CASE("a family is replaced in all it depends on, and in nothing else", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem start =
      kernel.law({.id = "start", .statement = {v_A(0), V}, .schematic = {"mu_A", "mu_B", "e"}});
  CHECK_THROWS_AS(kernel.instance({.id = "V", .statement = {v_A(0), 1}}, start, {{V, ex(1)}}),
                  NotProved);
  const Theorem speed = kernel.law({.id = "speed",
                                    .statement = {v_A(n + 1), e * v_A(n)},
                                    .indices = from_zero,
                                    .schematic = {"mu_A", "mu_B", "e"}});
  const ex at_one = v_A(n).subs(e == 1);
  const Theorem elastic = kernel.instance(
      {.id = "elastic", .statement = {at_one.subs(n == n + 1), at_one}, .indices = from_zero},
      speed, {{e, ex(1)}});
  CHECK(elastic.step().from == "v_A(n + 1; mu_A, mu_B, 1)");
  // The family at e = 1 is not the general one.
  CHECK_THROWS_AS(
      kernel.consequence({.id = "mixed", .statement = {v_A(n + 1), v_A(n)}, .indices = from_zero},
                         {{elastic, 1}}),
      NotProved);
  CHECK_THROWS_AS(
      kernel.rewriting(
          {.id = "applied", .statement = {at_one, V}, .indices = from_zero},
          {kernel.law({.id = "constant", .statement = {v_A(n), V}, .indices = from_zero})}),
      NotProved);
}

TEST_CASE("laws and definitions of families speak of their parameters alone", "[exam]") {
  Kernel kernel = new_kernel();
  CHECK_THROWS_AS(kernel.law({.id = "a", .statement = {v_A(0), x}}), NotProved);
  CHECK_THROWS_AS(kernel.law({.id = "b", .statement = {v_A(0).subs(e == 1), e}}), NotProved);
  CHECK_THROWS_AS(
      kernel.definition({.id = "c", .statement = {r_P(n).subs(e == 1), e}, .indices = from_zero}),
      NotProved);
  CHECK_THROWS_AS(
      kernel.definition({.id = "d", .statement = {r_P(n), r_P(n) + e}, .indices = from_zero}),
      NotProved);
}

TEST_CASE("cases stay conditions when their symbols are replaced", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem same = kernel.identity({.id = "same", .statement = {y, y}});
  const Theorem case_y = kernel.cases({.id = "case", .statement = {x, y}}, {{{{x, y}}, same}});
  const Theorem absurd =
      kernel.instance({.id = "absurd", .statement = {1, 2}}, case_y, {{x, ex(1)}, {y, ex(2)}});
  CHECK(has_condition(absurd, "1 = 2"));
  const Theorem fine =
      kernel.instance({.id = "fine", .statement = {3, 3}}, case_y, {{x, ex(3)}, {y, ex(3)}});
  CHECK(fine.step().conditions.empty());
  const Theorem in_words =
      kernel.cases({.id = "two at once", .statement = {x, y}}, {{{{x, y}, {q, q}}, same}});
  CHECK_THROWS_AS(
      kernel.instance({.id = "lost", .statement = {1, 2}}, in_words, {{x, ex(1)}, {y, ex(2)}}),
      NotProved);
}

TEST_CASE("an index is no positive symbol of the same name", "[exam]") {
  Kernel kernel = new_kernel();
  const std::map<std::string, long> q_from_zero{{"q", 0}};
  CHECK_THROWS_AS(
      kernel.positivity(
          {.id = "index", .statement = {q, Relation::greater, 0}, .indices = q_from_zero}),
      NotProved);
  const Theorem positive = kernel.identity({.id = "number", .statement = {sqrt(pow(q, 2)), q}});
  CHECK_THROWS_AS(
      kernel.consequence({.id = "mixed", .statement = {sqrt(pow(q, 2)), q}, .indices = q_from_zero},
                         {{positive, 1}}),
      NotProved);
  CHECK_THROWS_AS(
      kernel.instance(
          {.id = "same name", .statement = {sqrt(pow(q, 2)), q}, .indices = q_from_zero}, positive,
          {}),
      NotProved);
}

TEST_CASE("a count is not the same for other parameters", "[exam]") {
  Kernel kernel({.positive = {"V", "alpha"}, .integer = {}});
  const ex alpha = symbol("alpha"), psi = symbol("psi");
  kernel.definition({.id = "psi", .statement = {psi, 2 * atan(sqrt(alpha * (2 + alpha)))}});
  const auto speed = [&](const char* id, long shift) {
    return kernel.law({.id = id,
                       .statement = {a(n) - b(n + shift - 1), V * sin((2 * n + shift) * psi / 2)},
                       .indices = from_zero});
  };
  const Theorem count = kernel.collision_count(
      {.id = "N", .statement = {symbol("N"), ceiling(2 * GiNaC::Pi / psi) - 1}}, speed("P", 1),
      speed("Q", 2), n, psi / 2);
  CHECK_THROWS_AS(
      kernel.instance({.id = "one", .statement = {symbol("N"), 2}}, count, {{alpha, ex(1)}}),
      NotProved);
}
