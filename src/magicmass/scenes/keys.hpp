// SPDX-License-Identifier: GPL-2.0-or-later
// The table of keys that a scene may have.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "magicmass/scenes/scene.hpp"

namespace magicmass::scenes {

/// What the file has for a key, and the scene that is read.
struct Field {
  const toml::node& node;
  Scene& scene;
  const std::string& key;
};

struct Key {
  std::string name;
  void (*read)(const Field&);
  std::vector<Kind> kinds = {};            ///< that have it; none: all
  std::vector<std::string> excludes = {};  ///< keys that it does not go with
  std::string needs = {};                  ///< a key or an output that it does not go without
};

/// In the order in which they are read.
const std::vector<Key>& keys();

/// What is in a file, "-" for stdin. Throws InvalidInput where it cannot be read or has more bytes.
std::string text_of(const std::string& path, const std::string& allowed,
                    std::size_t longest = std::size_t{1} << 20U);
/// The text as TOML. Throws InvalidInput, "FILE:LINE: what; allowed: ...", for what is none.
toml::table table_of(std::string_view text, const std::string& source, const std::string& allowed);

/// Of the names the one that a misspelt one likely means: all but one or two neighbouring letters,
/// fewer than half, are the same; "" where there is none.
std::string nearest_name(const std::string& name, const std::vector<std::string>& names);

}  // namespace magicmass::scenes
