// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/shown_text.hpp"

#include <string>

#include <catch2/catch.hpp>

using magicmass::shown_text;

TEST_CASE("text from outside is shown on one bounded line", "[exam]") {
  CHECK(shown_text("0.1x") == "0.1x");
  CHECK(shown_text("") == "(nothing)");
  CHECK(shown_text(std::string("a\0b\n\x1b\xff", 6)) == "a\\x00b\\x0a\\x1b\\xff");
  CHECK(shown_text(std::string(60, '7')) == std::string(60, '7'));
  CHECK(shown_text(std::string(61, '7')) == std::string(60, '7') + "...");
  CHECK(shown_text("abcdef", 3) == "abc...");
}
