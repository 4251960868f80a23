// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "command/part_file.hpp"

namespace magicmass::command {

/// The reader of stdout went away: nothing more to do, and no error.
class ClosedPipe : public std::exception {};

/// What the system says of a path, in one line: "PATH: File name too long".
std::string words_of(const std::filesystem::filesystem_error& error);

/// Whether -o with this path means stdout: "" (none was given) and "-" do.
bool is_stdout(const std::string& path);

/// Where data go: stdout, or a file that appears whole or not at all. It is written to a part file beside it
/// and renamed by finish(). What exists and is no regular file
/// (/dev/null, a pipe) is written directly.
class Destination {
public:
  /// Stdout for what is_stdout says so of. Throws InvalidInput where the path cannot be written.
  explicit Destination(const std::string& path);
  Destination(const Destination&) = delete;
  Destination(Destination&&) = delete;
  Destination& operator=(const Destination&) = delete;
  Destination& operator=(Destination&&) = delete;
  ~Destination();

  /// Throws InvalidInput when the system refuses, ClosedPipe when the reader of stdout is gone.
  void write(std::string_view text);
  /// Everything written so far becomes visible.
  void flush();
  /// Last call: the file gets its name.
  void finish();

  /// Colours are welcome: stdout, a terminal, and NO_COLOR not set.
  bool is_colourful() const;

private:
  std::string name_;              // for messages
  std::optional<PartFile> part_;  // of a regular file
  int descriptor_ = 1;            // stdout
  std::string buffer_;

  [[noreturn]] void refuse(int error) const;
};

}  // namespace magicmass::command
