// SPDX-License-Identifier: GPL-2.0-or-later
// Times beside naive, and the report as an answer.
#include "report/report.hpp"

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "catch.hpp"

namespace {

using namespace report;

const std::vector<Measurement>& measured() {
  static const std::vector<Measurement> all = [] {
    Plan plan = quick_plan();
    plan.draws = 10;
    plan.rounds.shortest_ns = 1e3;
    plan.only = "everyday";
    return measure(plan);
  }();
  return all;
}

}  // namespace

TEST_CASE("Every pair is called in every round, naive as often as ours", "[check]") {
  std::map<std::string, int> calls;
  const auto work = [&](const std::string& name) { return [&calls, name] { ++calls[name]; }; };
  const std::vector<Pair> pairs{{work("a"), work("b"), 1}, {work("c"), work("d"), 1}};
  const std::vector<Times> times = timed(pairs, {.count = 9, .shortest_ns = 0});
  CHECK(calls == std::map<std::string, int>{{"a", 19}, {"b", 19}, {"c", 19}, {"d", 19}});
  REQUIRE(times.size() == 2);
  for (const Times& one : times) CHECK((one.ratio_low <= one.ratio && one.ratio <= one.ratio_high));
}

TEST_CASE("Each form that the manifest has of a quantity is measured", "[exam]") {
  const std::map<std::string, std::string> ours{{"collision", "collisions"},
                                                {"magic", "ratios"},
                                                {"deficient", "ratios"},
                                                {"evaluator", "accurate"},
                                                {"exact", "exact rational"}};
  const auto word = [&](const std::string& of) { return ours.contains(of) ? ours.at(of) : of; };
  std::map<std::string, std::set<std::string>> forms;
  for (const Implementation& one : implementations()) forms[name_of(one.quantity)].insert(one.name);
  for (const auto& entry : nlohmann::json::parse(std::ifstream(MANIFEST))) {
    const auto of = forms.find(word(entry.at("name")));
    INFO(entry.at("name") << ", " << entry.at("form"));
    CHECK((of == forms.end() || of->second.contains(word(entry.at("form")))));
  }
}

TEST_CASE("The text fits 80 columns, and Markdown has its tables", "[check]") {
  std::istringstream text(document_of(measured(), false));
  int lines = 0;
  for (std::string line; std::getline(text, line); ++lines) CHECK(line.size() <= 80);
  CHECK(lines > 50);
  const std::string markdown = document_of(measured(), true);
  CHECK(markdown.find("\n| evaluator | family | max_ulp |") != std::string::npos);
  const auto seen = [](const char* family, double ulp, double ratio) {
    return Measurement{"naive", Quantity::velocities, family, {.max_ulp = ulp}, {.ratio = ratio}};
  };
  const std::string both = document_of({seen("everyday", 1, 7), seen("tiny", 2, 9)}, true);
  CHECK(both.find("\n| naive | tiny | 2 | 0 | 0 | 7 |") != std::string::npos);
  CHECK(markdown.find("\n## velocities, everyday: alpha from 1e-6 to 10\n") != std::string::npos);
}

TEST_CASE("The figure of errors: accurate below half an ulp, and every threshold", "[check]") {
  REQUIRE(figures().size() == 2);
  const answers::Table table = figures()[1].data();
  REQUIRE(table.columns.back() == "accurate");
  int thresholds = 0;
  for (const answers::Row& row : table.rows) {
    thresholds += row[1].text.empty() ? 0 : 1;
    CHECK(std::stod(row.back().text) <= 0.5);
  }
  CHECK(thresholds == 10);
}
