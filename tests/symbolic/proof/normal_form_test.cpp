// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/normal_form.hpp"

#include <algorithm>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/factored.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

const ex alpha = symbol("alpha"), beta = symbol("beta"), n = symbol("n"), k = symbol("k"),
         psi = symbol("psi");
const Domain positive_alpha{.positive = {"alpha"}, .integer = {{"n", 0}, {"k", 1}}};

Definitions angles() {
  Definitions definitions;
  definitions.add("psi", 2 * atan(sqrt(alpha * (2 + alpha))));
  return definitions;
}

bool vanishes(const ex& e, const Domain& domain = positive_alpha) {
  return NormalForm(domain, angles()).is_zero(e);
}

bool has_condition(const NormalForm& form, const std::string& text) {
  return std::any_of(form.conditions().begin(), form.conditions().end(),
                     [&](const Condition& condition) { return condition.text == text; });
}

}  // namespace

TEST_CASE("radicals split where their factors are known to be positive", "[exam]") {
  CHECK(vanishes(sqrt(alpha * (2 + alpha)) - sqrt(alpha) * sqrt(2 + alpha)));
  CHECK(vanishes(sqrt(alpha / (2 * (2 + alpha))) - sqrt(alpha) / sqrt(4 + 2 * alpha)));
  CHECK(vanishes(1 / (sqrt(ex(2)) - 1) - sqrt(ex(2)) - 1));
  CHECK(vanishes(sqrt(ex(12)) - 2 * sqrt(ex(3))));
  CHECK_FALSE(vanishes(sqrt(alpha * (2 + alpha)) - sqrt(alpha) * sqrt(1 + alpha)));
}

TEST_CASE("alpha > 0 is used, recorded, and missed where it is not given", "[exam]") {
  NormalForm with(positive_alpha, {});
  CHECK(with.is_zero(sqrt(pow(alpha, 2)) - alpha));
  CHECK(has_condition(with, "alpha > 0"));
  NormalForm without({}, {});
  CHECK_FALSE(without.is_zero(sqrt(pow(alpha, 2)) - alpha));
  NormalForm unused(positive_alpha, {});
  CHECK(unused.is_zero(pow(1 + alpha, 2) - 1 - 2 * alpha - pow(alpha, 2)));
  CHECK(unused.conditions().empty());
}

TEST_CASE("a denominator that may vanish becomes a condition", "[exam]") {
  NormalForm form(positive_alpha, {});
  CHECK(form.is_zero((pow(beta, 2) - 1) / (beta - 1) - beta - 1));
  CHECK(has_condition(form, "1 - beta != 0"));
  NormalForm never(positive_alpha, {});
  CHECK(never.is_zero((pow(alpha, 2) - 1) / (alpha + 1) - alpha + 1));
  CHECK_FALSE(has_condition(never, "1 + alpha != 0"));
  CHECK_THROWS_AS(form.is_zero(1 / (sqrt(pow(alpha, 2)) - alpha)), NotInClass);
}

TEST_CASE("defined angles and their halves have algebraic values", "[exam]") {
  CHECK(vanishes(cos(psi / 2) - 1 / (1 + alpha)));
  CHECK(vanishes(sin(psi / 4) - sqrt(alpha / (2 * (1 + alpha)))));
  CHECK(vanishes(tan(psi) - 2 * sqrt(alpha * (2 + alpha)) / (1 - 2 * alpha - pow(alpha, 2))));
  CHECK_FALSE(vanishes(cos(psi / 2) - 1 / (2 + alpha)));
}

TEST_CASE("independent angles obey addition theorems", "[exam]") {
  CHECK(vanishes(sin((n + 1) * psi) - sin(n * psi) * cos(psi) - cos(n * psi) * sin(psi)));
  CHECK(vanishes(2 * cos((n + numeric(1, 2)) * psi / 2) * cos((n - numeric(1, 2)) * psi / 2) -
                 cos(n * psi) - cos(psi / 2)));
  CHECK(vanishes(cos(5 * beta) - 16 * pow(cos(beta), 5) + 20 * pow(cos(beta), 3) - 5 * cos(beta)));
  CHECK_FALSE(vanishes(sin((n + 1) * psi) - sin(n * psi) * cos(psi) + cos(n * psi) * sin(psi)));
}

TEST_CASE("angles that are divided further later stay the same angles", "[exam]") {
  NormalForm form(positive_alpha, {});
  CHECK(form.is_zero(sin(2 * beta) - 2 * sin(beta) * cos(beta)));
  CHECK(form.is_zero(cos(beta) - 2 * pow(cos(beta / 2), 2) + 1));
  CHECK(form.is_zero(sin(2 * beta) - 4 * sin(beta / 2) * cos(beta / 2) * cos(beta)));
  CHECK_FALSE(form.is_zero(sin(2 * beta) - 4 * sin(beta / 2) * cos(beta / 2) * cos(beta / 2)));
}

TEST_CASE("factors that are remembered are those of that very polynomial", "[exam]") {
  const GiNaC::realsymbol other("alpha");
  for (int times = 0; times < 2; ++times)
    for (const ex& x : {ex(alpha), ex(other)}) {
      const ex factors = factored((pow(x, 2) - 1).expand());
      CHECK(GiNaC::is_a<GiNaC::mul>(factors));
      CHECK((factors - pow(x, 2) + 1).expand().is_zero());
    }
}

TEST_CASE("fractions of pi with an integer in the denominator", "[exam]") {
  CHECK(vanishes(cos(k * Pi / (k + numeric(1, 2))) + cos(Pi / (2 * k + 1))));
  CHECK(vanishes(cos((2 * k + 1) * Pi / (2 * k + 1)) + 1));
  NormalForm form(positive_alpha, {});
  CHECK(form.is_positive(cos(Pi / (2 * k + 1))));
  CHECK_FALSE(form.is_positive(cos(Pi / (2 * k - 1))));  // k = 1: cos pi
}

TEST_CASE("signs are seen or left open, never guessed", "[exam]") {
  NormalForm form(positive_alpha, {});
  CHECK(form.is_positive((1 + alpha) / (2 + pow(alpha, 2))));
  CHECK(form.is_positive(2 * k - 1));
  CHECK_FALSE(form.is_positive(1 - alpha));
  CHECK_FALSE(form.is_positive(k - 1));
  CHECK_FALSE(form.is_positive(beta));
}

TEST_CASE("what is outside the class is refused by name", "[exam]") {
  CHECK_THROWS_WITH(vanishes(exp(alpha)), Catch::Contains("exp"));
  CHECK_THROWS_AS(vanishes(pow(beta, n)), NotInClass);  // beta may be negative
  CHECK_THROWS_AS(vanishes(pow(alpha, numeric(1, 3))), NotInClass);
  CHECK_THROWS_AS(vanishes(ex(0.1) * alpha), NotInClass);
}
