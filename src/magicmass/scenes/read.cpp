// SPDX-License-Identifier: GPL-2.0-or-later
// From a file to a scene.
#include <cerrno>
#include <fstream>
#include <system_error>

#include "magicmass/numbers/errors.hpp"
#include "magicmass/scenes/keys.hpp"

namespace magicmass::scenes {
namespace {

std::string shown_source(const std::string& path) { return path == "-" ? "stdin" : path; }

const std::string allowed_scene = "a scene in TOML, lines like alpha = 0.12 or alpha = \"1/7\"";
constexpr std::size_t longest_scene = std::size_t{1} << 23U;  // 10^5 bodies with all their digits

/// A key of many parts, or values nested deep: the parser's recursion would not end well.
bool is_too_deep(std::string_view text) {
  int parts = 0;
  int depth = 0;
  for (const char c : text) {
    if (c == '\n' || c == '=' || c == ',') parts = 0;
    if (c == '.') ++parts;
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (parts > 100 || depth > 100) return true;
  }
  return false;
}

void check_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Key& key : keys())
    if (key.kinds.empty() || std::ranges::count(key.kinds, scene.kind) != 0)
      names.push_back(key.name);
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  for (const auto& [name, line] : scene.lines) {
    if (std::ranges::count(names, name) != 0) continue;
    const std::string nearest = nearest_name(name, names);
    const std::string meant = nearest.empty() ? "" : "; is " + nearest + " meant?";
    refuse_key(scene, name.substr(0, 40), "no such key in this kind of scene" + meant, all);
  }
}

/// What is there together, and how many.
void check_together(const Scene& scene) {
  const auto exclude = [&](const std::string& one, const std::string& other) {
    if (scene.has(one) && scene.has(other))
      refuse_key(scene, one, "does not go with " + other, "one of the two");
  };
  for (const auto& [name, read, kinds, excludes, needs] : keys()) {
    for (const std::string& other : excludes) exclude(name, other);
    if (scene.has(name) && !needs.empty() && !scene.has(needs) && !scene.wants(needs))
      refuse_key(scene, name, "without " + needs, "both");
  }
  if (scene.kind != Kind::chain)
    for (const char* const wall : {"left_wall", "right_wall"}) exclude("L", wall);
  if (scene.has("blocks") && !scene.has("balls") && scene.masses.size() > 1)
    refuse_key(scene, "blocks", "without balls", "both");
  if (scene.has("every") &&
      (scene.has("times") || !(scene.wants("events") || scene.wants("trajectory"))))
    refuse_key(scene, "every", "there is nothing to leave out",
               "with the output events, or with trajectory but no times");
  const std::size_t bodies = scene.kind == Kind::three_body ? 3 : 2;
  if (scene.masses.empty())
    refuse_key(scene, "masses", scene.has("masses") ? "no bodies" : "missing",
               scene.kind == Kind::chain ? "masses, one or more, or blocks" : "masses, or alpha");
  if (scene.kind != Kind::chain && scene.masses.size() != bodies)
    refuse_key(scene, "masses", "a list of " + std::to_string(scene.masses.size()),
               std::to_string(bodies) + " in this kind of scene");
}

Quadratic exactly(const Scene& scene, const char* key, const Value& value) {
  if (value.exact() == nullptr) refuse_key(scene, key, "a ratio of the paper", "here a number");
  return *value.exact();
}

/// A chain's bodies one after the other, and walls as far from them.
void lay_out_chain(Scene& scene) {
  const Quadratic L = exactly(scene, "L", scene.L), gap = exactly(scene, "gap", scene.gap);
  const auto wall = [&](const char* side) { return scene.walls == side || scene.walls == "both"; };
  Quadratic place = 0;
  try {
    for (std::size_t i = 0; i < scene.masses.size(); ++i) {
      scene.positions.push_back({"", place});
      place = place + (i % 2 == 0 ? gap : L);
    }
  } catch (const std::domain_error& error) {
    refuse_key(scene, "gap", error.what(), "with L in one field");
  }
  if (wall("left")) scene.left_wall = Value{"", Quadratic(0) - gap};
  if (wall("right")) scene.right_wall = Value{"", place};
}

/// What the file leaves out: the first two bodies touch at 0, and the first one moves to the right,
/// or with a wall on the left the second one to the left.
void lay_out(Scene& scene) {
  if (scene.kind == Kind::wall && !scene.has("left_wall") && !scene.has("right_wall"))
    scene.right_wall = scene.L;
  if (!scene.has("positions") && scene.kind == Kind::chain) lay_out_chain(scene);
  if (!scene.has("positions") && scene.kind != Kind::chain) {
    scene.positions = {value_of(0), value_of(0)};
    if (scene.kind == Kind::three_body) scene.positions.push_back(scene.L);
  }
  if (!scene.has("velocities")) {
    scene.velocities.assign(scene.masses.size(), value_of(0));
    if (scene.kind == Kind::wall && scene.left_wall)
      scene.velocities[1] = {"", Quadratic(0) - exactly(scene, "V", scene.V)};
    else
      scene.velocities[0] = scene.V;
  }
}

void check_meaning(const Scene& scene) {
  if (scene.kind == Kind::wall && scene.left_wall && scene.right_wall)
    refuse_key(scene, "left_wall", "two walls", "one wall; two in kind = \"chain\"");
  const auto refuse_below_0 = [&](const char* key, const Value& value) {
    if (value.exact() != nullptr && *value.exact() < 0)
      refuse_key(scene, key, "got " + value.text.substr(0, 40), "0 or more");
  };
  for (const Value& time : scene.times) refuse_below_0("times", time);
  refuse_below_0("until", scene.until.value_or(value_of(0)));
  refuse_below_0("L", scene.L);
  refuse_below_0("gap", scene.gap);
  const auto found = has_exact_numbers(scene) ? simulator::fault(line_of<Quadratic>(scene))
                                              : simulator::fault(line_of<double>(scene));
  if (!found) return;
  for (const char* key : {"alpha", "mass_ratio", "balls"})
    if (found->key == "masses" && scene.has(key)) refuse_key(scene, key, "not above 0", "above 0");
  refuse_key(scene, found->key, found->what, found->allowed);
}

}  // namespace

toml::table table_of(std::string_view text, const std::string& source, const std::string& allowed) {
  const auto refuse = [&](std::ptrdiff_t line, const std::string& what) {
    throw InvalidInput(source + ":" + std::to_string(line) + ": " + what + "; allowed: " + allowed);
  };
  const std::size_t zero = text.find('\0');
  if (zero != text.npos) refuse(std::ranges::count(text.substr(0, zero), '\n') + 1, "a zero byte");
  if (is_too_deep(text)) refuse(1, "a key of more than 100 parts, or so many brackets");
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    std::string what(error.description());
    std::replace(what.begin(), what.end(), '\n', ' ');
    refuse(error.source().begin.line, what.substr(0, 200));
    throw;
  }
}

Scene parse_scene(std::string_view text, const std::string& source) {
  const toml::table table = table_of(text, source, allowed_scene);
  Scene scene;
  scene.source = source;
  for (const auto& [name, node] : table)
    scene.lines.emplace(name.str(), static_cast<std::int64_t>(name.source().begin.line));
  for (const Key& key : keys()) {
    if (key.name == "title") check_names(scene);  // the kind is read
    if (const toml::node* node = table.get(key.name)) key.read({*node, scene, key.name});
  }
  check_together(scene);
  lay_out(scene);
  check_meaning(scene);
  return scene;
}

std::string text_of(const std::string& path, const std::string& allowed, std::size_t longest) {
  std::ifstream file(path == "-" ? "/dev/stdin" : path, std::ios::binary);
  std::string text(longest + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.is_open() || file.bad() || (file.fail() && !file.eof()))
    throw InvalidInput("cannot read " + shown_source(path) + ": " +
                       std::generic_category().message(errno) + "; allowed: " + allowed);
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > longest)
    throw InvalidInput(shown_source(path) + ":1: more than " + std::to_string(longest) +
                       " bytes; allowed: " + allowed);
  return text;
}

Scene read_scene(const std::string& path) {
  return parse_scene(text_of(path, "a scene file in TOML", longest_scene), shown_source(path));
}

}  // namespace magicmass::scenes
