// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "command/leftover.hpp"

namespace magicmass::command {

/// A new folder among the temporary files, gone with the object, and with SIGINT, SIGTERM and SIGHUP.
/// Throws InvalidInput where none can be made.
class ScratchFolder {
public:
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
  std::filesystem::path path_;
  Leftover leftover_{Leftover::Kind::folder};  // path_
};

}  // namespace magicmass::command
