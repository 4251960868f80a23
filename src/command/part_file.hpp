// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "command/leftover.hpp"

namespace magicmass::command {

/// A file beside its target, TARGET.part-1 (part-2 while that is being written by somebody else), that becomes the
/// target or is removed: by its destructor, and by SIGINT, SIGTERM and SIGHUP. One that a killed program left has no
/// lock, and is taken over by the next to write the same target.
class PartFile {
public:
  /// Empty and locked. Throws std::system_error.
  explicit PartFile(const std::string& target);
  PartFile(const PartFile&) = delete;
  PartFile(PartFile&&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  PartFile& operator=(PartFile&&) = delete;
  ~PartFile();

  int descriptor() const { return descriptor_; }
  /// Under the target's name from now on, in place of what was there. Throws std::system_error.
  void become_target();

private:
  std::string target_;
  std::string name_;  // empty once it is the target
  int descriptor_ = -1;
  Leftover leftover_{Leftover::Kind::file};  // name_

  bool take(int number);
};

}  // namespace magicmass::command
