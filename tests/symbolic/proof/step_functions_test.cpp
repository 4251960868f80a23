// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

const ex psi = symbol("psi"), k = symbol("k"), x = Pi / psi;
const ex half = numeric(1, 2);

Theorem decide(const Statement& statement, const std::vector<Statement>& where = {}) {
  Kernel kernel({.positive = {"psi"}, .integer = {}});
  return kernel.step_functions({.id = "test", .statement = statement}, {}, x, where);
}

}  // namespace

TEST_CASE("true identities of ceilings and floors are accepted", "[exam]") {
  CHECK_NOTHROW(decide({ceiling((ceiling(2 * x) - 1) / 2), ceiling(x - half)}));
  CHECK_NOTHROW(decide({ceiling(x) + ceiling(x - half), ceiling(2 * x)}));
  CHECK_NOTHROW(decide({floor(x) + sawtooth(x), x}));
  CHECK_NOTHROW(decide({ceiling(x / 3 - numeric(1, 7)), -floor(numeric(1, 7) - x / 3)}));
}

TEST_CASE("false ones are refused with the point where they fail", "[exam]") {
  CHECK_THROWS_WITH(decide({ceiling(x), floor(x) + 1}),
                    Catch::Contains("pi/psi = 0"));  // only at whole numbers
  CHECK_THROWS_AS(decide({ceiling(x - half), ceiling(x)}), NotProved);
  CHECK_THROWS_AS(decide({ceiling(x + numeric(1, 1000)), ceiling(x)}), NotProved);
  CHECK_THROWS_AS(decide({sawtooth(x), x}), NotProved);
}

TEST_CASE("a case is used as given, and no wider", "[exam]") {
  const Statement above_zero{sawtooth(x), Relation::greater, 0};
  const Theorem theorem = decide({ceiling(x), floor(x) + 1}, {above_zero});
  CHECK(theorem.step().conditions == std::vector<std::string>{"sawtooth(pi/psi) > 0"});
  CHECK_THROWS_AS(
      decide({ceiling(x), floor(x) + 1}, {Statement{sawtooth(x), Relation::less_equal, half}}),
      NotProved);
}

TEST_CASE("an integer variable takes integer values only", "[exam]") {
  Kernel kernel({});
  CHECK_NOTHROW(kernel.step_functions(
      {.id = "integer", .statement = {ceiling(k - half), k}, .indices = {{"k", 1}}}, {}, k));
  CHECK_THROWS_AS(
      kernel.step_functions(
          {.id = "wrong", .statement = {ceiling(k - half), k - 1}, .indices = {{"k", 1}}}, {}, k),
      NotProved);
}

TEST_CASE("anything else is refused", "[exam]") {
  CHECK_THROWS_AS(decide({ceiling(pow(x, 2)), ceiling(pow(x, 2))}), NotProved);
}
