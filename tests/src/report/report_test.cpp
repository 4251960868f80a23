// SPDX-License-Identifier: GPL-2.0-or-later
// Times beside naive, and the report as an answer.
#include "report/report.hpp"

#include <fstream>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "catch.hpp"

using namespace report;

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

TEST_CASE("The worst of all families stands beside the time of everyday ones", "[check]") {
  const auto seen = [](const char* family, double ulp, double ratio) {
    return Measurement{"naive", Quantity::velocities, family, {.max_ulp = ulp}, {.ratio = ratio}};
  };
  const std::string both = document_of({seen("everyday", 1, 7), seen("tiny", 2, 9)}, true);
  CHECK(both.find("\n| naive | tiny | 2 | 0 | 0 | 7 |") != std::string::npos);
}
