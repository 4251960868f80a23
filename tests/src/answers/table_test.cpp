// Tables as text, JSON and CSV.
#include "answers/table.hpp"

#include <limits>

#include "catch.hpp"

using namespace answers;

TEST_CASE("a table of 80 columns is a table, one of 81 becomes blocks", "[exam]") {
  Table table{{"a", "b"}, {}};
  table.rows = {{text_cell("1"), text_cell(std::string(77, 'x'))},
                {text_cell("2"), text_cell("y")}};
  CHECK(written(table, Format::text).starts_with("a  b\n1  xxx"));
  table.rows[0][1] = text_cell(std::string(78, 'x'));
  CHECK(written(table, Format::text).starts_with("a  1\nb  xxx"));
  CHECK(written(table, Format::text).ends_with("x\n\na  2\nb  y\n"));
  table.rows[0][1] = text_cell("\u03b1\u2264");  // two characters, five bytes
  CHECK(written(table, Format::text) == "a  b\n1  \u03b1\u2264\n2  y\n");
}

TEST_CASE("a cell of a million numbers is wrapped", "[check]") {
  std::string numbers;
  for (int n = 0; n < 1'000'000; ++n) numbers += "0.125, ";
  const std::string text = written({{"a"}, {{text_cell(numbers)}}, false}, Format::text);
  CHECK(std::ranges::count(text, '\n') == 1'000'000 / 11 + 1);
}

TEST_CASE("cells", "[exam]") {
  CHECK(written({{"a"}, {{text_cell("\r")}}}, Format::csv) == "a\n\"\r\"\n");
  CHECK(real_cell(-0.0).text == "0");
  CHECK(real_cell(1e300).json == "1e+300");
  CHECK(real_cell(0.1 + 0.2).text == "0.30000000000000004");
  CHECK(real_cell(std::numeric_limits<double>::infinity()).json == "null");
  CHECK(real_cell(std::numeric_limits<double>::quiet_NaN()).text.empty());
  CHECK(whole_cell(std::numeric_limits<std::int64_t>::min()).json == "-9223372036854775808");
  CHECK(list_cell({"a", "b\n"}).json == "[\"a\", \"b\\u000a\"]");
  CHECK(list_cell({"a", "b"}).text == "a; b");
  CHECK(text_cell("\\\x1f").json == "\"\\\\\\u001f\"");
  CHECK(shown_text("a\x1b[\xffω₁∫½\u202e", 14) == "a\\x1b[\\xffω₁∫½...");
  CHECK(shown_text("abcdef", 5) == "abcde...");
  CHECK(shown_text("") == "(nothing)");
}
