// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/normal_form.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

const ex e = symbol("e"), lambda = symbol("b"), x = symbol("x"), n = symbol("n"), k = symbol("k");
const Domain domain{.positive = {"e", "b"}, .integer = {{"n", 1}}};

bool vanishes(const ex& expression) { return NormalForm(domain, {}).is_zero(expression); }

Domain above_one() {
  Domain result = domain;
  result.assumed.push_back({lambda, Relation::greater, 1});
  return result;
}

}  // namespace

TEST_CASE("powers with a symbolic exponent obey the laws of exponents", "[exam]") {
  CHECK(vanishes(pow(e, n + 1) - e * pow(e, n)));
  CHECK(vanishes(pow(e, 2 * n) - pow(pow(e, n), 2)));
  CHECK(vanishes(pow(sqrt(e), 2 * n) - pow(e, n)));
  CHECK(vanishes(pow(e, n / 2) - pow(sqrt(e), n)));
  CHECK(vanishes(pow(e, n) * pow(e, -n) - 1));
  CHECK(vanishes(pow(e, n + k) - pow(e, n) * pow(e, k)));
  CHECK_FALSE(vanishes(pow(e, n + 1) - pow(e, n)));
  CHECK_FALSE(vanishes(pow(e, n) - pow(e, k)));
  CHECK_FALSE(vanishes(pow(e, n) - pow(lambda, n)));
  CHECK_FALSE(vanishes(pow(e, 2 * n) - pow(e, n)));
}

TEST_CASE("only positive bases have powers, and exponents are moderate", "[exam]") {
  CHECK_THROWS_AS(vanishes(pow(x, n)), NotInClass);
  CHECK_THROWS_AS(vanishes(pow(-e, n)), NotInClass);
  CHECK_THROWS_AS(vanishes(pow(e, n / 3)), NotInClass);
  CHECK_THROWS_AS(vanishes(pow(e, 1000 * n)), NotInClass);
  CHECK_THROWS_AS(vanishes(pow(e, pow(x, numeric(1, 3)))), NotInClass);
  NormalForm form(domain, {});
  CHECK(form.is_zero(pow(e, n + 1) / e - pow(e, n)));
  CHECK(form.conditions().contains({"e > 0"}));
}

TEST_CASE("a power that is simplified keeps its value", "[exam]") {
  const auto value = [](const ex& expression) {
    return expression.subs(GiNaC::lst{e == numeric(9, 4), n == 3});
  };
  NormalForm form(domain, {});
  for (const ex& power : {ex(pow(e, n)), ex(pow(e, n + 1) / e), ex(pow(e, 2 * n)),
                          ex(pow(e, n / 2)), ex(pow(e, -n) * (1 + pow(e, n / 2)))}) {
    CAPTURE(power);
    CHECK(value(form.simplified(power)).is_equal(value(power)));
  }
  CHECK_FALSE(value(form.simplified(pow(e, n))).is_equal(value(pow(e, n / 2))));
}

TEST_CASE("powers of b > 1 grow, and no others", "[exam]") {
  NormalForm form(above_one(), {});
  CHECK(form.is_positive(pow(lambda, 2 * n) - 1));
  CHECK(form.is_positive(pow(lambda, 4 * n) - pow(lambda, 2)));
  CHECK(form.is_positive(lambda - 1));
  CHECK(form.conditions().contains({"b > 1"}));
  CHECK_FALSE(form.is_positive(pow(lambda, n) - pow(lambda, 2)));      // n = 1
  CHECK_FALSE(form.is_positive(pow(lambda, 2 * n) - pow(lambda, 2)));  // zero at n = 1
  CHECK_FALSE(form.is_positive(pow(lambda, 2 * k) - 1));               // k may be negative
  CHECK_FALSE(form.is_positive(pow(e, 2 * n) - 1));
  CHECK_FALSE(form.is_positive(1 - pow(lambda, n)));
  NormalForm without(domain, {});
  CHECK_FALSE(without.is_positive(pow(lambda, 2 * n) - 1));
}
