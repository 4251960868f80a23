// SPDX-License-Identifier: MIT
#include "magicmass/scenes/scene.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

#include <toml++/toml.h>

#include "magicmass/errors.hpp"
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

/// Where a value stands, for messages.
struct Place {
  std::string_view source;
  std::string_view key;
  unsigned line;

  [[noreturn]] void refuse(const std::string& what, std::string_view allowed) const {
    throw InvalidInput(std::string(source) + ":" + std::to_string(line) + ": " + shown_text(key) +
                       ": " + what + "; allowed: " + std::string(allowed));
  }
};

std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string type_name(const toml::node& node) {
  std::ostringstream name;
  name << node.type();
  return name.str();
}

std::string text_of(const toml::node& node, const Place& place, std::string_view allowed) {
  if (const auto* text = node.as_string()) {
    return text->get();
  }
  place.refuse("expected a string, got a TOML " + type_name(node), allowed);
}

double number_of(const toml::node& node, const Place& place, std::string_view allowed) {
  if (const auto* number = node.as_floating_point()) {
    return number->get();
  }
  if (const auto* number = node.as_integer()) {
    return static_cast<double>(number->get());
  }
  place.refuse("expected a number, got a TOML " + type_name(node), allowed);
}

double positive_number_of(const toml::node& node, const Place& place) {
  constexpr std::string_view allowed = "a positive finite number";
  const double number = number_of(node, place, allowed);
  if (!(number > 0.0) || !std::isfinite(number)) {
    place.refuse("got " + shortest(number), allowed);
  }
  return number;
}

void read_title(const toml::node& node, const Place& place, Scene& scene) {
  scene.title = text_of(node, place, "a string");
}

void read_kind(const toml::node& node, const Place& place, Scene& scene) {
  constexpr std::string_view allowed = "\"three-body\"";
  scene.kind = text_of(node, place, allowed);
  if (scene.kind == "wall" || scene.kind == "chain") {
    place.refuse("\"" + scene.kind + "\" is not available yet", allowed);
  }
  if (scene.kind != "three-body") {
    place.refuse("unknown kind \"" + shown_text(scene.kind) + '"', allowed);
  }
}

/// Numbers go through the same reader as text, so a scene, the command line and a CSV cell mean the same.
void read_alpha(const toml::node& node, const Place& place, Scene& scene) {
  constexpr std::string_view allowed =
      "a positive finite number, or a string with a decimal, a hex float, a "
      "fraction like \"1/7\", \"magic:k\" or \"deficient:k\"";
  std::string text;
  if (const auto* string = node.as_string()) {
    text = string->get();
  } else if (const auto* integer = node.as_integer()) {
    text = std::to_string(integer->get());
  } else {
    text = shortest(number_of(node, place, allowed));
  }
  try {
    scene.alpha = parse_mass_ratio(text);
  } catch (const InvalidInput& error) {
    const std::string what = error.what();
    place.refuse(what.substr(0, what.rfind("; allowed: ")), allowed);
  }
}

void read_V(const toml::node& node, const Place& place, Scene& scene) {
  scene.V = positive_number_of(node, place);
}

void read_L(const toml::node& node, const Place& place, Scene& scene) {
  scene.L = positive_number_of(node, place);
}

void read_restitution(const toml::node& node, const Place& place, Scene& scene) {
  constexpr std::string_view allowed = "1.0 (only elastic collisions so far)";
  scene.restitution = number_of(node, place, allowed);
  if (scene.restitution != 1.0) {
    place.refuse("got " + shortest(scene.restitution), allowed);
  }
}

void read_outputs(const toml::node& node, const Place& place, Scene& scene) {
  constexpr std::string_view allowed =
      "an array of \"counts\", \"terminal\", \"events\", \"trajectory\", \"energy\", each at most "
      "once";
  const toml::array* names = node.as_array();
  if (names == nullptr) {
    place.refuse("expected an array, got a TOML " + type_name(node), allowed);
  }
  scene.outputs.clear();
  for (const toml::node& element : *names) {
    const Place here{place.source, place.key, element.source().begin.line};
    const std::string name = text_of(element, here, allowed);
    const auto* const known = std::find_if(output_names.begin(), output_names.end(),
                                           [&](const auto& entry) { return entry.first == name; });
    if (known == output_names.end()) {
      here.refuse("unknown output \"" + shown_text(name) + '"', allowed);
    }
    if (wants(scene, known->second)) {
      here.refuse("\"" + name + "\" is there twice", allowed);
    }
    scene.outputs.push_back(known->second);
  }
  if (scene.outputs.empty()) {
    place.refuse("no output asked for", allowed);
  }
  std::sort(scene.outputs.begin(), scene.outputs.end());
}

using Reader = void (*)(const toml::node&, const Place&, Scene&);

constexpr std::string_view known_keys = "title, kind, alpha, V, L, restitution, outputs";

constexpr std::array<std::pair<std::string_view, Reader>, 7> readers = {{
    {"title", read_title},
    {"kind", read_kind},
    {"alpha", read_alpha},
    {"V", read_V},
    {"L", read_L},
    {"restitution", read_restitution},
    {"outputs", read_outputs},
}};

toml::table parse_table(std::string_view text, std::string_view source_name) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw InvalidInput(std::string(source_name) + ":" + std::to_string(error.source().begin.line) +
                       ": not valid TOML: " + shown_text(error.description(), 200) +
                       "; allowed: lines like alpha = 0.1");
  }
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

Scene parse_scene(std::string_view text, std::string_view source_name) {
  const toml::table table = parse_table(text, source_name);
  Scene scene;
  for (const auto& [key, node] : table) {
    const Place place{source_name, key.str(), key.source().begin.line};
    const auto* const known = std::find_if(readers.begin(), readers.end(), [&](const auto& entry) {
      return entry.first == place.key;
    });
    if (known == readers.end()) {
      place.refuse("unknown key", known_keys);
    }
    known->second(node, place, scene);
  }
  if (!table.contains("alpha")) {
    Place{source_name, "alpha", 1}.refuse("missing",
                                          "a line like alpha = 0.1 or alpha = \"magic:3\"");
  }
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
