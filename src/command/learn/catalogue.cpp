// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/catalogue.hpp"

#include <algorithm>
#include <system_error>
#include <tuple>

#include "command/nearest_name.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {

bool is_id(const std::string& text) {
  return !text.empty() && text.size() <= 30 && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

Catalogue::Catalogue(const std::filesystem::path& content) {
  namespace fs = std::filesystem;
  std::error_code error;
  for (const auto& chapter : fs::directory_iterator(content, error)) {
    std::error_code none;
    for (const auto& folder : fs::directory_iterator(chapter.path() / "exercises", none))
      if (fs::is_regular_file(folder.path() / "exercise.toml"))
        exercises_.push_back(read_exercise(folder.path()));
  }
  if (exercises_.empty())
    throw InvalidInput(shown_text(content.string(), 300) +
                       ": no exercises there; a folder with CHAPTER/exercises/ID/exercise.toml is "
                       "expected");
  const auto place = [](const Exercise& exercise) {
    return std::tie(exercise.chapter, exercise.difficulty, exercise.id);
  };
  std::sort(exercises_.begin(), exercises_.end(),
            [&](const Exercise& x, const Exercise& y) { return place(x) < place(y); });
  for (std::size_t i = 0; i < exercises_.size(); ++i)
    for (std::size_t k = i + 1; k < exercises_.size(); ++k)
      if (exercises_[i].id == exercises_[k].id)
        throw InvalidInput(exercises_[k].folder.string() + ": the id " + exercises_[k].id +
                           " is taken by " + exercises_[i].folder.string());
}

std::vector<std::string> Catalogue::ids() const {
  std::vector<std::string> ids;
  for (const Exercise& exercise : exercises_) ids.push_back(exercise.id);
  return ids;
}

const Exercise& Catalogue::at(const std::string& id) const {
  const auto found = std::find_if(exercises_.begin(), exercises_.end(),
                                  [&](const Exercise& exercise) { return exercise.id == id; });
  if (found == exercises_.end())
    throw InvalidInput("no exercise is called \"" + shown_text(id) + "\"; did you mean " +
                       nearest_name(id, ids()) + "? magicmass learn list shows all");
  return *found;
}

}  // namespace magicmass::command
