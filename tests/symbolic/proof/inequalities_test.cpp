// SPDX-License-Identifier: GPL-2.0-or-later
// The rules for inequalities: what they accept, and the falsehoods that they refuse.
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

const ex x = symbol("x"), y = symbol("y"), p = symbol("p"), n = symbol("n"), X = symbol("N_x");
const std::map<std::string, long> from_one{{"n", 1}};

Kernel fresh() { return Kernel({.positive = {"p", "q"}, .integer = {}}); }
Theorem supposed(Kernel& kernel, const std::string& id, const Statement& statement,
                 const std::map<std::string, long>& indices = {}) {
  return kernel.hypothesis({.id = id, .statement = statement, .indices = indices});
}

}  // namespace

TEST_CASE("a sum of what is positive orders two sides", "[exam]") {
  Kernel kernel = fresh();
  const Theorem above = supposed(kernel, "above", {x, Relation::greater, y});
  const Theorem weak = supposed(kernel, "weak", {y, Relation::less_equal, x});
  CHECK_NOTHROW(kernel.ordering({.id = "scaled", .statement = {p * x, Relation::greater, p * y}},
                                {{p, {above}, 1}}));
  CHECK_NOTHROW(kernel.ordering(
      {.id = "square", .statement = {2 * x * y, Relation::less_equal, pow(x, 2) + pow(y, 2)}},
      {{1, {}, x - y}}));

  const auto refused = [&](const Statement& statement,
                           const std::vector<Kernel::NonnegativeTerm>& terms) {
    CHECK_THROWS_AS(kernel.ordering({.id = "wrong", .statement = statement}, terms), NotProved);
  };
  refused({-p * x, Relation::greater, -p * y}, {{-p, {above}, 1}});  // a negative coefficient
  refused({y * x, Relation::greater, y * y}, {{y, {above}, 1}});     // one of unknown sign
  refused({x, Relation::greater, y}, {{1, {weak}, 1}});              // strict from weak
  refused({pow(x, 2) + pow(y, 2), Relation::greater, 2 * x * y}, {{1, {}, x - y}});
  refused({x, Relation::greater, 2 * y}, {{1, {above}, 1}});  // another difference
  refused({0, Relation::greater, 1}, {});
  refused({x, y}, {{1, {above}, 1}});                       // not an inequality
  refused({x, Relation::not_equal, y}, {{1, {above}, 1}});  // nor this
  const Theorem different = supposed(kernel, "different", {x, Relation::not_equal, y});
  refused({x, Relation::greater, y}, {{1, {different}, 1}});
  const Theorem equal = supposed(kernel, "equal", {x, y});
  refused({x, Relation::greater, y}, {{1, {equal}, 1}});
  // A square that may vanish makes nothing strict; 1/x does not vanish, but is defined for x != 0 only.
  refused({pow(x, 2), Relation::greater, 0}, {{1, {}, x}});
  const Theorem inverse = kernel.ordering(
      {.id = "inverse", .statement = {1 / pow(x, 2), Relation::greater, 0}}, {{1, {}, 1 / x}});
  CHECK_THAT(inverse.step().conditions, Catch::VectorContains(std::string("x != 0")));

  Kernel other = fresh();
  CHECK_THROWS_AS(
      other.ordering({.id = "foreign", .statement = {x, Relation::greater, y}}, {{1, {above}, 1}}),
      NotProved);
}

TEST_CASE("an index of a premise is not forgotten", "[exam]") {
  Kernel kernel = fresh();
  const Theorem later = supposed(kernel, "later", {n * x, Relation::greater, 0}, {{"n", 3}});
  CHECK_THROWS_AS(
      kernel.ordering(
          {.id = "from_one", .statement = {n * x, Relation::greater, 0}, .indices = from_one},
          {{1, {later}, 1}}),
      NotProved);
}

TEST_CASE("not more and different is less", "[exam]") {
  Kernel kernel = fresh();
  const Theorem weak = supposed(kernel, "weak", {x, Relation::less_equal, y});
  const Theorem different = supposed(kernel, "different", {y, Relation::not_equal, x});
  const Theorem elsewhere = supposed(kernel, "elsewhere", {x, Relation::not_equal, 2 * y});
  CHECK_NOTHROW(
      kernel.strictly({.id = "less", .statement = {y, Relation::greater, x}}, weak, different));
  CHECK_THROWS_AS(
      kernel.strictly({.id = "more", .statement = {x, Relation::greater, y}}, weak, different),
      NotProved);
  CHECK_THROWS_AS(
      kernel.strictly({.id = "other", .statement = {y, Relation::greater, x}}, weak, elsewhere),
      NotProved);
}

TEST_CASE("what has no normal form is not taken for zero", "[exam]") {
  Kernel kernel = fresh();
  const Theorem weak = supposed(kernel, "weak", {y, Relation::less_equal, x});
  const Theorem elsewhere =
      supposed(kernel, "elsewhere", {pow(x, numeric(1, 3)), Relation::not_equal, y});
  CHECK_THROWS_WITH(
      kernel.strictly({.id = "wrong", .statement = {x, Relation::greater, y}}, weak, elsewhere),
      Catch::Contains("elsewhere is not about the same two sides"));
  CHECK_THROWS_AS(
      kernel.positivity({.id = "root", .statement = {pow(p, numeric(1, 3)), Relation::greater, 0}}),
      NotProved);
}

TEST_CASE("what a ceiling says", "[exam]") {
  Kernel kernel = fresh();
  const Theorem count = supposed(kernel, "count", {X, ceiling(x - 1)});
  CHECK_NOTHROW(
      kernel.ceiling_bound({.id = "low", .statement = {x, Relation::less_equal, X + 1}}, count));
  CHECK_NOTHROW(
      kernel.ceiling_bound({.id = "high", .statement = {p * x, Relation::greater, p * X}}, count));
  for (const Statement& wrong :
       {Statement{x, Relation::less_equal, X}, Statement{x, Relation::greater, X + 1},
        Statement{X, Relation::greater, x}, Statement{X + 1, Relation::less_equal, x},
        Statement{-x, Relation::greater, -X}, Statement{y * x, Relation::less_equal, y * (X + 1)}})
    CHECK_THROWS_AS(kernel.ceiling_bound({.id = "wrong", .statement = wrong}, count), NotProved);

  const Theorem at_most = supposed(kernel, "at_most", {x, Relation::less_equal, n + 1}, from_one);
  const Theorem above = supposed(kernel, "above", {x, Relation::greater, n}, from_one);
  const auto value = [&](const std::string& id, const ex& number) {
    return kernel.ceiling_value({.id = id, .statement = {X, number}, .indices = from_one}, count,
                                at_most, above);
  };
  CHECK_NOTHROW(value("n", n));
  CHECK_THROWS_AS(value("more", n + 1), NotProved);
  CHECK_THROWS_AS(value("half", n + numeric(1, 2)), NotProved);
  CHECK_THROWS_AS(kernel.ceiling_value({.id = "swapped", .statement = {X, n}, .indices = from_one},
                                       count, above, at_most),
                  NotProved);
}

TEST_CASE("signs of sines", "[exam]") {
  Kernel kernel = fresh();
  const Theorem below = supposed(kernel, "below", {Pi, Relation::greater, p});
  const Theorem up_to = supposed(kernel, "up_to", {p, Relation::less_equal, Pi});
  const Theorem beyond = supposed(kernel, "beyond", {p, Relation::greater, Pi});
  const Theorem within = supposed(kernel, "within", {2 * Pi, Relation::greater, p});
  const auto sign = [&](const std::string& id, const Statement& statement,
                        const std::vector<Theorem>& bounds) {
    return kernel.sine_sign({.id = id, .statement = statement}, bounds);
  };
  CHECK_NOTHROW(sign("1", {sin(p), Relation::greater, 0}, {below}));
  CHECK_NOTHROW(sign("2", {0, Relation::less_equal, sin(p)}, {up_to}));
  CHECK_NOTHROW(sign("3", {0, Relation::greater, sin(p)}, {beyond, within}));
  CHECK_NOTHROW(
      sign("4", {cos(p / 2), Relation::greater, 0},
           {kernel.ordering({.id = "half", .statement = {Pi / 2, Relation::greater, p / 2}},
                            {{numeric(1, 2), {below}, 1}})}));
  CHECK_THROWS_AS(sign("5", {sin(p), Relation::greater, 0}, {up_to}), NotProved);   // p = pi
  CHECK_THROWS_AS(sign("6", {sin(p), Relation::greater, 0}, {within}), NotProved);  // p = 4
  CHECK_THROWS_AS(sign("7", {sin(x), Relation::greater, 0}, {below}), NotProved);
  CHECK_THROWS_AS(sign("8", {0, Relation::greater, sin(p)}, {beyond}), NotProved);  // p = 7
  CHECK_THROWS_AS(sign("9", {0, Relation::greater, sin(p)}, {within}), NotProved);
  CHECK_THROWS_AS(sign("10", {cos(p), Relation::greater, 0}, {below}), NotProved);
  CHECK_THROWS_AS(sign("11", {sin(p), Relation::less_equal, 0}, {below}), NotProved);
  CHECK_THROWS_AS(sign("12", {tan(p), Relation::greater, 0}, {below}), NotProved);
  CHECK_THROWS_AS(sign("13", {sin(p), 0}, {below}), NotProved);
}

TEST_CASE("angles below pi, and the larger of two", "[exam]") {
  Kernel kernel = fresh();
  const auto below = [&](const std::string& id, const ex& angle) {
    return kernel.angle_below_pi(
        {.id = id, .statement = {Pi, Relation::greater, angle}, .indices = from_one});
  };
  CHECK_NOTHROW(below("atan", 2 * atan(p)));
  CHECK_NOTHROW(below("part", Pi / (n + 1)));
  CHECK_THROWS_AS(below("thrice", 3 * atan(p)), NotProved);
  CHECK_THROWS_AS(below("any", p), NotProved);
  CHECK_THROWS_AS(below("whole", Pi / n), NotProved);

  const ex q = symbol("q");
  const ex angle_p = 2 * atan(p), angle_q = 2 * atan(q);
  const Theorem cosines =
      supposed(kernel, "cosines", {cos(angle_p), Relation::greater, cos(angle_q)});
  CHECK_NOTHROW(kernel.larger_angle(
      {.id = "larger", .statement = {angle_q, Relation::greater, angle_p}}, cosines));
  CHECK_THROWS_AS(
      kernel.larger_angle({.id = "smaller", .statement = {angle_p, Relation::greater, angle_q}},
                          cosines),
      NotProved);
  const Theorem free = supposed(kernel, "free", {cos(x), Relation::greater, cos(y)});
  CHECK_THROWS_AS(
      kernel.larger_angle({.id = "free_angles", .statement = {y, Relation::greater, x}}, free),
      NotProved);
}

TEST_CASE("a condition goes only when it is proved", "[exam]") {
  Kernel kernel = fresh();
  const Theorem inverse = kernel.ordering(
      {.id = "inverse", .statement = {1 / pow(x, 2), Relation::greater, 0}}, {{1, {}, 1 / x}});
  const Theorem positive = supposed(kernel, "positive", {x, Relation::greater, 0});
  const Theorem weak = supposed(kernel, "weak", {0, Relation::less_equal, x});
  const Theorem shifted = supposed(kernel, "shifted", {x, Relation::greater, 1});
  const auto without = [&](const std::string& id, const Theorem& proof) {
    return kernel.discharge({.id = id, .statement = inverse.statement()}, inverse, {proof});
  };
  CHECK(without("fine", positive).step().conditions == std::vector<std::string>{"x > 0"});
  CHECK_THROWS_AS(without("zero", weak), NotProved);
  CHECK_THROWS_AS(without("elsewhere", shifted), NotProved);
  CHECK_THROWS_AS(
      kernel.discharge({.id = "more", .statement = {2 / pow(x, 2), Relation::greater, 1}}, inverse,
                       {positive}),
      NotProved);
}
