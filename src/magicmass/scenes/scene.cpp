// SPDX-License-Identifier: MIT
#include "magicmass/scenes/scene.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/nearest_key.hpp"
#include "magicmass/scenes/scene_keys.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass {
namespace {

constexpr std::array<std::pair<std::string_view, Output>, 5> output_names = {{
    {"counts", Output::counts},
    {"terminal", Output::terminal},
    {"events", Output::events},
    {"trajectory", Output::trajectory},
    {"energy", Output::energy},
}};

toml::table parse_table(std::string_view text, std::string_view source_name) {
  if (has_endless_key(text))
    throw InvalidInput(std::string(source_name) +
                       ": a key of more than 1000 parts; allowed: lines like alpha = 0.1");
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw InvalidInput(std::string(source_name) + ":" + std::to_string(error.source().begin.line) +
                       ": not valid TOML: " + shown_text(error.description(), 200) +
                       "; allowed: lines like alpha = 0.1");
  }
}

bool has_key(const SceneKey& key, Kind kind) {
  return key.kinds.empty() ||
         std::find(key.kinds.begin(), key.kinds.end(), kind) != key.kinds.end();
}

std::vector<std::string_view> keys_of(Kind kind) {
  std::vector<std::string_view> keys;
  for (const SceneKey& key : scene_keys())
    if (has_key(key, kind)) keys.push_back(key.name);
  return keys;
}

[[noreturn]] void refuse_unknown_key(const Scene& scene, std::string_view key) {
  const std::vector<std::string_view> keys = keys_of(scene.kind);
  const std::optional<std::string_view> nearest = nearest_key(key, keys);
  std::string names;
  for (const std::string_view name : keys) names += (names.empty() ? "" : ", ") + std::string(name);
  refuse_key(scene, key,
             nearest ? "unknown key, did you mean " + std::string(*nearest) + "?" : "unknown key",
             names);
}

/// What is wrong with the keys that are there, together.
void check_together(const Scene& scene) {
  const auto has = [&](std::string_view key) { return scene.lines.find(key) != scene.lines.end(); };
  const auto exclude = [&](std::string_view key, std::initializer_list<std::string_view> others) {
    for (const std::string_view other : others)
      if (has(key) && has(other))
        refuse_key(scene, key, "does not go with " + std::string(other), "one of the two");
  };
  exclude("masses", {"alpha", "mass_ratio", "blocks", "balls"});
  exclude("positions", {"L", "gap", "walls"});
  exclude("velocities", {"V"});
  exclude("walls", {"left_wall", "right_wall"});
  exclude("times", {"every"});
  const SceneKind& kind = row_of(scene.kind);
  if (scene.masses.empty()) refuse_key(scene, kind.mass_key, "missing", kind.mass_lines);
  if (has("balls") && !has("blocks"))
    refuse_key(scene, "blocks", "missing", "a whole number of blocks");
  if (has("blocks") && !has("balls") && scene.masses.size() > 1)
    refuse_key(scene, "balls", "missing", "one value for all balls, or an array with one for each");
  if (scene.masses.size() > most_bodies)
    refuse_key(scene, "masses", "got " + std::to_string(scene.masses.size()) + " bodies",
               "up to " + std::to_string(most_bodies));
  const std::string as_many = "as many as there are bodies: " + std::to_string(scene.masses.size());
  if (has("positions") && scene.positions.size() != scene.masses.size())
    refuse_key(scene, "positions", "got " + std::to_string(scene.positions.size()), as_many);
  if (has("velocities") && scene.velocities.size() != scene.masses.size())
    refuse_key(scene, "velocities", "got " + std::to_string(scene.velocities.size()), as_many);
  if (scene.kind == Kind::wall && has("positions") && !has("wall"))
    refuse_key(scene, "wall", "missing", "where the wall is, as positions are given");
  const bool moves = wants(scene, Output::trajectory), lists = wants(scene, Output::events);
  if (has("times") && !moves)
    refuse_key(scene, "times", "positions at given times are a trajectory, which is not asked for",
               "times together with the output \"trajectory\"");
  if (has("times") && lists)
    refuse_key(scene, "times", "events are not at given times",
               "times without the output \"events\"");
  if (has("every") && !moves && !lists)
    refuse_key(scene, "every", "there is nothing to leave out",
               "every together with the output \"events\" or \"trajectory\"");
}

/// The paper's state, which has formulas of its own: equal blocks, a ratio that is one by its form, doubles else.
std::optional<MassRatio> ratio_of_equal_blocks(const Scene& scene) {
  const bool laid_out =
      scene.lines.contains("alpha") && scene.positions.empty() && scene.velocities.empty();
  if (!laid_out) return std::nullopt;
  const Value& alpha = scene.masses[1];
  if (const auto* expression = std::get_if<Expression>(&alpha)) {
    if (expression->text.find_first_not_of("0123456789/") != std::string::npos) return std::nullopt;
    return parse_mass_ratio(expression->text);
  }
  if (const auto* magic = std::get_if<Magic>(&alpha)) return *magic;
  if (const auto* deficient = std::get_if<Deficient>(&alpha)) return *deficient;
  return std::get<double>(alpha);
}

}  // namespace

bool wants(const Scene& scene, Output output) {
  return std::find(scene.outputs.begin(), scene.outputs.end(), output) != scene.outputs.end();
}

std::string_view to_text(Output output) {
  return std::find_if(output_names.begin(), output_names.end(),
                      [&](const auto& entry) { return entry.second == output; })
      ->first;
}

std::string_view to_text(Kind kind) { return row_of(kind).name; }

std::string body_name(const Scene& scene, std::size_t body) {
  if (scene.kind != Kind::chain) return body == 0 ? "A" : body == 1 ? "C" : "B";
  const std::string number = std::to_string(body / 2 + 1);
  if (!scene.lines.contains("blocks")) return std::to_string(body + 1);
  return (body % 2 == 0 ? "A_" : "C_") + number;
}

void refuse_key(const Scene& scene, std::string_view key, const std::string& what,
                std::string_view allowed) {
  const auto line = scene.lines.find(key);
  Place{scene.source, key, line == scene.lines.end() ? 1 : line->second}.refuse(what, allowed);
}

Scene parse_scene(std::string_view text, std::string_view source_name) {
  const toml::table table = parse_table(text, source_name);
  Scene scene;
  scene.source = source_name;
  const auto read = [&](const SceneKey& key) {
    const toml::node* node = table.get(key.name);
    if (node == nullptr) return;
    key.read(*node, {source_name, key.name, scene.lines.find(key.name)->second}, scene);
  };
  for (const auto& [key, node] : table)
    scene.lines[std::string(key.str())] = static_cast<unsigned>(key.source().begin.line);
  for (const SceneKey& key : scene_keys())
    if (key.name == "kind") read(key);
  for (const auto& entry : table) {
    const std::string_view name = entry.first.str();
    const bool known = std::any_of(
        scene_keys().begin(), scene_keys().end(),
        [&](const SceneKey& key) { return key.name == name && has_key(key, scene.kind); });
    if (!known) refuse_unknown_key(scene, name);
  }
  if (scene.kind == Kind::chain) scene.gap = 1.0;
  if (scene.kind == Kind::wall) scene.has_right_wall = true;
  for (const SceneKey& key : scene_keys())
    if (key.name != "kind") read(key);
  check_together(scene);
  scene.alpha = ratio_of_equal_blocks(scene);
  return scene;
}

Scene read_scene(const std::string& path) {
  constexpr std::size_t longest = std::size_t{1} << 20U;
  std::ifstream file(path, std::ios::binary);
  std::string text(longest + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad() || !file.is_open() || (file.fail() && !file.eof())) {
    throw InvalidInput(path + ": cannot be read; allowed: a scene file in TOML");
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > longest) {
    throw InvalidInput(path + ": longer than " + std::to_string(longest) +
                       " bytes; allowed: a scene file in TOML");
  }
  return parse_scene(text, path);
}

}  // namespace magicmass
