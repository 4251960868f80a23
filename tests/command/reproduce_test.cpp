// SPDX-License-Identifier: GPL-2.0-or-later
// The folder that reproduce writes: whole or not at all, and each number in it sharp enough to be found out if it were wrong.
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "command/reproduce/comparison.hpp"
#include "program_run.hpp"
#include "refusal.hpp"

namespace {

/// section, place, quantity, paper, ours, verdict, reason.
std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines_of(csv)) {
    std::vector<std::string> row(1);
    bool quoted = false;
    for (const char character : line) {
      if (character == '"')
        quoted = !quoted;
      else if (character == ',' && !quoted)
        row.emplace_back();
      else
        row.back() += character;
    }
    rows.push_back(row);
  }
  return rows;
}

/// Off by two in the last digit that the paper prints, or by 1e-12 where it prints a whole number.
std::string spoilt(const std::string& ours, const std::string& paper) {
  const std::size_t point = paper.find('.');
  const int digits = point == std::string::npos ? 12 : static_cast<int>(paper.size() - point - 1);
  std::ostringstream text;
  text.precision(17);
  text << std::stod(ours) + 2 * std::pow(10.0, -digits);
  return text.str();
}

/// Independent oracle: where rho has its k-th minimum under restitution, at the threshold of N_B in the wedge.
double minimum(int k, double e) {
  return (1 + e) / (2 * std::sqrt(e)) / std::cos(M_PI / (2 * (k + 1))) - 1;
}

bool can_draw() {
  const bool can = run_program({"figure", "setup", "-o", "/dev/null"}).exit_code == 0;
  if (!can) WARN("skipped: needs gnuplot");
  return can;
}

}  // namespace

TEST_CASE("reproduce writes every figure in every format, and pages that name what is there",
          "[exam]") {
  if (!can_draw()) return;
  const TemporaryFolder folder;
  const ProgramRun run = run_program({"reproduce", "--out", folder / "made/here"});
  CHECK(run.exit_code == 0);
  CHECK(run.errors.empty());
  CHECK(run.output.find(" 0 differ without one") != std::string::npos);
  std::set<std::string> expected = {"comparison.csv", "cradle.html", "index.html", "index.md"};
  for (const std::string& line : lines_of(run_program({"figure", "--list"}).output))
    for (const char* ending : {".svg", ".png", ".pdf", ".csv"})
      expected.insert(line.substr(0, line.find(' ')) + ending);
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "made/here"))
    found.insert(entry.path().filename().string());
  CHECK(found == expected);
  const std::string page = read_file(folder / "made/here/index.html");
  CHECK(page.find("http") == std::string::npos);
  for (const std::string& name : expected)
    if (!name.starts_with("index")) CHECK(page.find("\"" + name + "\"") != std::string::npos);

  SECTION("each number agrees or says why not, and would be found out if it were wrong") {
    std::size_t compared = 0;
    for (const auto& row : rows_of(read_file(folder / "made/here/comparison.csv"))) {
      REQUIRE(row.size() == 7);
      INFO(row[2]);
      CHECK((row[5] != "differs" || !row[6].empty()));
      if (row[3].empty() || row[3].find_first_not_of("0123456789.") != std::string::npos) continue;
      ++compared;
      CHECK(magicmass::command::verdict({row[1], row[2], row[3], row[4], ""}) == row[5]);
      CHECK(magicmass::command::verdict({row[1], row[2], row[3], spoilt(row[4], row[3]), ""}) ==
            "differs");
    }
    CHECK(compared > 80);
  }
  SECTION("both rows of the shifts under restitution, from an oracle of their own") {
    std::vector<std::vector<std::string>> shifts;
    for (const auto& row : rows_of(read_file(folder / "made/here/comparison.csv")))
      if (row[2].starts_with("shift of")) shifts.push_back(row);
    REQUIRE(shifts.size() == 8);
    const std::vector<std::string> printed = {"0", "0.43", "4.6", "0.84"};
    for (std::size_t i = 0; i < 8; ++i) CHECK(shifts[i][3] == printed[i % 4]);
    for (std::size_t i = 0; i < 4; ++i) CHECK(shifts[i][5] == "agrees");
    for (const int k : {1, 2}) {
      const double exact = 100 * (minimum(k, 0.9) / minimum(k, 1.0) - 1);
      CHECK(std::stod(shifts[k == 1 ? 5 : 7][4]) == Approx(exact).margin(1e-4));
      CHECK(shifts[k == 1 ? 5 : 7][5] == "differs");
    }
  }
}

TEST_CASE("reproduce where it cannot is one line, code 2, and nothing written", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "file", "");
  const auto refused = [&](const ProgramRun& run, const std::string& expected) {
    check_refused(run, expected);
    CHECK(folder.names() == std::vector<std::string>{"file"});
  };
  refused(
      run_program({"reproduce", "--out", folder / "none"}, "", {"/usr/bin/env", "PATH=/nowhere"}),
      "needs gnuplot (Debian: gnuplot-nox)");
  refused(run_program({"reproduce", "--out", ""}), "no folder name");
  refused(run_program({"reproduce", "more"}), "more");
  if (can_draw())
    refused(run_program({"reproduce", "--out", folder / "file/here"}), "cannot write");
}
