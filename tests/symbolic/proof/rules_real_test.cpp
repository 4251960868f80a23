// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::Pi;

namespace {

const ex alpha = symbol("alpha"), x = symbol("x"), y = symbol("y"), psi = symbol("psi");

Kernel new_kernel() { return Kernel({.positive = {"alpha"}, .integer = {}}); }

}  // namespace

TEST_CASE("a square that is zero has a root that is zero, and nothing else has", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem square = kernel.hypothesis({.id = "s", .statement = {x * x - 2 * x * y, -y * y}});
  CHECK_NOTHROW(kernel.vanishing_square({.id = "a", .statement = {x, y}}, square));
  CHECK_THROWS_AS(kernel.vanishing_square({.id = "b", .statement = {x, -y}}, square), NotProved);
  CHECK_THROWS_AS(kernel.vanishing_square({.id = "c", .statement = {x, 0}}, square), NotProved);
  CHECK_THROWS_AS(
      kernel.vanishing_square({.id = "d", .statement = {x, Relation::greater, y}}, square),
      NotProved);
  const Theorem product = kernel.hypothesis({.id = "p", .statement = {x * y, 0}});
  CHECK_THROWS_AS(kernel.vanishing_square({.id = "e", .statement = {x, 0}}, product), NotProved);
  const Theorem differs =
      kernel.hypothesis({.id = "f", .statement = {pow(x, 2), Relation::not_equal, 0}});
  CHECK_THROWS_AS(kernel.vanishing_square({.id = "g", .statement = {x, 0}}, differs), NotProved);
  Kernel other = new_kernel();
  CHECK_THROWS_AS(other.vanishing_square({.id = "h", .statement = {x, y}}, square), NotProved);
  // [[0, 1], [0, 0]] squared is zero, and it is not.
  const GiNaC::matrix nilpotent{{0, 1}, {0, 0}}, zero{{0, 0}, {0, 0}};
  const Theorem none =
      kernel.identity({.id = "m", .statement = {(nilpotent * ex(nilpotent)).evalm(), zero}});
  CHECK_THROWS_AS(kernel.vanishing_square({.id = "n", .statement = {nilpotent, zero}}, none),
                  NotProved);
}

TEST_CASE("the root's condition stays", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem square = kernel.hypothesis({.id = "s", .statement = {pow(x, 2), 0}});
  CHECK(kernel.vanishing_square({.id = "a", .statement = {x, 0}}, square).step().conditions ==
        std::vector<std::string>{"x^2 = 0"});
}

TEST_CASE("angles from 0 to pi are compared by their cosines", "[exam]") {
  Kernel kernel = new_kernel();
  kernel.definition({.id = "psi", .statement = {psi, 2 * atan(sqrt(alpha))}});
  const Theorem lighter =
      kernel.hypothesis({.id = "l", .statement = {1 - alpha, Relation::greater, 0}});
  const Theorem below =
      kernel.larger_angle({.id = "a", .statement = {Pi / 2, Relation::greater, psi}}, lighter);
  CHECK(below.step().conditions == std::vector<std::string>{"1 - alpha > 0", "alpha > 0"});
  int number = 0;
  const auto refused = [&](const Statement& statement, const Theorem& sign) {
    CHECK_THROWS_AS(
        kernel.larger_angle({.id = "r" + std::to_string(++number), .statement = statement}, sign),
        NotProved);
  };
  refused({psi, Relation::greater, Pi / 2}, lighter);  // the other way round
  refused({Pi / 3, Relation::greater, psi}, lighter);  // another bound: not a multiple of it
  refused({Pi / 2, psi}, lighter);                     // not that relation
  refused({psi, Relation::less_equal, Pi / 2}, lighter);
  refused({3 * Pi / 2, Relation::greater, psi}, lighter);  // outside [0, pi]
  refused({Pi / 2, Relation::greater, -psi}, lighter);
  refused({Pi / 2, Relation::greater, 2 * psi}, lighter);
  refused({Pi / 2, Relation::greater, Pi / 2}, lighter);
  refused({Pi / 2, Relation::greater, x}, lighter);
  const Theorem equation = kernel.hypothesis({.id = "e", .statement = {1 - alpha, 0}});
  refused({Pi / 2, Relation::greater, psi}, equation);  // says nothing of a sign
  const Theorem zero =
      kernel.hypothesis({.id = "z",
                         .statement = {(alpha + 1) * (alpha + 1) - alpha * alpha - 2 * alpha - 1,
                                       Relation::greater, 0}});
  refused({Pi / 2, Relation::greater, psi}, zero);  // 0 > 0: nothing is a multiple of it
}
