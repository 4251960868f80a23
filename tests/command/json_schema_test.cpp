// SPDX-License-Identifier: GPL-2.0-or-later
// What every command writes as JSON, the manifest of generated/ too, is what src/command/schemas says.
#include "json_schema.hpp"

#include <algorithm>
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

/// Command lines, by the schema of what they write. The folder is a class of one student, who has answered once.
std::multimap<std::string, std::vector<std::string>> command_lines(const TemporaryFolder& folder) {
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
      {"learn_check", {"learn", "check", "half_angle", "1/(1+alpha)", "--folder", folder / "anna"}},
      {"learn_check", {"learn", "check", "half_angle", "alpha", "--folder", folder / "bert"}},
      {"learn_grade", {"learn", "grade", folder.path().string()}},
      {"learn_list", {"learn", "list", "--folder", folder / "anna"}},
      {"learn_test", {"learn", "test", "half_angle"}},
  };
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
    if (entry.path().extension() != ".toml") continue;
    lines.insert({"simulate", {"simulate", entry.path().string()}});
    lines.insert({"simulate_lines", {"simulate", entry.path().string()}});
    lines.insert({"plan", {"plan", entry.path().string()}});
  }
  return lines;
}

/// What a run with that schema wrote: one value, or one a line.
std::vector<json> values_of(const std::string& schema, const std::string& output) {
  if (!schema.ends_with("_lines")) return {json::parse(output)};
  std::vector<json> values;
  for (const std::string& line : lines_of(output)) values.push_back(json::parse(line));
  return values;
}

/// The schemas that the command tree calls for: of each command with the format json, and of one with jsonl.
void collect_schemas(const json& command, std::set<std::string>& names) {
  std::string name = command["name"];
  name.erase(0, std::string("magicmass ").size());
  std::replace(name.begin(), name.end(), ' ', '_');
  for (const json& option : command["options"])
    for (const json& choice : option["choices"]) {
      if (choice == "json") names.insert(name);
      if (choice == "jsonl") names.insert(name + "_lines");
    }
  for (const json& below : command["commands"]) collect_schemas(below, names);
}

}  // namespace

TEST_CASE("the JSON of every command of the tree fits a schema, and each schema is used",
          "[exam]") {
  const TemporaryFolder folder;
  std::set<std::string> used;
  for (const auto& [name, line] : command_lines(folder)) {
    std::vector<std::string> words = line;
    words.insert(words.end(), {"--format", name.ends_with("_lines") ? "jsonl" : "json"});
    const ProgramRun run = run_program(words, "alpha\n0.1\nmagic:3\n1e-30\n");
    CAPTURE(words, run.errors);
    CHECK(run.exit_code <= 1);  // 1: different, or wrong
    const std::vector<json> values = values_of(name, run.output);
    CHECK(!values.empty());
    for (const json& value : values)
      CHECK(complaints(schema_called(name), value) == std::vector<std::string>{});
    used.insert(name);
  }
  const json manifest = json::parse(read_file(MAGICMASS_SOURCE_DIR "/generated/manifest.json"));
  CHECK(complaints(schema_called("manifest"), manifest) == std::vector<std::string>{});
  used.insert("manifest");
  std::set<std::string> called_for{"derive_list", "manifest"};  // what no --format asks for
  collect_schemas(json_of({"manual"}), called_for);
  CHECK(used == called_for);
  std::set<std::string> kept;
  for (const auto& entry : std::filesystem::directory_iterator(schemas))
    kept.insert(entry.path().stem().string());
  CHECK(kept == called_for);
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
