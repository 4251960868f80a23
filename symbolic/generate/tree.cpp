#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "generate/quantities.hpp"

namespace generate {
namespace {
namespace fs = std::filesystem;

/// Beside `path`, a name that nobody has.
fs::path free_name(const fs::path& path) {
  for (int i = 0;; ++i) {
    fs::path name = path;
    name += ".new-" + std::to_string(i);
    if (!fs::exists(fs::symlink_status(name))) return name;
  }
}
}  // namespace

void write(const std::string& folder, const Texts& texts) {
  std::vector<std::pair<fs::path, fs::path>> renames;
  try {
    for (const auto& [path, text] : texts) {
      const fs::path place = fs::path(folder) / path;
      fs::create_directories(place.parent_path());
      renames.emplace_back(free_name(place), place);
      std::ofstream file(renames.back().first, std::ios::binary);
      file << text;
      file.close();
      if (!file) throw std::runtime_error(place.string() + ": cannot be written");
    }
    for (const auto& [beside, place] : renames) fs::rename(beside, place);
  } catch (const std::exception& problem) {
    std::error_code ignored;
    for (const auto& [beside, place] : renames) fs::remove(beside, ignored);
    throw std::runtime_error(problem.what());
  }
}
std::vector<std::string> differences(const std::string& folder, const Texts& texts) {
  std::vector<std::string> out;
  for (const auto& [path, text] : texts) {
    std::ifstream file(fs::path(folder) / path, std::ios::binary);
    if (!file)
      out.push_back(path + ": is not there");
    else if (text != std::string{std::istreambuf_iterator<char>(file), {}})
      out.push_back(path + ": differs");
  }
  if (!fs::is_directory(folder)) return out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = fs::relative(entry.path(), folder).generic_string();
    const bool ours = texts.count(path) > 0 || path == "CMakeLists.txt" || path == ".clang-format";
    if (entry.is_regular_file() && !ours) out.push_back(path + ": is not generated");
  }
  return out;
}
}  // namespace generate
