// SPDX-License-Identifier: GPL-2.0-or-later
// The table of keys that a scene may have.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "magicmass/scenes/scene.hpp"

namespace magicmass::scenes {

struct Key {
  std::string name;
  void (*read)(const toml::node&, Scene&, const std::string& key);
  std::vector<Kind> kinds = {};  ///< that have it; none: all
};

/// In the order in which they are read.
const std::vector<Key>& keys();

/// Of the names the one that a misspelt one most likely means: the fewest letters to insert, delete
/// or replace, fewer than half of its own; "" where none is that near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& names);

}  // namespace magicmass::scenes
