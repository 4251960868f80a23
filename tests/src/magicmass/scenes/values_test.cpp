// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers as scenes write them.
#include <cmath>

#include "catch.hpp"
#include "magicmass/scenes/value.hpp"
#include "rows.hpp"

using namespace magicmass::scenes;

TEST_CASE("values are kept as what they are, what is none is refused", "[exam]") {
  const auto rows = rows_of("src/magicmass/scenes/values.tsv", 3);
  REQUIRE(rows.size() == 42);
  for (const auto& row : rows) {
    INFO(row[0]);
    if (row[2].empty()) {
      CHECK_THROWS_WITH(read_value(row[0]), ContainsSubstring(row[1]));
      continue;
    }
    const Value value = read_value(row[0]);
    CHECK(value.text == row[0]);
    REQUIRE(value.exact() != nullptr);
    CHECK(value.exact()->text() == row[1]);
    CHECK(value.to_double() == std::stod(row[2]));
  }
  CHECK(read_value("magic:3").exact() == nullptr);
  const std::string says = " does not fit a double; --exact may do";
  for (const std::string text : {"10^400", "1/10^400"})
    CHECK_THROWS_WITH(read_value(text).to_double(), text + says);
  CHECK_NOTHROW(read_value("1/7 "));
  CHECK_NOTHROW(read_value("magic:1125899906842624"));
  CHECK_THROWS_WITH(read_value(std::string(5000, '1')), "5000 characters, at most 4096");
  CHECK_THROWS_WITH(value_of(INFINITY), "not a finite number");
}
