// SPDX-License-Identifier: GPL-2.0-or-later
// What is emitted: what a header states, its constants, its cases.
#include <regex>
#include <sstream>

#include "catch.hpp"
#include "generate/quantities.hpp"

TEST_CASE("the constants in a header are the printed bounds, tier by tier") {
  static const std::regex table("struct (\\w+) \\{[^{}]*bounds[^{]*\\{([^;]*);"),
      tier("\\{[^}]*\\}");
  static const std::string tiers[] = {"Fast", "Accurate", "Slow", "Ziv"};
  static const std::regex constant("0x[0-9a-fp.+-]+"), power("2\\^\\S+");
  const auto all = [](const std::string& text, const std::regex& what) {
    return std::vector(std::sregex_iterator(text.begin(), text.end(), what), {});
  };
  std::size_t constants = 0;
  for (const codegen::Quantity& q : generate::evaluators()) {
    const codegen::Emitted e = codegen::emit_evaluator(q);
    for (const std::smatch& t : all(e.header, table)) {
      const std::string name = t[1], rows = t[2];
      const std::vector<std::smatch> lists = all(rows, tier);
      REQUIRE(lists.size() == 4);
      for (std::size_t k = 0; k < 4; ++k) {
        std::multiset<std::string> in_code, in_text;
        const std::string list = lists[k][0];
        const double unit = tiers[k] == "Ziv" ? 0x1p-180 : 1;  // the text is of numbers of 180 bits
        for (const std::smatch& c : all(list, constant))
          if (std::stod(c[0]) > 0)  // other types have an error there
            in_code.insert(codegen::as_power_of_2(std::stod(c[0]) * unit));
        const std::size_t from = e.errors.find(name + ", " + tiers[k] + "\n");
        std::istringstream lines(e.errors.substr(from, e.errors.find("\n\n", from) - from));
        for (std::string line; std::getline(lines, line);) {
          const bool is_tested = q.is_tested && line.starts_with("  OUTPUT ");
          if (!is_tested && !line.starts_with("  SIGN ")) continue;
          for (const std::smatch& p : all(line, power)) in_text.insert(p[0]);
        }
        INFO(name << ", " << tiers[k]);
        CHECK(in_code == in_text);
        constants += in_code.size();
      }
    }
  }
  CHECK(constants > 100);
}
TEST_CASE("two files of one name are refused") {
  const codegen::PlainForm& one = generate::inventory().all.at(1);
  CHECK_THROWS_WITH(generate::texts({one, one}), ContainsSubstring("two files are called"));
}
