// SPDX-License-Identifier: GPL-2.0-or-later
// A reader's own evaluator in the report.
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"

namespace {

ProgramRun tiny_report(std::vector<std::string> more) {
  more.insert(more.begin(), {"report", "--quick", "--size", "2", "--rounds", "6", "--no-growth"});
  return run_program(more);
}

}  // namespace

TEST_CASE("a reader's own function takes its places in the report", "[exam]") {
  std::vector<std::string> asked{
      "--quantities",
      "velocities",
      "--families",
      "everyday",
      "--evaluators",
      "fast",
      "--function",
      MAGICMASS_SOURCE_DIR "/tutorials/13_speed_and_error/exercises/beat_us/solution/answer.cpp"};
  const ProgramRun run = tiny_report(asked);
  INFO(run.errors);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.output, Catch::Contains("yours: everyday: place ") &&
                             Catch::Contains(" of 3 by error, ") && Catch::Contains("\nyours "));
  asked.insert(asked.end(), {"--format", "json"});
  std::set<std::string> evaluators;
  for (const auto& row : nlohmann::json::parse(tiny_report(asked).output))
    if (row["target"].is_null()) evaluators.insert(row["evaluator"].get<std::string>());
  CHECK(evaluators == std::set<std::string>{"fast", "naive", "yours"});
}

TEST_CASE("a function that is none is refused in one line", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "bad.cpp", "double velocities(double, long) { return 1; }\n");
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{
           {"--function", folder / "bad.cpp"},
           {"--function", "/nowhere.cpp"},
           {"--function", folder / "bad.cpp", "--quantities", "counts"}}) {
    const ProgramRun run = tiny_report(bad);
    CHECK(run.exit_code == 2);
    CHECK(run.output.empty());
    CHECK(lines_of(run.errors).size() == 1);
  }
}
