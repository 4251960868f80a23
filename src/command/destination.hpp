// SPDX-License-Identifier: GPL-2.0-or-later
// Where an answer goes.
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <string_view>

namespace command {

/// The reader of stdout went away: nothing more to do, and not an error.
class ClosedPipe : public std::exception {};

/// Stdout, or a file that appears whole or not at all: it has no name until finish(), where the
/// file system allows that, and else one of its own. A symbolic link stays one, a file that is
/// replaced leaves its mode behind; devices, pipes and open descriptors (/dev/stdout) are written
/// directly. Throws answers::InvalidInput where the system refuses.
class Destination {
public:
  /// "" and "-" are stdout. Calls before_writing before anything is seen on it.
  Destination(const std::string& path, std::function<void()> before_writing);
  Destination(const Destination&) = delete;
  Destination& operator=(const Destination&) = delete;
  ~Destination();

  /// Throws ClosedPipe, too.
  void write(std::string_view text);
  /// What was written goes on its way.
  void flush();
  /// Last call: what was written is there, under its name.
  void finish();

private:
  std::string shown_;   // for messages
  std::string target_;  // of an atomic file, behind links; else ""
  std::string name_;    // that the atomic file has for the time being; else ""
  int descriptor_;
  std::string buffer_;
  std::function<void()> before_writing_;

  void open_atomic();
  [[noreturn]] void refuse(int error) const;
};

}  // namespace command
