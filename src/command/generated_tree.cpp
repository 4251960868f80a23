// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/generated_tree.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <system_error>

#include "command/data_folder.hpp"
#include "command/destination.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> content_of(const fs::path& path) {
  std::error_code error;
  std::ifstream file(path, std::ios::binary);
  if (!file.is_open() || !fs::is_regular_file(path, error)) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::vector<std::string> generated_kind_of_files(const fs::path& folder) {
  std::vector<std::string> found;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string extension = entry->path().extension().string();
    if (entry->is_regular_file(error) && (extension == ".hpp" || extension == ".json"))
      found.push_back(entry->path().lexically_relative(folder).generic_string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

TreeDifference compare_tree(const fs::path& folder,
                            const std::vector<codegen::GeneratedFile>& files) {
  TreeDifference difference;
  std::set<std::string> expected;
  for (const codegen::GeneratedFile& file : files) {
    expected.insert(file.path);
    const std::optional<std::string> content = content_of(folder / file.path);
    if (!content)
      difference.missing.push_back(file.path);
    else if (*content != file.content)
      difference.different.push_back(file.path);
  }
  for (const std::string& path : generated_kind_of_files(folder))
    if (!expected.contains(path)) difference.extra.push_back(path);
  return difference;
}

void write_tree(const fs::path& folder, const std::vector<codegen::GeneratedFile>& files) {
  std::vector<std::unique_ptr<Destination>> outputs;
  for (const codegen::GeneratedFile& file : files) {
    const fs::path path = folder / file.path;
    if (content_of(path) == file.content) continue;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error)
      throw InvalidInput("cannot write " + shown_text(path.string(), 200) + ": " + error.message());
    outputs.push_back(std::make_unique<Destination>(path.string()));
    outputs.back()->write(file.content);
    outputs.back()->flush();
  }
  for (const std::unique_ptr<Destination>& output : outputs) output->finish();
}

fs::path source_generated_folder() { return data_folder("generated", "generated"); }

}  // namespace magicmass::command
