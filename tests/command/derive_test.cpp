// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"

namespace {

/// What the program prints, which takes it two seconds, from one run for all cases.
const ProgramRun& derived(const std::vector<std::string>& arguments,
                          const std::string& locale = "LC_ALL=C") {
  static std::map<std::pair<std::vector<std::string>, std::string>, ProgramRun> runs;
  const auto [run, is_new] = runs.try_emplace({arguments, locale});
  if (is_new) run->second = run_program(arguments, "", {"env", locale});
  return run->second;
}

nlohmann::json derived_json(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--format", "json"});
  const ProgramRun& run = derived(arguments);
  REQUIRE(run.exit_code == 0);
  return nlohmann::json::parse(run.output);
}

}  // namespace

TEST_CASE("derive writes every step with all its fields, proved from earlier ones",
          "[exam][shared]") {
  const nlohmann::json steps = derived_json({"derive"});
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

TEST_CASE("derive keeps to the chapters asked for", "[exam][shared]") {
  const nlohmann::json steps = derived_json({"derive", "power", "counting"});
  std::set<std::string> chapters;
  for (const nlohmann::json& step : steps) {
    const std::string id = step.at("id");
    chapters.insert(id.substr(0, id.find('.')));
  }
  CHECK(chapters == std::set<std::string>{"power", "counting"});
}

TEST_CASE("a chapter that is asked for alone is as in the whole derivation", "[exam][shared]") {
  for (const std::string chapter : {"contact", "terminal", "transmission"}) {
    nlohmann::json expected = nlohmann::json::array();
    for (const nlohmann::json& step : derived_json({"derive"}))
      if (step.at("id").get<std::string>().starts_with(chapter + ".")) expected.push_back(step);
    CHECK(!expected.empty());
    CHECK(derived_json({"derive", chapter}) == expected);
  }
}

TEST_CASE("derive keeps to the steps asked for", "[exam][shared]") {
  const nlohmann::json steps = derived_json({"derive", "contact.relative", "power.a"});
  REQUIRE(steps.size() == 2);
  CHECK(steps[0].at("id") == "contact.relative");
  CHECK(steps[1].at("id") == "power.a");
  CHECK(steps[1].at("latex").get<std::string>().find("\\frac{\\cos(n \\psi)}") !=
        std::string::npos);
}

TEST_CASE("what is printed for reading fits 80 columns", "[exam][shared]") {
  const auto columns = [](const std::string& line) {
    return std::count_if(line.begin(), line.end(), [](char byte) {
      return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
    });
  };
  for (const auto& arguments : {std::vector<std::string>{"derive"},
                                {"derive", "--summary"},
                                {"derive", "--list"},
                                {"derive", "--from", "c'_n"}})
    for (const char* locale : {"LC_ALL=C", "LC_ALL=C.UTF-8"})
      for (const std::string& line : lines_of(derived(arguments, locale).output)) {
        INFO(line);
        CHECK(columns(line) <= 80);
      }
}

TEST_CASE("Unicode where the locale has it, plain characters elsewhere and with --ascii",
          "[exam][shared]") {
  const std::vector<std::string> step{"derive", "power.a"};
  CHECK(derived(step, "LC_ALL=C.UTF-8").output.find("V_CM ⎜1 + ") != std::string::npos);
  const std::string plain = derived(step, "LC_ALL=C").output;
  CHECK(std::all_of(plain.begin(), plain.end(),
                    [](char byte) { return static_cast<unsigned char>(byte) < 0x80; }));
  CHECK(derived({"derive", "power.a", "--ascii"}, "LC_ALL=C.UTF-8").output == plain);
}

TEST_CASE("derive --from shows what a result rests on, from the laws on, and nothing else",
          "[exam][shared]") {
  const nlohmann::json steps = derived_json({"derive", "--from", "a_n"});
  std::set<std::string> ids;
  for (const nlohmann::json& step : steps) {
    for (const nlohmann::json& premise : step.at("premises"))
      CHECK(ids.contains(premise.get<std::string>()));
    ids.insert(step.at("id").get<std::string>());
  }
  CHECK(steps.back().at("id") == "power.a");
  CHECK(ids.contains("contact.energy"));
  CHECK_FALSE(ids.contains("power.b"));
  const std::string tree = derived({"derive", "--from", "eq:a-final", "--ascii"}).output;
  CHECK(tree.starts_with("power.a\n"));
  CHECK(tree.find("contact.momentum (law), see above\n") != std::string::npos);
  for (const char* format : {"html", "latex", "markdown"})
    CHECK(
        derived({"derive", "--from", "a_n", "--format", format}).output.find("What it rests on") !=
        std::string::npos);
}

TEST_CASE("derive --list names every theorem and every equation of the paper", "[exam][shared]") {
  const nlohmann::json index = derived_json({"derive", "--list"});
  CHECK(index.at("theorems").size() == derived_json({"derive"}).size());
  for (const nlohmann::json& equation : index.at("equations"))
    CHECK((!equation.at("theorems").empty() || !equation.at("remark").get<std::string>().empty()));
  CHECK_FALSE(index.at("beyond").empty());
  const std::string text = derived({"derive", "--list"}).output;
  CHECK(text.find("\n  eq:a-final ") != std::string::npos);
  const auto rows = lines_of(derived({"derive", "--list", "--format", "csv"}).output);
  CHECK(rows.size() == index.at("equations").size() + 1);
}

TEST_CASE("what derive does not know it refuses in one line, with the nearest name",
          "[exam][shared]") {
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& message) {
    const ProgramRun run = run_program(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.output.empty());
    CHECK(run.errors == "magicmass: " + message + "\n");
  };
  refused({"derive", "powr"}, "no chapter or step is called \"powr\"; did you mean power?");
  refused({"derive", "power.aa"},
          "no chapter or step is called \"power.aa\"; did you mean power.a?");
  refused({"derive", "--from", "alpha_kk"},
          "no result is called \"alpha_kk\"; did you mean alpha_k?");
  refused({"derive", "--list", "--format", "latex"},
          "--list has no LaTeX; allowed with it: --format text, markdown, html, json, csv");
  refused({"derive", "--format", "csv"}, "--format csv is for --list alone");
  refused({"derive", "power", "--list"},
          "chapters or steps, --from, --list and --summary exclude each other");
}

TEST_CASE("the same bytes from every derivation", "[check][shared]") {
  const std::string first = derived({"derive", "--format", "json"}).output;
  for (int i = 0; i < 3; ++i) CHECK(run_program({"derive", "--format", "json"}).output == first);
}

TEST_CASE("the same pages from every run", "[check][shared]") {
  for (const char* format : {"text", "latex", "html", "markdown"}) {
    const std::string first = derived({"derive", "--format", format}).output;
    CHECK(run_program({"derive", "--format", format}, "", {"env", "LC_ALL=C"}).output == first);
  }
}

TEST_CASE("Markdown has a heading for each chapter and each step", "[exam][shared]") {
  const std::string page = derived({"derive", "--format", "markdown"}).output;
  CHECK(page.starts_with("# Derivation\n"));
  CHECK(page.find("\n## How many collisions\n") != std::string::npos);
  CHECK(page.find("\n### counting.N_A\n") != std::string::npos);
  CHECK(page.find("\n$$\nN_{A} = \\left\\lceil") != std::string::npos);
}

TEST_CASE("verify proves every step", "[exam][shared]") {
  const nlohmann::json counts = json_of({"verify"});
  const nlohmann::json steps = derived_json({"derive"});
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
