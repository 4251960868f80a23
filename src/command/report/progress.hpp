// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <string>

namespace magicmass::command {

/// One line on stderr that says what is being done, where stderr is a terminal, and whether Ctrl-C was pressed, which
/// while one of these lives asks for an early end instead of ending the program; pressed twice it ends it.
class Progress {
public:
  Progress();
  Progress(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress& operator=(Progress&&) = delete;
  ~Progress();

  /// Shows the step and the share of it done, 0 to 1, ten times a second at most. False after Ctrl-C.
  bool step(const std::string& words, double done);
  void clear();

  static bool was_interrupted();
  /// What Ctrl-C would have done: ends the program so that the shell sees an interrupt (130).
  [[noreturn]] static void end_as_interrupted();

private:
  bool is_shown_;
  std::chrono::steady_clock::time_point last_{};
  std::string last_words_;
};

}  // namespace magicmass::command
