// SPDX-License-Identifier: GPL-2.0-or-later
// A folder of generated files: comparing it with what would be generated, and writing it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "codegen/generate.hpp"

namespace magicmass::command {

/// Paths below the folder, sorted.
struct TreeDifference {
  std::vector<std::string> missing;    ///< would be generated, not there
  std::vector<std::string> different;  ///< there, with other bytes
  std::vector<std::string> extra;      ///< *.hpp or *.json there, would not be generated

  bool is_stale() const { return !missing.empty() || !different.empty() || !extra.empty(); }
};

TreeDifference compare_tree(const std::filesystem::path& folder,
                            const std::vector<codegen::GeneratedFile>& files);

/// Writes the files that are missing or different, each to a temporary beside it first and all renamed at the end;
/// what is up to date is not touched. Throws InvalidInput, before any file has changed, where it cannot write.
void write_tree(const std::filesystem::path& folder,
                const std::vector<codegen::GeneratedFile>& files);

/// The folder generated/ that this program was installed or built with.
std::filesystem::path source_generated_folder();

}  // namespace magicmass::command
