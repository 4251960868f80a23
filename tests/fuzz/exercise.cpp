// SPDX-License-Identifier: GPL-2.0-or-later
// The two files of an exercise, exercise.toml and misconceptions.toml, parted by a zero byte.
#include "command/learn/exercise.hpp"

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "command/learn/variant.hpp"
#include "fuzz_target.hpp"
#include "magicmass/errors.hpp"

namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path top = fs::temp_directory_path() / ("magicmass_fuzz_" + std::to_string(getpid()));
  fs::path path = top / "chapter/exercises/id";

  Folder() { fs::create_directories(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(top); }

  void write(const char* name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }
};

/// The value of `key = "..."` becomes the folder's, which it must be.
std::string with(std::string text, const std::string& key, const std::string& value) {
  const std::size_t begin = text.find(key + " = \"");
  if (begin == std::string::npos) return text;
  const std::size_t quote = begin + key.size() + 4;
  const std::size_t end = text.find('"', quote);
  return end == std::string::npos ? text : text.replace(quote, end - quote, value);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace magicmass;
  static const Folder folder;
  const std::string both = fuzz::text_of(data, size);
  const std::size_t zero = both.find('\0');
  folder.write("exercise.toml", with(with(both.substr(0, zero), "id", "id"), "chapter", "chapter"));
  folder.write("misconceptions.toml", zero == std::string::npos ? "" : both.substr(zero + 1));
  try {
    const command::Exercise exercise = command::read_exercise(folder.path);
    for (const std::uint64_t seed : {0ULL, 12345ULL, ~0ULL}) {
      const command::Values variant = command::variant_of(exercise, seed);
      for (const auto& [name, range] : exercise.ranges) {
        const long drawn = std::stol(variant.at(name));
        fuzz::require(range.first <= drawn && drawn <= range.second, "drawn out of range");
      }
      command::filled(exercise, variant);
    }
  } catch (const InvalidInput& refusal) {
    fuzz::require_one_line(refusal);
  }
  return 0;
}
