// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/keys.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>

#include "magicmass/numbers/errors.hpp"

namespace magicmass::scenes {
namespace {

const std::vector<std::string> kinds{"three-body", "wall", "chain"};  // as in Kind
const std::vector<std::string> sides{"none", "left", "right", "both"};
const std::vector<std::string> all_outputs{"counts", "terminal", "events", "trajectory", "energy"};
constexpr std::int64_t most_blocks = 500'000;

std::string quoted_list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "\"" : ", \"") + word + '"';
  return text;
}

std::string type_of(const toml::node& node) {
  std::ostringstream name;
  name << node.type();
  return "a TOML " + name.str();
}

/// Which of these words it is.
std::size_t word_at(const toml::node& node, const Scene& scene, const std::string& key,
                    const std::vector<std::string>& words, const std::string& before = "") {
  const auto* text = node.as_string();
  const auto found = std::find(words.begin(), words.end(), text == nullptr ? "" : text->get());
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  const std::string got = text == nullptr ? type_of(node) : '"' + text->get().substr(0, 40) + '"';
  refuse_key(scene, key, "got " + got, before + quoted_list(words));
}

Value value_at(const toml::node& node, const Scene& scene, const std::string& key) {
  try {
    if (const auto* text = node.as_string()) return read_value(text->get());
    if (const auto* whole = node.as_integer()) return read_value(std::to_string(whole->get()));
    if (const auto* number = node.as_floating_point()) return value_of(number->get());
  } catch (const InvalidInput& error) {
    const auto* text = node.as_string();
    const std::string got = text == nullptr ? "" : '"' + text->get().substr(0, 40) + "\": ";
    refuse_key(scene, key, got + error.what(), allowed_values);
  }
  refuse_key(scene, key, "got " + type_of(node), allowed_values);
}

const toml::array& array_at(const toml::node& node, const Scene& scene, const std::string& key,
                            std::string_view allowed) {
  if (const toml::array* elements = node.as_array()) return *elements;
  refuse_key(scene, key, "got " + type_of(node), allowed);
}

void read_title(const toml::node& node, Scene& scene, const std::string& key) {
  const auto* text = node.as_string();
  if (text == nullptr) refuse_key(scene, key, "got " + type_of(node), "a text");
  scene.title = text->get();
}

void read_kind(const toml::node& node, Scene& scene, const std::string& key) {
  scene.kind = static_cast<Kind>(word_at(node, scene, key, kinds));
}

void read_walls(const toml::node& node, Scene& scene, const std::string& key) {
  scene.walls = sides[word_at(node, scene, key, sides)];
}

void read_alpha(const toml::node& node, Scene& scene, const std::string& key) {
  scene.masses = {value_of(1), value_at(node, scene, key)};
  if (scene.kind == Kind::three_body) scene.masses.push_back(value_of(1));
}

void read_outputs(const toml::node& node, Scene& scene, const std::string& key) {
  const std::string array = "an array of ";
  const std::string allowed = array + quoted_list(all_outputs);
  scene.outputs.clear();
  for (const toml::node& element : array_at(node, scene, key, allowed))
    scene.outputs.push_back(all_outputs[word_at(element, scene, key, all_outputs, array)]);
}

std::int64_t whole_at(const toml::node& node, const Scene& scene, const std::string& key,
                      std::int64_t least, std::int64_t most = INT64_MAX) {
  const std::string to = most == INT64_MAX ? " or more" : " to " + std::to_string(most);
  const std::string allowed = "a whole number, " + std::to_string(least) + to;
  const auto* number = node.as_integer();
  if (number == nullptr) refuse_key(scene, key, "got " + type_of(node), allowed);
  if (number->get() < least || number->get() > most)
    refuse_key(scene, key, "got " + std::to_string(number->get()), allowed);
  return number->get();
}

void read_blocks(const toml::node& node, Scene& scene, const std::string& key) {
  const std::int64_t blocks = whole_at(node, scene, key, 1, most_blocks);
  scene.masses.assign(2 * static_cast<std::size_t>(blocks) - 1, value_of(1));
}

void read_balls(const toml::node& node, Scene& scene, const std::string& key) {
  const std::size_t balls = scene.masses.size() / 2;
  std::vector<Value> masses;
  if (const toml::array* elements = node.as_array()) {
    for (const toml::node& element : *elements) masses.push_back(value_at(element, scene, key));
  } else {
    masses.assign(balls, value_at(node, scene, key));
  }
  if (masses.size() != balls)
    refuse_key(scene, key, std::to_string(masses.size()) + " balls",
               "one value, or as many as there are gaps between blocks: " + std::to_string(balls));
  for (std::size_t i = 0; i < balls; ++i) scene.masses[2 * i + 1] = masses[i];
}

template <auto member>
void read(const toml::node& node, Scene& scene, const std::string& key) {
  scene.*member = value_at(node, scene, key);
}

template <auto member>
void read_list(const toml::node& node, Scene& scene, const std::string& key) {
  for (const toml::node& element : array_at(node, scene, key, "an array of values"))
    (scene.*member).push_back(value_at(element, scene, key));
}

}  // namespace

const std::vector<Key>& keys() {
  static const std::vector<Key> all{
      {"kind", read_kind},
      {"title", read_title},
      {"alpha", read_alpha, {Kind::three_body, Kind::wall}},
      {"mass_ratio",
       [](const toml::node& node, Scene& scene, const std::string& key) {
         scene.masses = {value_at(node, scene, key), value_of(1)};
       },
       {Kind::wall}},
      {"masses", read_list<&Scene::masses>},
      {"blocks", read_blocks, {Kind::chain}},
      {"balls", read_balls, {Kind::chain}},
      {"positions", read_list<&Scene::positions>},
      {"velocities", read_list<&Scene::velocities>},
      {"V", read<&Scene::V>},
      {"L", read<&Scene::L>},
      {"gap", read<&Scene::gap>, {Kind::chain}},
      {"walls", read_walls, {Kind::chain}},
      {"left_wall", read<&Scene::left_wall>, {Kind::wall, Kind::chain}},
      {"right_wall", read<&Scene::right_wall>, {Kind::wall, Kind::chain}},
      {"restitution", read<&Scene::restitution>},
      {"outputs", read_outputs},
      {"every", [](const toml::node& node, Scene& scene,
                   const std::string& key) { scene.every = whole_at(node, scene, key, 1); }},
      {"times", read_list<&Scene::times>},
      {"until", read<&Scene::until>},
      {"max_events",
       [](const toml::node& node, Scene& scene, const std::string& key) {
         scene.max_events = whole_at(node, scene, key, 0);
       }},
  };
  return all;
}

std::string nearest_name(const std::string& name, const std::vector<std::string>& names) {
  std::string nearest;
  std::size_t least = name.size() / 2 + 1;
  if (name.size() > 40) return nearest;
  for (const std::string& other : names) {
    std::vector<std::size_t> row(other.size() + 1);  // distances from a beginning of the name
    std::iota(row.begin(), row.end(), 0U);
    for (std::size_t i = 0; i < name.size(); ++i) {
      std::size_t diagonal = row[0]++;
      for (std::size_t j = 0; j < other.size(); ++j) {
        const std::size_t replaced = diagonal + (name[i] == other[j] ? 0 : 1);
        diagonal = row[j + 1];
        row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
      }
    }
    if (row.back() >= least) continue;
    least = row.back();
    nearest = other;
  }
  return nearest;
}

}  // namespace magicmass::scenes
