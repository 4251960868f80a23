// SPDX-License-Identifier: GPL-2.0-or-later
#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"
#include "refusal.hpp"

namespace {

const std::vector<std::string> small_report = {"report",      "--quick",      "--size",
                                               "2",           "--rounds",     "6",
                                               "--no-growth", "--quantities", "angle,ratios"};

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A report that was measured once for all tests of this file.
const nlohmann::json& measured() {
  static const nlohmann::json all = json_of(small_report);
  return all;
}

/// The same, with intervals that hold each ratio within so many percent.
nlohmann::json steady(double percent) {
  nlohmann::json all = measured();
  for (auto& one : all) {
    if (!one["ratio"].is_number()) continue;
    one["ratio_low"] = one["ratio"].get<double>() * (1 - percent / 100);
    one["ratio_high"] = one["ratio"].get<double>() * (1 + percent / 100);
  }
  return all;
}

/// Compares the report with one that was changed.
ProgramRun compared(const nlohmann::json& one, const nlohmann::json& other) {
  const TemporaryFolder folder;
  write_file(folder / "old.json", one.dump());
  write_file(folder / "new.json", other.dump());
  return run_program({"report", "--compare", folder / "old.json", folder / "new.json"});
}

/// Multiplies the ratio of the first so many evaluators on their families.
nlohmann::json with_ratios_moved(nlohmann::json all, int count, double factor) {
  std::string last;
  for (auto& one : all) {
    if (!one["ratio"].is_number()) continue;
    const std::string name = one["evaluator"].dump() + one["precision"].dump() +
                             one["quantity"].dump() + one["family"].dump();
    if (name != last && count-- == 0) break;
    last = name;
    for (const char* key : {"ratio", "ratio_low", "ratio_high"})
      one[key] = one[key].get<double>() * factor;
  }
  return all;
}

}  // namespace

TEST_CASE("a report agrees with itself", "[exam][shared]") {
  const ProgramRun run = compared(measured(), measured());
  CHECK(run.exit_code == 0);
  CHECK(run.output.find("all the same") != std::string::npos);
  CHECK(run.output.find("they agree") != std::string::npos);
  CHECK(run.errors.empty());
}

TEST_CASE("this run agrees with an old one on every error figure", "[exam][shared]") {
  const TemporaryFolder folder;
  nlohmann::json old = measured();
  for (auto& one : old) one["machine"] = "another";  // so that noise decides nothing
  write_file(folder / "old.json", old.dump());
  const ProgramRun run =
      run_program(with(small_report, {"--compare", folder / "old.json", "-o", folder / "new.txt"}));
  CHECK(run.exit_code == 0);
  CHECK(run.output.find("all the same") != std::string::npos);
  CHECK(run.output.find("ratios: not compared, another machine") != std::string::npos);
  CHECK(read_file(folder / "new.txt").starts_with("Speed against error"));
}

TEST_CASE("any error figure that differs is found", "[exam][shared]") {
  for (const char* column : {"max_ulp", "worst_index", "ulp_median", "wrong_signs", "max_eps"}) {
    nlohmann::json other = measured();
    for (auto& one : other)
      if (one["evaluator"] == "angle_product" && one["precision"] == "float" &&
          one["family"] == "everyday")
        one[column] = 4711;
    const ProgramRun run = compared(measured(), other);
    INFO(column);
    CHECK(run.exit_code == 1);
    CHECK(run.output.find("1 figures differ") != std::string::npos);
    CHECK(run.output.find("angle_product, float, angle, everyday, psi: " + std::string(column)) !=
          std::string::npos);
    CHECK(lines_of(run.errors).size() == 1);
  }
}

TEST_CASE("what is not reproducible may differ", "[exam][shared]") {
  nlohmann::json other = measured();
  for (auto& one : other)
    if (one["reproducible"] == false) one["max_ulp"] = 4711;
  CHECK(compared(measured(), other).exit_code == 0);
}

TEST_CASE("ratios may miss their intervals by chance, but neither often nor by far",
          "[exam][shared]") {
  const nlohmann::json all = steady(1);
  const ProgramRun by_chance = compared(all, with_ratios_moved(all, 2, 1.05));
  CHECK(by_chance.exit_code == 0);
  CHECK(by_chance.output.find("ratio was ") != std::string::npos);
  CHECK(compared(all, with_ratios_moved(all, 100, 1.05)).exit_code == 1);
  CHECK(compared(all, with_ratios_moved(all, 100, 1.01)).exit_code == 0);
  CHECK(compared(all, with_ratios_moved(all, 2, 1.2)).exit_code == 1);
  CHECK(compared(all, with_ratios_moved(all, 2, 0.8)).exit_code == 1);
}

TEST_CASE("what is in one report alone is counted", "[exam][shared]") {
  nlohmann::json fewer = measured();
  fewer.erase(fewer.begin());
  const ProgramRun run = compared(fewer, measured());
  CHECK(run.exit_code == 0);
  CHECK(run.output.find("0 in ") != std::string::npos);
  CHECK(run.output.find(", 1 in ") != std::string::npos);
}

TEST_CASE("files that are no reports cost one clear line and exit 2, before any measuring",
          "[exam][shared]") {
  const TemporaryFolder folder;
  write_file(folder / "text", "Speed against error\n");
  write_file(folder / "empty.json", "[]");
  write_file(folder / "other.json", R"([{"evaluator": "none", "family": "of these"}])");
  write_file(folder / "old.json", measured().dump());
  write_file(folder / "deep.json", R"([{"evaluator": "e", "family": "f", "x": )" +
                                       std::string(100000, '[') + std::string(100000, ']') + "}]");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{folder / "missing"}, "cannot be read"},
      {{folder / "text"}, "is no report"},
      {{folder.path().string()}, "cannot be read"},
      {{folder / "old.json", folder / "deep.json"}, "have no row in common"},
      {{folder / "empty.json"}, "is no report"},
      {{folder / "old.json", folder / "text"}, "is no report"},
      {{folder / "old.json", folder / "other.json"}, "have no row in common"},
  };
  for (const auto& [files, message] : cases) {
    const ProgramRun run = run_program(with({"report", "--compare"}, files));
    check_refused(run, message);
  }
}

// At these inputs some members are 0, which floats show by luck alone.
TEST_CASE("errors against a quantity's own theorem are the same in each run", "[exam]") {
  const TemporaryFolder folder;
  const std::vector<std::string> words = {
      "report",      "--quick",   "--size",       "2",        "--rounds",     "6",
      "--families",  "alpha = 1", "--quantities", "terminal", "--evaluators", "terminal_after_P",
      "--no-growth", "--format",  "json"};
  for (const char* file : {"one.json", "other.json"})
    REQUIRE(run_program(with(words, {"-o", folder / file})).exit_code == 0);
  const ProgramRun run =
      run_program({"report", "--compare", folder / "one.json", folder / "other.json"});
  INFO(run.output);
  CHECK(run.exit_code == 0);
}

// Not gated on: it takes two minutes, and a loaded machine disturbs.
TEST_CASE("two runs agree", "[time]") {
  const TemporaryFolder folder;
  const std::vector<std::string> quick = {"report", "--quick"};
  REQUIRE(run_program(with(quick, {"--format", "json", "-o", folder / "old.json"})).exit_code == 0);
  const ProgramRun run = run_program(with(quick, {"--compare", folder / "old.json"}));
  WARN(run.output);
  CHECK(run.exit_code == 0);
}

TEST_CASE("what a report's rows are called is shown without its control characters", "[exam]") {
  nlohmann::json one = steady(1);
  for (auto& row : one) row["evaluator"] = "\x1b[2Jnaive\n";
  nlohmann::json other = one;
  for (auto& row : other)
    if (row["max_ulp"].is_number()) row["max_ulp"] = row["max_ulp"].get<double>() + 1;
  const ProgramRun run = compared(one, other);
  CHECK(run.exit_code == 1);
  CHECK(run.output.find("naive") != std::string::npos);
  CHECK(run.output.find('\x1b') == std::string::npos);
}
