// From a file to a scene: a table of keys, and what they mean together.
#include <sstream>

#include "magicmass/scenes/files.hpp"
#include "magicmass/scenes/scene.hpp"

namespace magicmass::scenes {
namespace {

const std::string allowed_scene = "a scene in TOML, lines like alpha = 0.12 or alpha = \"1/7\"";
constexpr std::size_t longest_scene = std::size_t{1} << 23U;  // 10^5 bodies with all their digits
const std::vector<std::string> all_kinds{"three-body", "wall", "chain"};  // as in Kind
const std::vector<std::string> sides{"none", "left", "right", "both"};
const std::vector<std::string> all_outputs{"counts", "terminal", "events", "trajectory", "energy"};
constexpr std::int64_t most_blocks = 300'000;

/// What the file has for a key, and the scene that is read.
struct Field {
  const toml::node& node;
  Scene& scene;
  const std::string& key;
};

std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string listed(const std::vector<std::string>& words, const std::string& mark = "") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + mark + word + mark;
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

std::size_t word_at(const Field& f, const std::vector<std::string>& words,
                    const std::string& before = "") {
  const std::string allowed = before + listed(words, "\""), text = text_at(f, allowed);
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
  for (const auto& element : elements(f, "an array of values")) values.push_back(value_at(element));
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
  f.scene.masses.assign(2 * std::size_t(whole_at(f, 1, most_blocks)) - 1, value_of(1));
}

void read_walls(const Field& f) { f.scene.walls = sides[word_at(f, sides)]; }

void read_outputs(const Field& f) {
  const std::string array = "an array of ";
  f.scene.outputs.clear();
  for (const Field& element : elements(f, array + listed(all_outputs, "\"")))
    f.scene.outputs.push_back(all_outputs[word_at(element, all_outputs, array)]);
}

void read_balls(const Field& f) {
  const std::size_t balls = f.scene.masses.size() / 2;
  const auto masses = f.node.is_array() ? values_at(f) : std::vector(balls, value_at(f));
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

struct Key {
  std::string name;
  void (*read)(const Field&);
  std::vector<Kind> kinds = {};            ///< that have it; none: all
  std::vector<std::string> excludes = {};  ///< keys that it does not go with
  std::string needs = {};                  ///< a key or an output that it does not go without
};

/// In the order in which they are read.
const std::vector<Key> keys{
    {"kind", [](const Field& f) { f.scene.kind = static_cast<Kind>(word_at(f, all_kinds)); }},
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

void check_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Key& key : keys)
    if (key.kinds.empty() || std::ranges::count(key.kinds, scene.kind) != 0)
      names.push_back(key.name);
  for (const auto& [name, line] : scene.lines) {
    if (std::ranges::count(names, name) != 0) continue;
    const std::string what = "no such key in this kind of scene" + meant(name, names);
    refuse_key(scene, name.substr(0, 40), what, listed(names));
  }
}

/// What is there together, and how many.
void check_together(const Scene& scene) {
  const auto exclude = [&](const std::string& one, const std::string& other) {
    if (scene.has(one) && scene.has(other))
      refuse_key(scene, one, "does not go with " + other, "one of the two");
  };
  for (const Key& key : keys) {
    for (const std::string& other : key.excludes) exclude(key.name, other);
    const std::string& needs = key.needs;
    if (scene.has(key.name) && !needs.empty() && !scene.has(needs) && !scene.wants(needs))
      refuse_key(scene, key.name, "without " + needs, "both");
  }
  if (scene.kind != Kind::chain)
    for (const char* const wall : {"left_wall", "right_wall"}) exclude("L", wall);
  if (scene.has("blocks") && !scene.has("balls") && scene.masses.size() > 1)
    refuse_key(scene, "blocks", "without balls", "both");
  if (scene.has("every") && !scene.wants("events") &&
      (scene.has("times") || !scene.wants("trajectory")))
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

Surd exactly(const Scene& scene, const char* key, const Value& value) {
  if (value.exact() == nullptr) refuse_key(scene, key, "a ratio of the paper", "here a number");
  return *value.exact();
}

/// A chain's bodies one after the other, and walls as far from them.
void lay_out_chain(Scene& scene) {
  const Surd L = exactly(scene, "L", scene.L), gap = exactly(scene, "gap", scene.gap);
  const auto wall = [&](const char* side) { return scene.walls == side || scene.walls == "both"; };
  Surd place = 0;
  for (std::size_t i = 0; i < scene.masses.size(); ++i) {
    scene.positions.push_back({"", place});
    place = place + (i % 2 == 0 ? gap : L);
  }
  if (wall("left")) scene.left_wall = Value{"", -gap};
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
      scene.velocities[1] = negative(scene.V);
    else
      scene.velocities[0] = scene.V;
  }
}

void check_meaning(const Scene& scene) {
  if (scene.kind == Kind::wall && scene.left_wall && scene.right_wall)
    refuse_key(scene, "left_wall", "two walls", "one wall; two in kind = \"chain\"");
  const auto refuse_below_0 = [&](const char* key, const Value& value) {
    if (!value.is(0) && !value.is_positive())
      refuse_key(scene, key, "got " + value.text.substr(0, 40), "0 or more");
  };
  refuse_below_0("until", scene.until.value_or(value_of(0)));
  for (const Value& time : scene.times) {
    refuse_below_0("times", time);
    const Value end = scene.until.value_or(time);
    const auto late = difference(time, end);
    if (late ? late->is_positive() : time.to_double() > end.to_double())
      refuse_key(scene, "times", time.text.substr(0, 40) + " is after until",
                 "at most " + end.text.substr(0, 40));
  }
  refuse_below_0("L", scene.L);
  refuse_below_0("gap", scene.gap);
  const auto found = has_exact_numbers(scene) ? simulator::fault(line_of<Surd>(scene))
                                              : simulator::fault(line_of<double>(scene));
  if (!found) return;
  for (const char* key : {"alpha", "mass_ratio", "balls"})
    if (found->key == "masses" && scene.has(key))
      refuse_key(scene, key, "0 or less as a double", "above 0; below 5e-324 as a fraction");
  refuse_key(scene, found->key, found->what, found->allowed);
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& source) {
  const toml::table table = table_of(text, source, allowed_scene);
  Scene scene;
  scene.source = source;
  for (const auto& [name, node] : table)
    scene.lines.emplace(name.str(), static_cast<std::int64_t>(name.source().begin.line));
  for (const Key& key : keys) {
    if (key.name == "title") check_names(scene);  // the kind is read
    if (const toml::node* node = table.get(key.name)) key.read({*node, scene, key.name});
  }
  check_together(scene);
  lay_out(scene);
  check_meaning(scene);
  return scene;
}

Scene read_scene(const std::string& path) {
  return parse_scene(text_of(path, "a scene file in TOML", longest_scene),
                     path == "-" ? "stdin" : path);
}

}  // namespace magicmass::scenes
