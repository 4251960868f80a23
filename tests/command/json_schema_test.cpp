// SPDX-License-Identifier: GPL-2.0-or-later
// What every command writes as JSON is what src/command/schemas says.
#include "json_schema.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "program_run.hpp"

namespace {

using nlohmann::json;

const std::string schemas = MAGICMASS_SOURCE_DIR "/src/command/schemas/";
const std::string scenes = MAGICMASS_SOURCE_DIR "/tutorials/scenes/";

json schema_called(const std::string& name) {
  const std::string text = read_file(schemas + name + ".json");
  INFO(name);
  REQUIRE(!text.empty());
  return json::parse(text);
}

/// Command lines, by the schema of what they write.
std::multimap<std::string, std::vector<std::string>> command_lines() {
  std::multimap<std::string, std::vector<std::string>> lines{
      {"derive", {"derive", "contact"}},
      {"derive_list", {"derive", "--list"}},
      {"verify", {"verify"}},
      {"equal", {"equal", "sec(pi/5) - 1", "sqrt(5) - 2"}},
      {"equal", {"equal", "sqrt(x^2)", "x", "--domain", "x real"}},
      {"generate", {"generate", "--check"}},
      {"count", {"count", "--alpha", "0.5", "--near-tie"}},
      {"eval", {"eval", "--alpha", "0.1", "--n", "2"}},
      {"eval", {"eval", "--alpha", "1/7", "--n", "2", "--tier", "exact"}},
      {"eval", {"eval", "--alpha", "magic:3", "--n", "2", "--digits", "40"}},
      {"eval", {"eval", "--alpha", "magic:3", "--n", "2", "--tier", "accurate"}},
      {"count", {"count", "--alpha", "1e-200"}},
      {"count", {"count", "--input", "-"}},
      {"terminal", {"terminal", "--alpha", "0.12"}},
      {"terminal", {"terminal", "--alpha", "0.12", "--restitution", "0.9"}},
      {"terminal", {"terminal", "--alpha", "0.01", "--restitution", "0.5"}},
      {"ratios", {"ratios", "--count", "5"}},
      {"ratios", {"ratios", "--count", "2", "--digits", "30"}},
      {"doctor", {"doctor"}},
      {"report",
       {"report", "--quick", "--families", "alpha = 1", "--quantities", "counts", "--rounds", "6",
        "--no-growth"}},
      {"manual", {"manual"}},
  };
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
    if (entry.path().extension() != ".toml") continue;
    lines.insert({"simulate", {"simulate", entry.path().string()}});
    lines.insert({"plan", {"plan", entry.path().string()}});
  }
  return lines;
}

}  // namespace

TEST_CASE("the JSON of every command fits its schema", "[exam]") {
  std::set<std::string> used;
  for (const auto& [name, line] : command_lines()) {
    std::vector<std::string> words = line;
    words.insert(words.end(), {"--format", "json"});
    const ProgramRun run = run_program(words, "alpha\n0.1\nmagic:3\n1e-30\n");
    CAPTURE(words, run.errors);
    CHECK(run.exit_code <= 1);  // 1: different
    CHECK(complaints(schema_called(name), json::parse(run.output)) == std::vector<std::string>{});
    used.insert(name);
  }
  for (const auto& entry : std::filesystem::directory_iterator(schemas)) {
    INFO(entry.path());
    CHECK(used.contains(entry.path().stem().string()));
  }
}

TEST_CASE("a command that writes JSON has a schema", "[exam]") {
  for (const json& command : json_of({"manual"})["commands"])
    for (const json& option : command["options"])
      for (const json& choice : option["choices"])
        if (choice == "json")
          schema_called(
              command["name"].get<std::string>().substr(std::string("magicmass ").size()));
}

TEST_CASE("what does not fit a schema is found", "[exam]") {
  const json schema = schema_called("count");
  const json good{{"alpha", "1/7"}, {"N_A", 2}, {"N_B", 2}};
  CHECK(complaints(schema, good).empty());
  CHECK(complaints(schema, json::array({good, good})).empty());
  CHECK(complaints(schema, json::parse(R"({"alpha": 1, "N_A": 1e30, "N_B": 1e30})")).empty());
  const auto changed = [&](const char* name, const json& value) {
    json bad = good;
    bad[name] = value;
    return bad;
  };
  for (const json& bad : {changed("N_A", 2.5), changed("N_A", -1), changed("N_A", "2"),
                          changed("N_A", nullptr), changed("alpha", true), changed("more", 1),
                          json{{"alpha", 1}, {"N_A", 2}}, json(3), json::array({good, 3})}) {
    INFO(bad);
    CHECK(!complaints(schema, bad).empty());
  }
  CHECK(complaints(schema_called("plan"), json{{"model", "x"}, {"reason", "y"}}) ==
        std::vector<std::string>{": \"events\" is missing"});
  CHECK(complaints(json{{"items", {{"enum", {"a", "b"}}}}}, json{"a", "c"}) ==
        std::vector<std::string>{"/1: \"c\" is none of [\"a\",\"b\"]"});
  CHECK_THROWS_AS(complaints(json{{"maxLength", 3}}, json("word")), std::invalid_argument);
  CHECK_THROWS_AS(complaints(json{{"type", "text"}}, json("word")), std::invalid_argument);
}
