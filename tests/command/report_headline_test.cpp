// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"

TEST_CASE("the headline goes between a file's marks and nowhere else", "[exam]") {
  const TemporaryFolder folder;
  const std::string begin = "before\n<!-- written by `magicmass report --headline`: -->\n";
  const std::string end = "<!-- end -->\nafter\n";
  write_file(folder / "page.md", begin + "old\n" + end);
  const ProgramRun run =
      run_program({"report", "--quick", "--size", "2", "--rounds", "6", "--no-growth",
                   "--quantities", "angle,ratios", "--headline", folder / "page.md"});
  CHECK(run.exit_code == 0);
  const std::string page = read_file(folder / "page.md");
  CHECK(page.starts_with(begin + "| quantity | evaluator |"));
  CHECK(page.ends_with(end));
  CHECK(page.find("old\n") == std::string::npos);
  // the same names on every machine, whatever instruction sets it has
  for (const char* row :
       {"| angle | naive |", "| angle | fast |", "| angle | accurate |", "| ratios | batch_fast |"})
    CHECK(page.find(row) != std::string::npos);
  for (const char* set : {"_avx2", "_baseline", "_avx512"})
    CHECK(page.find(set) == std::string::npos);
}

TEST_CASE("the README's table has the error figures of a run", "[exam]") {
  const std::string mark = "<!-- written by `magicmass report --headline`: -->\n";
  const std::string readme = read_file(std::filesystem::path(MAGICMASS_SOURCE_DIR) / "README.md");
  const TemporaryFolder folder;
  write_file(folder / "page.md", mark + "<!-- end -->\n");
  const ProgramRun run =
      run_program({"report", "--quick", "--rounds", "6", "--no-growth", "--quantities",
                   "velocities,counts", "--headline", folder / "page.md"});
  REQUIRE(run.exit_code == 0);
  // | quantity | evaluator | worst on | ulp | ns | envelope | wrong | ulp | ns | ratio |: what is no time.
  const auto errors = [&](const std::string& text) {
    const std::size_t begin = text.find(mark);
    REQUIRE(begin != std::string::npos);
    std::vector<std::string> rows;
    const std::size_t first = begin + mark.size();
    const std::size_t end = text.find("<!-- end -->", first);
    for (const std::string& line : lines_of(text.substr(first, end - first))) {
      if (!line.starts_with("| ")) continue;
      std::vector<std::string> cells;
      std::size_t from = 0;
      for (std::size_t at = line.find(" | "); at != std::string::npos;
           at = line.find(" | ", from)) {
        cells.push_back(line.substr(from, at - from));
        from = at + 3;
      }
      REQUIRE(cells.size() == 9);
      rows.push_back(cells[0] + cells[1] + " " + cells[2] + " " + cells[3] + " " + cells[5] + " " +
                     cells[6] + " " + cells[7]);
    }
    return rows;
  };
  const std::vector<std::string> printed = errors(readme);
  CHECK(printed.size() > 10);
  CHECK(printed == errors(read_file(folder / "page.md")));
}
