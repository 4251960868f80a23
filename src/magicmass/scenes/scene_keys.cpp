// SPDX-License-Identifier: MIT
#include "magicmass/scenes/scene_keys.hpp"

#include <algorithm>
#include <limits>

#include "magicmass/scenes/shown_text.hpp"

namespace magicmass {
namespace {

void read_title(const toml::node& node, const Place& place, Scene& scene) {
  scene.title = text_of(node, place, "a string");
  for (const char c : scene.title)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      place.refuse("a control character in it", "a line of text");
}

void read_kind(const toml::node& node, const Place& place, Scene& scene) {
  std::string allowed;
  for (const SceneKind& row : scene_kinds())
    allowed += (allowed.empty() ? "\"" : ", \"") + std::string(row.name) + '"';
  const std::string name = text_of(node, place, allowed);
  for (const SceneKind& row : scene_kinds()) {
    if (name == row.name) {
      scene.kind = row.kind;
      return;
    }
  }
  place.refuse("unknown kind \"" + shown_text(name) + '"', allowed);
}

void read_alpha(const toml::node& node, const Place& place, Scene& scene) {
  scene.masses = {1.0, ratio_of(node, place), 1.0};
}

void read_mass_ratio(const toml::node& node, const Place& place, Scene& scene) {
  scene.masses = {ratio_of(node, place), 1.0};
}

void read_masses(const toml::node& node, const Place& place, Scene& scene) {
  scene.masses = values_of(node, place);
  const SceneKind& kind = row_of(scene.kind);
  const bool right = kind.bodies == 0 ? !scene.masses.empty() : scene.masses.size() == kind.bodies;
  if (!right)
    place.refuse("got " + std::to_string(scene.masses.size()) + " masses", kind.bodies_words);
}

void read_blocks(const toml::node& node, const Place& place, Scene& scene) {
  const auto blocks = static_cast<std::size_t>(
      whole_of(node, place, 1, static_cast<std::int64_t>(most_bodies / 2)));
  scene.masses.assign(2 * blocks - 1, 1.0);
}

void read_balls(const toml::node& node, const Place& place, Scene& scene) {
  if (scene.masses.empty()) return;  // no blocks, which is said later
  const std::size_t balls = scene.masses.size() / 2;
  std::vector<Value> masses;
  if (node.is_array())
    masses = values_of(node, place);
  else
    masses.assign(balls, ratio_of(node, place));
  if (masses.size() != balls)
    place.refuse("got " + std::to_string(masses.size()) + " balls for " + std::to_string(balls) +
                     " gaps between blocks",
                 "one value for all balls, or an array with one for each");
  for (std::size_t i = 0; i < balls; ++i) scene.masses[2 * i + 1] = masses[i];
}

void read_positions(const toml::node& node, const Place& place, Scene& scene) {
  scene.positions = values_of(node, place);
}

void read_velocities(const toml::node& node, const Place& place, Scene& scene) {
  scene.velocities = values_of(node, place);
}

void read_V(const toml::node& node, const Place& place, Scene& scene) {
  scene.V = value_of(node, place);
}

void read_L(const toml::node& node, const Place& place, Scene& scene) {
  scene.L = value_of(node, place);
}

void read_gap(const toml::node& node, const Place& place, Scene& scene) {
  scene.gap = value_of(node, place);
}

void read_restitution(const toml::node& node, const Place& place, Scene& scene) {
  scene.restitution = value_of(node, place);
}

void read_walls(const toml::node& node, const Place& place, Scene& scene) {
  constexpr std::string_view allowed = "\"none\", \"left\", \"right\", \"both\"";
  const std::string walls = text_of(node, place, allowed);
  if (walls != "none" && walls != "left" && walls != "right" && walls != "both")
    place.refuse("got \"" + shown_text(walls) + '"', allowed);
  scene.has_left_wall = walls == "left" || walls == "both";
  scene.has_right_wall = walls == "right" || walls == "both";
}

void read_left_wall(const toml::node& node, const Place& place, Scene& scene) {
  scene.has_left_wall = true;
  scene.left_wall = value_of(node, place);
}

void read_right_wall(const toml::node& node, const Place& place, Scene& scene) {
  scene.has_right_wall = true;
  scene.right_wall = value_of(node, place);
}

void read_outputs(const toml::node& node, const Place& place, Scene& scene) {
  constexpr std::string_view allowed =
      "an array of \"counts\", \"terminal\", \"events\", \"trajectory\", \"energy\", each at most "
      "once";
  const toml::array* names = node.as_array();
  if (names == nullptr) place.refuse("expected an array, got a TOML " + type_name(node), allowed);
  scene.outputs.clear();
  for (const toml::node& element : *names) {
    const Place here{place.source, place.key, element.source().begin.line};
    const std::string name = text_of(element, here, allowed);
    bool known = false;
    for (const Output output :
         {Output::counts, Output::terminal, Output::events, Output::trajectory, Output::energy}) {
      if (name != to_text(output)) continue;
      known = true;
      if (wants(scene, output)) here.refuse("\"" + name + "\" is there twice", allowed);
      scene.outputs.push_back(output);
    }
    if (!known) here.refuse("unknown output \"" + shown_text(name) + '"', allowed);
  }
  if (scene.outputs.empty()) place.refuse("no output asked for", allowed);
  std::sort(scene.outputs.begin(), scene.outputs.end());
}

void read_every(const toml::node& node, const Place& place, Scene& scene) {
  scene.every = whole_of(node, place, 1, std::numeric_limits<std::int64_t>::max());
}

void read_times(const toml::node& node, const Place& place, Scene& scene) {
  scene.times = values_of(node, place);
}

void read_until(const toml::node& node, const Place& place, Scene& scene) {
  scene.until = value_of(node, place);
}

void read_max_events(const toml::node& node, const Place& place, Scene& scene) {
  scene.max_events = whole_of(node, place, 0, std::int64_t{1} << 53U);
}

}  // namespace

/// In the order in which they are read: what a key needs stands before it.
const std::vector<SceneKey>& scene_keys() {
  static const std::vector<SceneKey> keys = {
      {"title", read_title},
      {"kind", read_kind},
      {"alpha", read_alpha, {Kind::three_body}},
      {"mass_ratio", read_mass_ratio, {Kind::wall}},
      {"masses", read_masses},
      {"blocks", read_blocks, {Kind::chain}},
      {"balls", read_balls, {Kind::chain}},
      {"V", read_V},
      {"L", read_L},
      {"gap", read_gap, {Kind::chain}},
      {"positions", read_positions},
      {"velocities", read_velocities},
      {"wall", read_right_wall, {Kind::wall}},
      {"walls", read_walls, {Kind::chain}},
      {"left_wall", read_left_wall, {Kind::chain}},
      {"right_wall", read_right_wall, {Kind::chain}},
      {"restitution", read_restitution},
      {"outputs", read_outputs},
      {"every", read_every},
      {"times", read_times},
      {"until", read_until},
      {"max_events", read_max_events},
  };
  return keys;
}

const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> kinds = {
      {Kind::three_body, "three-body", "alpha",
       "a line like alpha = 0.1 or alpha = \"magic:3\", or masses = [1, 0.1, 2]", 3,
       "three: those of A, C and B"},
      {Kind::wall, "wall", "mass_ratio", "a line like mass_ratio = \"100^3\", or masses = [100, 1]",
       2, "two: those of the block A and the ball C"},
      {Kind::chain, "chain", "blocks",
       "lines like blocks = 5 and balls = \"magic:3\", or masses = [1, 0.1, 1]", 0,
       "one or more, from left to right"},
  };
  return kinds;
}

const SceneKind& row_of(Kind kind) {
  return *std::find_if(scene_kinds().begin(), scene_kinds().end(),
                       [&](const SceneKind& row) { return row.kind == kind; });
}

}  // namespace magicmass
