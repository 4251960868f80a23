// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "command/learn/exercise.hpp"

namespace magicmass::command {

/// Whether an exercise, or its chapter, may be called that: up to 30 small letters, digits and _.
bool is_id(const std::string& text);

/// The exercises in the order of the course: by chapter, difficulty and id.
class Catalogue {
public:
  /// All of `content`/CHAPTER/exercises/ID. Throws InvalidInput for a folder without them, and for a bad file.
  explicit Catalogue(const std::filesystem::path& content);

  const std::vector<Exercise>& exercises() const { return exercises_; }
  std::vector<std::string> ids() const;
  /// Throws InvalidInput with the nearest id.
  const Exercise& at(const std::string& id) const;

private:
  std::vector<Exercise> exercises_;
};

}  // namespace magicmass::command
