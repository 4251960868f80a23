// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/printed.hpp"

namespace magicmass::course {

/// A chapter as it is written, and what its program printed just now.
struct Chapter {
  std::filesystem::path folder;  // "tutorials/05_counting"
  std::string name;              // "05_counting"
  std::string title;             // the first line of intro.md, without "# "
  std::string text;              // the rest of it
  std::string program;           // tutorial.cpp, without its licence line
  std::vector<Printed> printed;

  std::string file(const std::string& of) const { return name + "/" + of; }
};

/// The sections that every chapter has, in this order.
const std::vector<std::string>& section_titles();

/// Reads a folder with intro.md and tutorial.cpp and runs its program. Throws Refusal where the output is not what
/// expected_output.txt says, or the sections are not those above.
Chapter load_chapter(const std::filesystem::path& folder,
                     const std::filesystem::path& program);

/// The folders with an intro.md, in order.
std::vector<std::filesystem::path> chapter_folders(
    const std::filesystem::path& tutorials);

/// An exercise's title, and the name that `magicmass learn` knows it by: from its exercise.toml, the easiest first.
struct Exercise {
  std::string id;
  std::string title;
};
std::vector<Exercise> exercises(const std::filesystem::path& chapter);

}  // namespace magicmass::course
