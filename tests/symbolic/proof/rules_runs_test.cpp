// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;

namespace {

const ex j = symbol("j"), x = symbol("x"), y = symbol("y");
const std::map<std::string, long> from_one{{"j", 1}}, from_two{{"j", 2}};

}  // namespace

TEST_CASE("what no step changes is unchanged, and every condition is kept for each step",
          "[exam]") {
  Kernel kernel({});
  const Theorem comes = kernel.hypothesis({.id = "c", .statement = {v(j), x}, .indices = from_one});
  const Theorem goes =
      kernel.hypothesis({.id = "g", .statement = {v(j + 1), x}, .indices = from_one});
  const Theorem step = kernel.consequence(
      {.id = "s", .statement = {v(j + 1), v(j)}, .indices = from_one}, {{goes, 1}, {comes, -1}});
  const Theorem also = kernel.hypothesis({.id = "d", .statement = {y, Relation::greater, 3}});
  const Theorem all = kernel.unchanged_through_runs(
      {.id = "a", .statement = {v(j), v(1)}, .indices = from_one}, step, j, {also});
  CHECK(all.step().conditions ==
        std::vector<std::string>{
            "for every step j up to there, with a run and values of its own: v(j + 1) = x; "
            "v(j) = x; y > 3",
            "j integer, j >= 1"});

  int number = 0;
  const auto refused = [&](const Statement& statement, const Theorem& by,
                           const std::map<std::string, long>& indices = from_one) {
    CHECK_THROWS_AS(
        kernel.unchanged_through_runs(
            {.id = "r" + std::to_string(++number), .statement = statement, .indices = indices}, by,
            j),
        NotProved);
  };
  refused({v(j), v(2)}, step);
  refused({v(j), v(0)}, step, {{"j", 0}});  // the step is known from 1 on
  refused({v(j), x}, step);                 // x may be another for each step
  refused({v(j), v(1) + 1}, step);
  refused({w(j), w(1)}, step);
  refused({v(j + 1), v(1)}, step);
  refused({v(j), Relation::greater, v(1)}, step);
  refused({v(j), v(1)}, step, {});
  refused({v(j), v(1)}, comes);
  refused({v(j), v(1)}, goes);
  const Theorem late =
      kernel.hypothesis({.id = "l", .statement = {v(j + 1), v(j)}, .indices = from_two});
  refused({v(j), v(1)}, late);
  const Theorem grows =
      kernel.hypothesis({.id = "w", .statement = {v(j + 1), v(j) + 1}, .indices = from_one});
  refused({v(j), v(1)}, grows);
  const Theorem differs = kernel.hypothesis(
      {.id = "n", .statement = {v(j + 1), Relation::not_equal, v(j)}, .indices = from_one});
  refused({v(j), v(1)}, differs);
  const Theorem any = kernel.hypothesis({.id = "i", .statement = {v(j + 1), v(j)}});
  refused({v(j), v(1)}, any);  // j is no integer there
  Kernel other({});
  const Theorem foreign =
      other.hypothesis({.id = "f", .statement = {v(j + 1), v(j)}, .indices = from_one});
  refused({v(j), v(1)}, foreign);
}
