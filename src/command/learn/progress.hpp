// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "command/learn/exercise.hpp"

namespace magicmass::command {

/// What a student did with one exercise.
struct Record {
  std::string verdict = "open";  ///< right once it was, else of the last attempt: wrong, ...
  long attempts = 0;
  long hints = 0;
  bool has_seen_solution = false;

  bool operator==(const Record&) const = default;
};

/// The student's folder: CHAPTER/ID/ with prompt.txt and an answer file for each exercise begun, and progress.txt,
/// the only state there is. Nothing is written before something is to be kept.
class StudentFolder {
public:
  /// Reads progress.txt if it is there. Throws InvalidInput: "progress.txt: line 3: ...".
  explicit StudentFolder(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t seed() const { return seed_; }
  void set_seed(std::uint64_t seed) { seed_ = seed; }
  Record& record(const std::string& id) { return records_[id]; }
  Record record(const std::string& id) const;
  void forget(const std::string& id) { records_.erase(id); }

  std::filesystem::path folder_of(const Exercise& exercise) const;
  std::filesystem::path answer_of(const Exercise& exercise) const;
  /// Puts prompt and starter there, unless they are. Returns whether they were not.
  bool begin(const Exercise& exercise, const std::string& prompt) const;
  /// Puts the starter in place of the answer.
  void restart(const Exercise& exercise) const;
  /// Keeps an answer that was typed elsewhere in the answer file.
  void keep(const Exercise& exercise, const std::string& answer) const;
  /// Writes progress.txt, whole or not at all. What others have saved since it was read is kept beside what is new.
  void save();

private:
  using Records = std::map<std::string, Record>;

  std::filesystem::path path_;
  std::uint64_t seed_ = 0;
  Records records_;
  std::uint64_t seed_read_ = 0;
  Records records_read_;

  void add_to(StudentFolder& others) const;
};

}  // namespace magicmass::command
