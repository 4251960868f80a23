// SPDX-License-Identifier: MIT
#include "magicmass/scenes/scene_keys.hpp"

#include <algorithm>
#include <limits>

#include "magicmass/scenes/shown_text.hpp"

namespace magicmass {
namespace {

void read_title(const toml::node& node, const Place& place, Scene& scene) {
  scene.title = text_of(node, place, "a string");
}

void read_kind(const toml::node& node, const Place& place, Scene& scene) {
  constexpr std::string_view allowed = "\"three-body\", \"wall\", \"chain\"";
  const std::string name = text_of(node, place, allowed);
  for (const Kind kind : {Kind::three_body, Kind::wall, Kind::chain}) {
    if (name == to_text(kind)) {
      scene.kind = kind;
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
  const std::size_t needed = scene.kind == Kind::three_body ? 3 : 2;
  const bool right =
      scene.kind == Kind::chain ? !scene.masses.empty() : scene.masses.size() == needed;
  if (!right)
    place.refuse("got " + std::to_string(scene.masses.size()) + " masses",
                 scene.kind == Kind::three_body ? "three: those of A, C and B"
                 : scene.kind == Kind::wall     ? "two: those of the block A and the ball C"
                                                : "one or more, from left to right");
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
      {"title", read_title, true, true, true},
      {"kind", read_kind, true, true, true},
      {"alpha", read_alpha, true, false, false},
      {"mass_ratio", read_mass_ratio, false, true, false},
      {"masses", read_masses, true, true, true},
      {"blocks", read_blocks, false, false, true},
      {"balls", read_balls, false, false, true},
      {"V", read_V, true, true, true},
      {"L", read_L, true, true, true},
      {"gap", read_gap, false, false, true},
      {"positions", read_positions, true, true, true},
      {"velocities", read_velocities, true, true, true},
      {"wall", read_right_wall, false, true, false},
      {"walls", read_walls, false, false, true},
      {"left_wall", read_left_wall, false, false, true},
      {"right_wall", read_right_wall, false, false, true},
      {"restitution", read_restitution, true, true, true},
      {"outputs", read_outputs, true, true, true},
      {"every", read_every, true, true, true},
      {"times", read_times, true, true, true},
      {"until", read_until, true, true, true},
      {"max_events", read_max_events, true, true, true},
  };
  return keys;
}

}  // namespace magicmass
