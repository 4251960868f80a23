// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "magicmass/evaluators.hpp"

using namespace magicmass;

namespace {

// By value: a range for over manifest().at(...) would outlive what it refers to.
nlohmann::json evaluators_in_manifest() {
  std::ifstream file(std::filesystem::path(MAGICMASS_GENERATED) / "manifest.json");
  return nlohmann::json::parse(file).at("evaluators");
}

}  // namespace

TEST_CASE("the manifest names every evaluator with its form, inputs, outputs and theorems",
          "[exam]") {
  for (const auto& entry : evaluators_in_manifest()) {
    INFO(entry.at("name"));
    for (const char* key : {"quantity", "form", "header", "precisions", "inputs", "outputs",
                            "bindings", "domain", "error", "operations"})
      CHECK(entry.contains(key));
    CHECK(std::filesystem::exists(std::filesystem::path(MAGICMASS_GENERATED) /
                                  entry.at("header").get<std::string>()));
    for (const auto& output : entry.at("outputs"))
      CHECK_FALSE(output.at("theorem").get<std::string>().empty());
  }
}

TEST_CASE("the tables hold what the manifest lists", "[exam]") {
  std::set<std::string> listed, in_tables;
  for (const auto& entry : evaluators_in_manifest())
    if (entry.at("precisions").size() == 3) listed.insert(entry.at("name"));
  for (const auto& evaluator : generated::angle_evaluators<double>())
    in_tables.insert(evaluator.name);
  for (const auto& evaluator : generated::encounter_evaluators<double>())
    in_tables.insert(evaluator.name);
  for (const auto& evaluator : generated::ratio_evaluators<double>())
    in_tables.insert(evaluator.name);
  for (const auto& evaluator : generated::velocity_evaluators<double>())
    in_tables.insert(evaluator.name);
  for (const auto& evaluator : generated::collapse_evaluators<double>())
    in_tables.insert(evaluator.name);
  for (const auto& evaluator : generated::terminal_evaluators<double>())
    in_tables.insert(evaluator.name);
  for (const auto& evaluator : generated::two_collisions_evaluators<double>())
    in_tables.insert(evaluator.name);
  CHECK(listed == in_tables);
}
