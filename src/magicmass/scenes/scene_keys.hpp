// SPDX-License-Identifier: MIT
// From a TOML value to what a scene keeps of it, with the place for messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "magicmass/scenes/scene.hpp"

namespace magicmass {

/// Where a value stands, for messages.
struct Place {
  std::string_view source;
  std::string_view key;
  unsigned line;

  [[noreturn]] void refuse(const std::string& what, std::string_view allowed) const;
};

/// Whether a key in a TOML text may have more than 1000 parts, a.a.a...: a parser's recursion would not end well.
bool has_endless_key(std::string_view text);

/// Each throws InvalidInput where the value is of another type or form.
std::string text_of(const toml::node& node, const Place& place, std::string_view allowed);
Value value_of(const toml::node& node, const Place& place);
std::vector<Value> values_of(const toml::node& node, const Place& place);
std::int64_t whole_of(const toml::node& node, const Place& place, std::int64_t least,
                      std::int64_t most);
/// A mass ratio, or another value that is one once it is known to be positive.
Value ratio_of(const toml::node& node, const Place& place);
std::string type_name(const toml::node& node);

/// Reads one key of a scene.
using KeyReader = void (*)(const toml::node&, const Place&, Scene&);
struct SceneKey {
  std::string_view name;
  KeyReader read;
  std::vector<Kind> kinds = {};  ///< that have it; none: all of them
};
const std::vector<SceneKey>& scene_keys();

/// What tells a kind of scene from the others.
struct SceneKind {
  Kind kind;
  std::string_view name;
  std::string_view mass_key;      ///< the key by which masses are usually given
  std::string_view mass_lines;    ///< what is allowed where there are none
  std::size_t bodies;             ///< how many; 0: any number but none
  std::string_view bodies_words;  ///< what is allowed where there are others
};
const std::vector<SceneKind>& scene_kinds();
const SceneKind& row_of(Kind kind);

}  // namespace magicmass
