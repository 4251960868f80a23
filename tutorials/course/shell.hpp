// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace magicmass::course {

struct Ran {
  int status = 0;      // exit code; -1 where a signal ended it
  std::string output;  // stdout
};

/// A line of shell, run to its end.
Ran run(const std::string& line);

/// A word of such a line.
std::string quoted(const std::string& word);

/// A program of that name can be run.
bool is_installed(const std::string& program);

/// Throws Refusal where the file cannot be read, or written.
std::string read(const std::filesystem::path& file);
void write(const std::filesystem::path& file, const std::string& text);

}  // namespace magicmass::course
