// SPDX-License-Identifier: GPL-2.0-or-later
// Ways to make the kernel accept a falsehood that were found and closed; each must stay closed.
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/normal_form.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::matrix;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

const ex alpha = symbol("alpha"), x = symbol("x"), y = symbol("y"), z = symbol("z"),
         n = symbol("n"), k = symbol("k");
const ex q = symbol("q"), psi = symbol("psi");

Kernel new_kernel() { return Kernel({.positive = {"alpha", "q"}, .integer = {}}); }

}  // namespace

TEST_CASE("0/0 is no cofactor", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem p = kernel.identity({.id = "p", .statement = {pow(x + 1, 2), x * x + 2 * x + 1}});
  CHECK_THROWS_AS(
      kernel.consequence({.id = "q", .statement = {1, 0}}, {{p, 1 / (p.lhs() - p.rhs())}}),
      NotProved);
}

TEST_CASE("only equations are used as equations", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem positive =
      kernel.positivity({.id = "p", .statement = {alpha, Relation::greater, 0}});
  CHECK_THROWS_AS(kernel.cancellation({.id = "a", .statement = {1, 0}}, positive, alpha),
                  NotProved);
  CHECK_THROWS_AS(kernel.cases({.id = "b", .statement = {1, 0}}, {{{}, positive}}), NotProved);
  CHECK_THROWS_AS(
      kernel.equal_angles({.id = "c", .statement = {2 * atan(q), Relation::greater, 2 * atan(q)}}),
      NotProved);
  const Theorem different = kernel.law({.id = "d", .statement = {a(0), Relation::not_equal, 0}});
  const Theorem next =
      kernel.law({.id = "e", .statement = {a(n), a(n - 1) + 1}, .indices = {{"n", 1}}});
  CHECK_THROWS_AS(kernel.induction({.id = "f", .statement = {a(n), n}, .indices = {{"n", 0}}},
                                   {different}, {next}, n),
                  NotProved);
}

TEST_CASE("theorems of another kernel are no premises", "[exam]") {
  Kernel one = new_kernel(), two = new_kernel();
  const Theorem foreign = one.definition({.id = "y", .statement = {y, x}});
  two.definition({.id = "y", .statement = {y, x + 1}});
  CHECK_THROWS_AS(two.consequence({.id = "q", .statement = {1, 0}}, {{foreign, -1}}), NotProved);
  CHECK_THROWS_AS(two.instance({.id = "r", .statement = {y, x}}, foreign, {}), NotProved);
}

TEST_CASE("substitution reaches inside names, or is refused", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem named = kernel.definition({.id = "y", .statement = {y, x + 1}});
  CHECK_THROWS_AS(kernel.instance({.id = "a", .statement = {y, 6}}, named, {{x, ex(5)}}),
                  NotProved);
}

TEST_CASE("what stands for a symbol is a real number", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem p =
      kernel.positivity({.id = "p", .statement = {pow(alpha, 2) + 1, Relation::greater, 0}});
  CHECK_THROWS(kernel.instance({.id = "a", .statement = {-3, Relation::greater, 0}}, p,
                               {{alpha, 2 * GiNaC::I}}));
  CHECK_THROWS(kernel.definition({.id = "b", .statement = {z, 2 * GiNaC::I}}));
}

TEST_CASE("a definition is new and not about itself", "[exam]") {
  Kernel kernel = new_kernel();
  CHECK_THROWS_AS(kernel.definition({.id = "a", .statement = {T(n), T(n) + 1}}), NotProved);
  kernel.law({.id = "b", .statement = {y, 3}});
  CHECK_THROWS_AS(kernel.definition({.id = "c", .statement = {y, x}}), NotProved);
}

TEST_CASE("a sequence is defined where its right side is", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem defined =
      kernel.definition({.id = "T", .statement = {T(n), 1 / (x - n)}, .indices = {{"n", 0}}});
  CHECK(defined.step().conditions.size() == 1);
  CHECK_THROWS_AS(kernel.definition({.id = "t", .statement = {t(n), matrix{{1, n}}}}), NotProved);
}

TEST_CASE("a matrix power is of a constant matrix", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem S =
      kernel.definition({.id = "S", .statement = {symbol("S"), matrix{{1, n}, {0, 1}}}});
  const ex sum = n * (n - 1) / 2;
  CHECK_THROWS_AS(kernel.matrix_power({.id = "p",
                                       .statement = {pow(symbol("S"), n), matrix{{1, sum}, {0, 1}}},
                                       .indices = {{"n", 0}}},
                                      S, n),
                  NotProved);
}

TEST_CASE("the number of collisions is N, counted from velocities", "[exam]") {
  Kernel kernel = new_kernel();
  const std::map<std::string, long> from_zero{{"n", 0}};
  const ex even = 3 * sin((2 * n + 1) * Pi / 5), odd = 3 * sin((2 * n + 2) * Pi / 5);
  const Theorem one =
      kernel.identity({.id = "one", .statement = {even, even}, .indices = from_zero});
  const Theorem two = kernel.identity({.id = "two", .statement = {odd, odd}, .indices = from_zero});
  CHECK_THROWS_AS(kernel.collision_count({.id = "p", .statement = {alpha, 4}}, one, two, n, Pi / 5),
                  NotProved);
}

TEST_CASE("step functions: slopes that add, cases that never hold, two variables", "[exam]") {
  Kernel kernel({.positive = {"psi"}, .integer = {}});
  const ex u = Pi / psi, inner = numeric(1, 2) + u + sawtooth(u);
  int number = 0;
  const auto refused = [&](const Statement& statement, const ex& variable,
                           const std::vector<Statement>& where) {
    CHECK_THROWS_AS(
        kernel.step_functions({.id = "p" + std::to_string(++number), .statement = statement}, {},
                              variable, where),
        NotProved);
  };
  refused({ceiling(inner), floor(inner) + 1}, u, {});
  refused({1, 0}, u, {{u, Relation::greater, 3}});
  refused({1, 0}, u, {{sawtooth(u), Relation::greater, 2}});
  refused({ceiling(y), ceiling(u)}, y, {});
  refused({ceiling(u), floor(u)}, u, {{sawtooth(u), 0}});
}

TEST_CASE("roots of unknown sign ask for their condition", "[exam]") {
  NormalForm form({.positive = {"q"}, .integer = {}}, {});
  form.is_positive(1 + pow(atan(sqrt(y)), 2));
  CHECK(form.conditions().contains({"-y <= 0"}));
}

TEST_CASE("angles have rational factors of bounded size", "[exam]") {
  NormalForm form({}, {});
  CHECK_THROWS_AS(form.is_positive(2 + cos(ex(0.5) * x)), NotInClass);
  CHECK_THROWS_AS(form.is_positive(2 + cos(GiNaC::I * x)), NotInClass);
  CHECK_THROWS_AS(form.is_positive(2 + cos(1000000 * x)), NotInClass);
  CHECK_THROWS_AS(form.is_positive(2 + pow(x + y + 1, 3000)), NotInClass);
}

TEST_CASE("the sampling net is never empty, and poles on both sides are seen", "[exam]") {
  Kernel kernel = new_kernel();
  ex product = 1;
  for (int i = 1; i <= 10; ++i) product *= k - i;
  CHECK_THROWS_AS(
      kernel.identity({.id = "p", .statement = {1 / product, 1 / product}, .indices = {{"k", 1}}}),
      NotProved);
  const Theorem shared =
      kernel.identity({.id = "q", .statement = {x + 1 / (x - y), x + 1 / (x - y)}});
  CHECK(shared.step().conditions == std::vector<std::string>{"x - y != 0"});
}

TEST_CASE("cases are conditions, and one name is one symbol", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem trivial = kernel.identity({.id = "t", .statement = {y, y}});
  const Theorem by_cases = kernel.cases({.id = "c", .statement = {x, y}}, {{{{x, y}}, trivial}});
  CHECK(by_cases.step().conditions == std::vector<std::string>{"x = y"});
  const ex impostor = GiNaC::realsymbol("x");
  CHECK_THROWS(kernel.identity({.id = "i", .statement = {impostor, impostor}}));
  CHECK_THROWS(symbol("cos(x)"));
  CHECK_THROWS(symbol("pi"));
}

TEST_CASE("a law speaks of its own symbols, save those that it leaves open", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem before = kernel.identity({.id = "b", .statement = {pow(x, 2), x * x}});
  const Theorem speed = kernel.law({.id = "l", .statement = {x, 3}});
  CHECK_THROWS_AS(kernel.instance({.id = "p", .statement = {5, 3}}, speed, {{x, ex(5)}}),
                  NotProved);
  const Theorem rests = kernel.consequence({.id = "r", .statement = {x + y, 3 + y}}, {{speed, 1}});
  CHECK_THROWS_AS(kernel.instance({.id = "q", .statement = {5 + y, 3 + y}}, rests, {{x, ex(5)}}),
                  NotProved);
  CHECK_NOTHROW(kernel.instance({.id = "s", .statement = {x + 1, 4}}, rests, {{y, ex(1)}}));
  CHECK_THROWS_AS(kernel.instance({.id = "t", .statement = {25, 25}}, before, {{x, ex(5)}}),
                  NotProved);  // more careful than need be

  // A name in a law fixes what it stands for.
  kernel.definition({.id = "d", .statement = {symbol("D"), q + 1}});
  const Theorem of_name = kernel.law({.id = "m", .statement = {symbol("D"), 7}});
  const Theorem written = kernel.consequence({.id = "w", .statement = {q + 1, 7}}, {{of_name, 1}});
  CHECK_THROWS_AS(kernel.instance({.id = "u", .statement = {3, 7}}, written, {{q, ex(2)}}),
                  NotProved);

  // What a law leaves open may be put in, and nothing else.
  const Theorem any = kernel.law({.id = "a", .statement = {z * y, q}, .schematic = {"z", "y"}});
  CHECK_NOTHROW(kernel.instance({.id = "v", .statement = {5 * y, q}}, any, {{z, ex(5)}}));
  CHECK_THROWS_AS(kernel.instance({.id = "n", .statement = {z * y, 2 * q}}, any, {{q, 2 * q}}),
                  NotProved);
}

TEST_CASE("the conditions of an inductive step are needed from the second index on", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem first = kernel.law({.id = "f", .statement = {a(1), 0}});
  const Theorem next = kernel.law({.id = "n",
                                   .statement = {a(n), a(n - 1) + x / sin(n * x) - x / sin(n * x)},
                                   .indices = {{"n", 2}}});
  const Theorem all = kernel.induction({.id = "a", .statement = {a(n), 0}, .indices = {{"n", 1}}},
                                       {first}, {next}, n);
  CHECK(all.step().conditions == std::vector<std::string>{"n integer, n >= 1"});
  const Theorem product = kernel.law(
      {.id = "p", .statement = {b(n) * sin(n * x), b(n - 1) * sin(n * x)}, .indices = {{"n", 2}}});
  const Theorem recurrence =
      kernel.consequence({.id = "r", .statement = {b(n), b(n - 1)}, .indices = {{"n", 2}}},
                         {{product, 1 / sin(n * x)}});
  const Theorem start = kernel.law({.id = "t", .statement = {b(1), 5}});
  const Theorem constant = kernel.induction(
      {.id = "c", .statement = {b(n), 5}, .indices = {{"n", 1}}}, {start}, {recurrence}, n);
  CHECK(constant.step().conditions ==
        std::vector<std::string>{"n integer, n >= 1",
                                 "sin(n*x) != 0 for every n from 2 up to there"});
}
