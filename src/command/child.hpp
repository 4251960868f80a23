// SPDX-License-Identifier: GPL-2.0-or-later
// Another program, its input and output in memory, its files in a folder for the time being.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace command {

struct Said {
  bool is_done;  ///< exit code 0
  std::string output;
  std::string errors;
};
/// What the program words[0] says; nothing where it is not installed. It ends where this one does.
std::optional<Said> said_by(std::vector<std::string> words, const std::string& input = "");

/// A folder that goes with all that is in it, however this process ends: another one waits for
/// that, and for the programs that were run meanwhile.
class TemporaryFolder {
public:
  /// Throws std::runtime_error after `name` where the system refuses.
  explicit TemporaryFolder(const std::string& name);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string path;

private:
  int alive_ = -1;  // the end of a pipe that is closed with the last process that has it
  int cleaner_ = -1;
};

}  // namespace command
