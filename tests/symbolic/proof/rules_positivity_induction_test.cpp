// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::matrix;

namespace {

const ex n = symbol("n"), q = symbol("q"), y = symbol("y");
const std::map<std::string, long> from_zero{{"n", 0}}, from_one{{"n", 1}};

struct Setting {
  Kernel kernel{{.positive = {"q"}, .integer = {}}};
  Theorem a_0 = kernel.law({.id = "a_0", .statement = {a(0), 1}});
  Theorem b_0 = kernel.law({.id = "b_0", .statement = {b(0), q}});
  Theorem a_n =
      kernel.law({.id = "a_n", .statement = {a(n), a(n - 1) + q* b(n - 1)}, .indices = from_one});
  Theorem b_n = kernel.law({.id = "b_n", .statement = {b(n), 2 * b(n - 1)}, .indices = from_one});

  Theorem prove(const char* id, const ex& value, const matrix& factors,
                const std::vector<ex>& values,
                const std::map<std::string, long>& indices = from_zero) {
    return kernel.positivity_by_induction(
        {.id = id, .statement = {value, Relation::greater, 0}, .indices = indices}, values, factors,
        {a_0, b_0}, {a_n, b_n}, n);
  }
};

}  // namespace

TEST_CASE("signs follow by induction from non-negative factors", "[exam]") {
  Setting here;
  const Theorem positive = here.prove("p", a(n), matrix{{1, q}, {0, 2}}, {a(n), b(n)});
  CHECK(positive.step().conditions == std::vector<std::string>{"n integer, n >= 0", "q > 0"});
  CHECK(positive.statement().relation() == Relation::greater);
}

TEST_CASE("signs by induction: what does not follow is refused", "[exam]") {
  Setting here;
  const std::vector<ex> both{a(n), b(n)};
  const matrix right{{1, q}, {0, 2}};
  CHECK_THROWS_AS(here.prove("factor", a(n), matrix{{1, 2 * q}, {0, 2}}, both), NotProved);
  CHECK_THROWS_AS(here.prove("negative", a(n), matrix{{1, q - 1}, {0, 2}}, both), NotProved);
  CHECK_THROWS_AS(here.prove("unknown", a(n), matrix{{1, y}, {0, 2}}, both), NotProved);
  const ex cube_root = pow(q, GiNaC::numeric(1, 3));  // has no normal form, so no sign either
  CHECK_THROWS_WITH(here.prove("no sign", a(n), matrix{{1, cube_root}, {0, 2}}, both),
                    Catch::Contains("is not seen to be >= 0"));
  CHECK_THROWS_AS(here.prove("shape", a(n), matrix{{1}}, both), NotProved);
  CHECK_THROWS_AS(here.prove("foreign", c(n), right, both), NotProved);
  CHECK_THROWS_AS(here.prove("start", a(n), right, both, from_one), NotProved);
  CHECK_THROWS_AS(here.prove("minus", -a(n), right, {-a(n), b(n)}), NotProved);
  CHECK_THROWS_AS(here.prove("no row", b(n), matrix{{0, 0}, {0, 2}}, {a(n) - a(n), b(n)}),
                  NotProved);
  CHECK_THROWS_AS(here.kernel.positivity_by_induction(
                      {.id = "equation", .statement = {a(n), 1}, .indices = from_zero}, both, right,
                      {here.a_0, here.b_0}, {here.a_n, here.b_n}, n),
                  NotProved);
  // a(n) = 2 - n is positive at n = 0 and is not for ever.
  const Theorem c_0 = here.kernel.law({.id = "c_0", .statement = {c(0), 2}});
  const Theorem falling =
      here.kernel.law({.id = "c_n", .statement = {c(n), c(n - 1) - 1}, .indices = from_one});
  CHECK_THROWS_AS(
      here.kernel.positivity_by_induction(
          {.id = "falling", .statement = {c(n), Relation::greater, 0}, .indices = from_zero},
          {c(n)}, matrix{{1}}, {c_0}, {falling}, n),
      NotProved);
  // A recurrence from n = 2 on says nothing about the first step.
  const Theorem late = here.kernel.law(
      {.id = "late", .statement = {c_prime(n), c_prime(n - 1)}, .indices = {{"n", 2}}});
  const Theorem c_prime_0 = here.kernel.law({.id = "c'_0", .statement = {c_prime(0), 1}});
  CHECK_THROWS_AS(
      here.kernel.positivity_by_induction(
          {.id = "gap", .statement = {c_prime(n), Relation::greater, 0}, .indices = from_zero},
          {c_prime(n)}, matrix{{1}}, {c_prime_0}, {late}, n),
      NotProved);
}
