// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/data_folder.hpp"

#include <system_error>

namespace magicmass::command {

std::filesystem::path data_folder(const char* installed, const char* in_sources) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto folder = program.parent_path().parent_path() / "share" / "magicmass" / installed;
  if (!error && std::filesystem::is_directory(folder, error)) return folder;
  return std::filesystem::path(MAGICMASS_SOURCE_DIR) / in_sources;
}

}  // namespace magicmass::command
