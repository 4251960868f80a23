// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace magicmass::command {

/// A program that is asked a line at a time. It ends with the object.
class Subprocess {
public:
  explicit Subprocess(std::vector<std::string> words);
  Subprocess(const Subprocess&) = delete;
  Subprocess(Subprocess&&) = delete;
  Subprocess& operator=(const Subprocess&) = delete;
  Subprocess& operator=(Subprocess&&) = delete;
  ~Subprocess();

  /// Sends a line, unless it is empty, and returns the next line that comes; empty when the program has ended.
  std::string ask(const std::string& line);

private:
  pid_t child_ = -1;
  int to_ = -1, from_ = -1;
  std::string received_;
};

}  // namespace magicmass::command
