// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;

namespace {

const ex M = symbol("M"), q = symbol("q"), lambda = symbol("b"), n = symbol("n"), p = symbol("p"),
         y = symbol("y");
const std::map<std::string, long> from_one{{"n", 1}};
const std::vector<Statement> above_one{{lambda, Relation::greater, 1}};

Kernel new_kernel() { return Kernel({.positive = {"M", "q", "b"}, .integer = {}}); }

Theorem as_M_grows(Kernel& kernel, const ex& f, const ex& value, const ex& form,
                   const ex& vanishing = 1 / M) {
  static int number = 0;
  return kernel.limit(
      {.id = "limit " + std::to_string(++number), .statement = {limit_at_infinity(f, M), value}},
      std::nullopt, form, p, vanishing);
}

}  // namespace

TEST_CASE("limits of rational functions", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem one = as_M_grows(kernel, M / (M + q), 1, 1 / (1 + q * p));
  CHECK(one.step().from == "lim(M/(M + q), M)");
  CHECK_NOTHROW(as_M_grows(kernel, sqrt(q) * (2 * M + y) / M, 2 * sqrt(q), sqrt(q) * (2 + y * p)));
  const Theorem powers =
      kernel.law({.id = "a",
                  .statement = {a(n), (pow(lambda, n) + 1) / (pow(lambda, n) + q)},
                  .indices = from_one});
  CHECK_NOTHROW(kernel.limit({.id = "powers",
                              .statement = {limit_at_infinity(a(n), n), 1},
                              .indices = from_one,
                              .assuming = above_one},
                             powers, (1 + p) / (1 + q * p), p, pow(lambda, -n)));
}

TEST_CASE("limits that do not follow are refused", "[exam]") {
  Kernel kernel = new_kernel();
  const ex f = M / (M + q);
  CHECK_THROWS_AS(as_M_grows(kernel, f, 2, 1 / (1 + q * p)), NotProved);         // the value
  CHECK_THROWS_AS(as_M_grows(kernel, f, 1, 1 / (1 + 2 * q * p)), NotProved);     // the form
  CHECK_THROWS_AS(as_M_grows(kernel, f, M, 1 / (1 + q * p)), NotProved);         // depends on M
  CHECK_THROWS_AS(as_M_grows(kernel, M, 0, 1 / p), NotProved);                   // infinite
  CHECK_THROWS_AS(as_M_grows(kernel, f, 1, 1 / (1 + q * p), M), NotProved);      // grows
  CHECK_THROWS_AS(as_M_grows(kernel, f, 1, 1 / (1 + q * p), 1 / q), NotProved);  // constant
  CHECK_THROWS_AS(as_M_grows(kernel, sqrt(1 / M), 0, sqrt(p)), NotProved);       // not rational
  CHECK_THROWS_AS(as_M_grows(kernel, (1 / M) / (y / M + 1 / M), 1 / (y + 1), p / (y * p + p)),
                  NotProved);  // y + 1 may vanish
  CHECK_THROWS_AS(kernel.limit({.id = "inequality",
                                .statement = {limit_at_infinity(f, M), Relation::greater, 0}},
                               std::nullopt, 1 / (1 + q * p), p, 1 / M),
                  NotProved);
  CHECK_THROWS_AS(kernel.limit({.id = "no limit", .statement = {f, 1}}, std::nullopt,
                               1 / (1 + q * p), p, 1 / M),
                  NotProved);
  CHECK_THROWS_AS(kernel.limit({.id = "any sign", .statement = {limit_at_infinity(1 / y, y), 0}},
                               std::nullopt, p, p, 1 / y),
                  NotProved);
  // b^n does not grow unless b > 1 is known; and what holds for n <= 5 has no limit.
  const Theorem powers =
      kernel.law({.id = "a", .statement = {a(n), pow(lambda, -n)}, .indices = from_one});
  const Claim claim{
      .id = "small base", .statement = {limit_at_infinity(a(n), n), 0}, .indices = from_one};
  CHECK_THROWS_AS(kernel.limit(claim, powers, p, p, pow(lambda, -n)), NotProved);
  const Theorem bounded = kernel.hypothesis({.id = "bounded", .statement = {M, q}});
  const Theorem known = kernel.law({.id = "known", .statement = {lambda, M}});
  const Theorem only_there =
      kernel.consequence({.id = "there", .statement = {lambda, q}}, {{known, 1}, {bounded, 1}});
  CHECK_THROWS_AS(kernel.limit({.id = "bound", .statement = {limit_at_infinity(lambda, M), q}},
                               only_there, q, p, 1 / M),
                  NotProved);
}

TEST_CASE("a limit is no value of its sequence", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem limit = as_M_grows(kernel, M / (M + q), 1, 1 / (1 + q * p));
  CHECK_THROWS(kernel.consequence({.id = "c", .statement = {M / (M + q), 1}}, {{limit, 1}}));
  CHECK_THROWS(kernel.instance({.id = "i", .statement = {1 / (1 + q), 1}}, limit, {{M, ex(1)}}));
}

TEST_CASE("the first and all later ones", "[exam]") {
  Kernel kernel = new_kernel();
  const Theorem first = kernel.law({.id = "first", .statement = {a(0), 1}});
  const Theorem later =
      kernel.law({.id = "later", .statement = {a(n), pow(q, n)}, .indices = from_one});
  const std::map<std::string, long> from_zero{{"n", 0}};
  CHECK_NOTHROW(kernel.first_and_later(
      {.id = "all", .statement = {a(n), pow(q, n)}, .indices = from_zero}, first, later, n));
  CHECK_THROWS_AS(kernel.first_and_later(
                      {.id = "wrong", .statement = {a(n), 2 * pow(q, n)}, .indices = from_zero},
                      first, later, n),
                  NotProved);
  const Theorem other = kernel.law({.id = "other", .statement = {b(0), 1}});
  CHECK_THROWS_AS(
      kernel.first_and_later({.id = "mixed", .statement = {a(n), pow(q, n)}, .indices = from_zero},
                             other, later, n),
      NotProved);
  const Theorem much_later =
      kernel.law({.id = "much later", .statement = {c(n), pow(q, n)}, .indices = {{"n", 2}}});
  const Theorem c_0 = kernel.law({.id = "c_0", .statement = {c(0), 1}});
  CHECK_THROWS_AS(
      kernel.first_and_later({.id = "gap", .statement = {c(n), pow(q, n)}, .indices = from_zero},
                             c_0, much_later, n),
      NotProved);
  const Theorem wrong_start = kernel.law({.id = "wrong start", .statement = {a(0), 2}});
  CHECK_THROWS_AS(
      kernel.first_and_later({.id = "start", .statement = {a(n), pow(q, n)}, .indices = from_zero},
                             wrong_start, later, n),
      NotProved);
}
