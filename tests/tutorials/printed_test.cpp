// SPDX-License-Identifier: GPL-2.0-or-later
#include "course/printed.hpp"

#include <catch2/catch.hpp>

#include "course/refusal.hpp"

using magicmass::course::cells;
using magicmass::course::read_printed;
using magicmass::course::Refusal;

TEST_CASE("names, values and blocks are read", "[exam]") {
  const auto printed =
      read_printed("# for the terminal\nalpha: 1/7\nrows:\n  n | a(n)\n  1 | 3/4\n", "p");
  REQUIRE(printed.size() == 2);
  CHECK(printed[0].name == "alpha");
  CHECK(printed[0].value == "1/7");
  CHECK_FALSE(printed[0].is_block);
  CHECK(printed[1].is_block);
  CHECK(printed[1].lines == std::vector<std::string>{"n | a(n)", "1 | 3/4"});
  CHECK(cells("  1 | 3/4 | x") == std::vector<std::string>{"1", "3/4", "x"});
  CHECK(cells("alone") == std::vector<std::string>{"alone"});
}

TEST_CASE("a line without a name and a name printed twice are refused", "[exam]") {
  CHECK_THROWS_AS(read_printed("just words\n", "p"), Refusal);
  CHECK_THROWS_AS(read_printed("two words: 1\n", "p"), Refusal);
  CHECK_THROWS_AS(read_printed("  indented\n", "p"), Refusal);
  CHECK_THROWS_AS(read_printed("a: 1\na: 2\n", "p"), Refusal);
}
