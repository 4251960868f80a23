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
  bool three_body, wall, chain;  ///< the kinds that have it
};
const std::vector<SceneKey>& scene_keys();

}  // namespace magicmass
