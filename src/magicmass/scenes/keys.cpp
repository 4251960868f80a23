// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/keys.hpp"

#include <iterator>
#include <sstream>

#include "magicmass/numbers/errors.hpp"

namespace magicmass::scenes {
namespace {

const std::vector<std::string> kinds{"three-body", "wall", "chain"};  // as in Kind
const std::vector<std::string> sides{"none", "left", "right", "both"};
const std::vector<std::string> all_outputs{"counts", "terminal", "events", "trajectory", "energy"};
constexpr std::int64_t most_blocks = 500'000;

std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string quoted_list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + quoted(word);
  return text;
}

[[noreturn]] void refuse(const Field& f, const std::string& what, std::string_view allowed) {
  refuse_key(f.scene, f.key, what, allowed);
}

[[noreturn]] void refuse_type(const Field& f, std::string_view allowed) {
  std::ostringstream what;
  what << "got a TOML " << f.node.type();
  refuse(f, what.str(), allowed);
}

std::string text_at(const Field& f, const std::string& allowed) {
  if (const auto* text = f.node.as_string()) return text->get();
  refuse_type(f, allowed);
}

/// Which of these words it is.
std::size_t word_at(const Field& f, const std::vector<std::string>& words,
                    const std::string& before = "") {
  const std::string allowed = before + quoted_list(words), text = text_at(f, allowed);
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end()) refuse(f, "got " + quoted(text.substr(0, 40)), allowed);
  return static_cast<std::size_t>(found - words.begin());
}

Value value_at(const Field& f) {
  const auto* text = f.node.as_string();
  try {
    if (text != nullptr) return read_value(text->get());
    if (const auto* whole = f.node.as_integer()) return read_value(std::to_string(whole->get()));
    if (const auto* number = f.node.as_floating_point()) return value_of(number->get());
  } catch (const InvalidInput& error) {
    const std::string got = text == nullptr ? "" : quoted(text->get().substr(0, 40)) + ": ";
    refuse(f, got + error.what(), allowed_values);
  }
  refuse_type(f, allowed_values);
}

std::vector<Field> elements(const Field& f, std::string_view allowed) {
  const toml::array* array = f.node.as_array();
  if (array == nullptr) refuse_type(f, allowed);
  std::vector<Field> all;
  for (const toml::node& element : *array) all.push_back({element, f.scene, f.key});
  return all;
}

std::vector<Value> values_at(const Field& f) {
  std::vector<Value> values;
  for (const Field& element : elements(f, "an array of values"))
    values.push_back(value_at(element));
  return values;
}

std::int64_t whole_at(const Field& f, std::int64_t least, std::int64_t most = INT64_MAX) {
  const std::string to = most == INT64_MAX ? " or more" : " to " + std::to_string(most);
  const std::string allowed = "a whole number, " + std::to_string(least) + to;
  const auto* number = f.node.as_integer();
  if (number == nullptr) refuse_type(f, allowed);
  if (number->get() < least || number->get() > most)
    refuse(f, "got " + std::to_string(number->get()), allowed);
  return number->get();
}

/// Blocks of one mass, and the ball before the other block or the wall, wherever that is.
void set_masses(Scene& scene, const Value& block, const Value& ball) {
  scene.masses = {block, ball};
  if (scene.kind == Kind::three_body) scene.masses.push_back(block);
  if (scene.has("left_wall")) std::swap(scene.masses[0], scene.masses[1]);
}

void read_alpha(const Field& f) { set_masses(f.scene, value_of(1), value_at(f)); }

void read_mass_ratio(const Field& f) { set_masses(f.scene, value_at(f), value_of(1)); }

void read_blocks(const Field& f) {
  const auto blocks = static_cast<std::size_t>(whole_at(f, 1, most_blocks));
  f.scene.masses.assign(2 * blocks - 1, value_of(1));
}

void read_walls(const Field& f) { f.scene.walls = sides[word_at(f, sides)]; }

void read_outputs(const Field& f) {
  const std::string array = "an array of ";
  f.scene.outputs.clear();
  for (const Field& element : elements(f, array + quoted_list(all_outputs)))
    f.scene.outputs.push_back(all_outputs[word_at(element, all_outputs, array)]);
}

void read_balls(const Field& f) {
  const std::size_t balls = f.scene.masses.size() / 2;
  const std::vector<Value> masses =
      f.node.is_array() ? values_at(f) : std::vector<Value>(balls, value_at(f));
  if (masses.size() != balls)
    refuse(f, "a list of " + std::to_string(masses.size()),
           "one value, or as many as there are gaps between blocks: " + std::to_string(balls));
  for (std::size_t i = 0; i < balls; ++i) f.scene.masses[2 * i + 1] = masses[i];
}

template <auto member>
void read(const Field& f) {
  auto& at = f.scene.*member;
  if constexpr (std::is_same_v<decltype(at), std::vector<Value>&>)
    at = values_at(f);
  else
    at = value_at(f);
}

}  // namespace

const std::vector<Key>& keys() {
  static const std::vector<Key> all{
      {"kind", [](const Field& f) { f.scene.kind = static_cast<Kind>(word_at(f, kinds)); }},
      {"title", [](const Field& f) { text_at(f, "a text"); }},
      {"alpha", read_alpha, {Kind::three_body, Kind::wall}, {"masses", "mass_ratio"}},
      {"mass_ratio", read_mass_ratio, {Kind::wall}, {"masses"}},
      {"masses", read<&Scene::masses>},
      {"blocks", read_blocks, {Kind::chain}, {"masses"}},
      {"balls", read_balls, {Kind::chain}, {}, "blocks"},
      {"positions", read<&Scene::positions>},
      {"velocities", read<&Scene::velocities>},
      {"V", read<&Scene::V>, {}, {"velocities"}},
      {"L", read<&Scene::L>, {}, {"positions"}},
      {"gap", read<&Scene::gap>, {Kind::chain}, {"positions"}},
      {"walls", read_walls, {Kind::chain}, {"positions", "left_wall", "right_wall"}},
      {"left_wall", read<&Scene::left_wall>, {Kind::wall, Kind::chain}},
      {"right_wall", read<&Scene::right_wall>, {Kind::wall, Kind::chain}},
      {"restitution", read<&Scene::restitution>},
      {"outputs", read_outputs},
      {"every", [](const Field& f) { f.scene.every = whole_at(f, 1); }},
      {"times", read<&Scene::times>, {}, {}, "trajectory"},
      {"until", read<&Scene::until>},
      {"max_events", [](const Field& f) { f.scene.max_events = whole_at(f, 0); }},
  };
  return all;
}

std::string nearest_name(const std::string& name, const std::vector<std::string>& names) {
  for (const std::string& other : names) {
    const auto [from, begin] = std::mismatch(name.begin(), name.end(), other.begin(), other.end());
    const auto [to, end] = std::mismatch(name.rbegin(), std::make_reverse_iterator(from),
                                         other.rbegin(), std::make_reverse_iterator(begin));
    const auto letters = std::max(to.base() - from, end.base() - begin);
    if (letters <= 2 && 2 * letters < std::ssize(other)) return other;
  }
  return "";
}

}  // namespace magicmass::scenes
