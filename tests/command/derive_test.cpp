// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "program_run.hpp"

TEST_CASE("derive writes every step with all its fields, proved from earlier ones", "[exam]") {
  const nlohmann::json steps = json_of({"derive"});
  REQUIRE(steps.is_array());
  CHECK(steps.size() > 100);
  const std::set<std::string> verdicts = {"proved", "law", "definition", "hypothesis"};
  std::set<std::string> seen;
  for (const nlohmann::json& step : steps) {
    INFO(step);
    for (const char* field : {"id", "rule", "from", "relation", "to", "label", "words", "verdict"})
      CHECK(step.at(field).is_string());
    CHECK(step.at("conditions").is_array());
    CHECK(verdicts.contains(step.at("verdict").get<std::string>()));
    for (const nlohmann::json& premise : step.at("premises"))
      CHECK(seen.contains(premise.get<std::string>()));
    CHECK(seen.insert(step.at("id").get<std::string>()).second);
  }
}

TEST_CASE("derive keeps to the chapters asked for", "[exam]") {
  const nlohmann::json steps = json_of({"derive", "power", "counting"});
  std::set<std::string> chapters;
  for (const nlohmann::json& step : steps) {
    const std::string id = step.at("id");
    chapters.insert(id.substr(0, id.find('.')));
  }
  CHECK(chapters == std::set<std::string>{"power", "counting"});
}

TEST_CASE("what is printed for reading fits 80 columns", "[exam]") {
  for (const auto& arguments : {std::vector<std::string>{"derive"}, {"derive", "--summary"}})
    for (const std::string& line : lines_of(run_program(arguments).output))
      CHECK(line.size() <= 80);
}

TEST_CASE("the same bytes from every derivation", "[check]") {
  const std::string first = run_program({"derive", "--format", "json"}).output;
  for (int i = 0; i < 3; ++i) CHECK(run_program({"derive", "--format", "json"}).output == first);
}

TEST_CASE("Markdown has a heading for each chapter and each step", "[exam]") {
  const std::string page = run_program({"derive", "--format", "markdown"}).output;
  CHECK(page.starts_with("# Derivation\n"));
  CHECK(page.find("\n## counting\n") != std::string::npos);
  CHECK(page.find("\n### `counting.N_A` (proved)\n") != std::string::npos);
}

TEST_CASE("verify proves every step", "[exam]") {
  const nlohmann::json counts = json_of({"verify"});
  const nlohmann::json steps = json_of({"derive"});
  CHECK(counts.at("failed") == 0);
  const auto count = [&](const char* verdict) {
    return std::count_if(steps.begin(), steps.end(),
                         [&](const auto& step) { return step.at("verdict") == verdict; });
  };
  CHECK(counts.at("proved") == count("proved"));
  CHECK(counts.at("laws") == count("law"));
  CHECK(counts.at("definitions") == count("definition"));
  CHECK(counts.at("hypotheses") == count("hypothesis"));
}
