// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/form.hpp"

#include <stdexcept>
#include <string>

#include <catch2/catch.hpp>

#include "equality/parse.hpp"

using namespace magicmass::equality;

namespace {

bool has_form(const std::string& expression, const std::string& form) {
  return what_lacks_form(parse(expression), form).empty();
}

}  // namespace

TEST_CASE("a form is about how an answer is written", "[exam]") {
  CHECK(has_form("2*(a + b)/c", "factored"));
  CHECK_FALSE(has_form("a*c + b*c", "factored"));
  CHECK_FALSE(has_form("(a + b)/c", "factored"));
  CHECK(has_form("a*c + b*c", "expanded"));
  CHECK_FALSE(has_form("(a + b)*c", "expanded"));
  CHECK_FALSE(has_form("(a + b)^2", "expanded"));
  CHECK(has_form("(a + b)/(c + d)", "a single fraction"));
  CHECK_FALSE(has_form("a/b + 1", "a single fraction"));
  CHECK_FALSE(has_form("(1/a + 1)/b", "a single fraction"));
  CHECK(has_form("3/4 - 1/4", "a number"));
  CHECK_FALSE(has_form("sqrt(4)", "a number"));
  CHECK(has_form("sqrt(5) - 2", "no trigonometric functions"));
  CHECK_FALSE(has_form("1/cos(pi/5) - 1", "no trigonometric functions"));
  CHECK_FALSE(has_form("2*atan(x)", "no trigonometric functions"));
  CHECK(has_form("x^2", "no roots"));
  CHECK_FALSE(has_form("x^(1/2)", "no roots"));
  CHECK(has_form("2*V/(2 + alpha)", "no abbreviations"));
  CHECK_FALSE(has_form("2*V_CM", "no abbreviations"));
}

TEST_CASE("every form has a name and another is refused", "[exam]") {
  for (const std::string& name : form_names()) CHECK_NOTHROW(what_lacks_form(parse("x"), name));
  CHECK_THROWS_AS(what_lacks_form(parse("x"), "nice"), std::out_of_range);
}
