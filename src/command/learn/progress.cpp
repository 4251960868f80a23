// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/progress.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>

#include "command/descriptor.hpp"
#include "command/destination.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

namespace fs = std::filesystem;

const char* const heading =
    "# magicmass learn: exercise, verdict, attempts, hints, solution seen (0 or 1)\n";

void write_whole(const fs::path& file, const std::string& text) {
  Destination destination(file.string());
  destination.write(text);
  destination.finish();
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw InvalidInput("cannot make the folder " + shown_text(folder.string(), 300) + ": " +
                       error.message() + "; --folder names another");
}

Record read_record(std::istringstream& line) {
  static const std::array<std::string, 5> verdicts{"open", "wrong", "undecided", "form", "right"};
  Record record;
  int seen = -1;
  std::string rest;
  line >> record.verdict >> record.attempts >> record.hints >> seen;
  const bool is_good =
      !line.fail() && !(line >> rest) && record.attempts >= 0 && record.hints >= 0 &&
      record.hints <= 3 && (seen == 0 || seen == 1) &&
      std::find(verdicts.begin(), verdicts.end(), record.verdict) != verdicts.end();
  if (!is_good) throw std::invalid_argument("record");
  record.has_seen_solution = seen == 1;
  return record;
}

}  // namespace

StudentFolder::StudentFolder(fs::path path) : path_(std::move(path)) {
  const fs::path file = path_ / "progress.txt";
  if (!fs::exists(file)) return;
  std::istringstream lines(text_of(file));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string first;
    if (!(words >> first) || first.starts_with('#')) continue;
    try {
      if (first == "seed") {
        if (!(words >> seed_)) throw std::invalid_argument("seed");
      } else {
        records_[first] = read_record(words);
      }
    } catch (const std::invalid_argument&) {
      throw InvalidInput(shown_text(file.string(), 300) + ": line " + std::to_string(number) +
                         ": " + shown_text(line) +
                         "; allowed: seed 7, or an exercise with open, wrong, undecided, form or "
                         "right and three numbers: first_contact right 2 1 0");
    }
  }
  seed_read_ = seed_;
  records_read_ = records_;
}

Record StudentFolder::record(const std::string& id) const {
  const auto found = records_.find(id);
  return found == records_.end() ? Record{} : found->second;
}

fs::path StudentFolder::folder_of(const Exercise& exercise) const {
  return path_ / exercise.chapter / exercise.id;
}

fs::path StudentFolder::answer_of(const Exercise& exercise) const {
  return folder_of(exercise) / exercise.answer_file();
}

bool StudentFolder::begin(const Exercise& exercise, const std::string& prompt) const {
  const fs::path folder = folder_of(exercise);
  if (fs::exists(folder / exercise.answer_file())) return false;
  make_folder(folder);
  write_whole(folder / "prompt.txt", prompt);
  restart(exercise);
  return true;
}

void StudentFolder::restart(const Exercise& exercise) const {
  make_folder(folder_of(exercise));
  write_whole(answer_of(exercise), text_of(exercise.folder / exercise.answer_file()));
}

void StudentFolder::keep(const Exercise& exercise, const std::string& answer) const {
  make_folder(folder_of(exercise));
  write_whole(answer_of(exercise), answer.ends_with('\n') ? answer : answer + "\n");
}

/// What was done since it was read.
void StudentFolder::add_to(StudentFolder& others) const {
  if (seed_ != seed_read_) others.seed_ = seed_;
  for (const auto& [id, before] : records_read_)
    if (!records_.contains(id)) others.forget(id);
  for (const auto& [id, mine] : records_) {
    const auto found = records_read_.find(id);
    const Record before = found == records_read_.end() ? Record{} : found->second;
    if (mine == before) continue;
    Record& record = others.record(id);
    if (record.verdict != "right" && mine.attempts != before.attempts)
      record.verdict = mine.verdict;
    record.attempts += mine.attempts - before.attempts;
    record.hints = std::max(record.hints, mine.hints);
    record.has_seen_solution = record.has_seen_solution || mine.has_seen_solution;
  }
}

void StudentFolder::save() {
  make_folder(path_);
  const Descriptor turn(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  ::flock(turn.number(), LOCK_EX);  // others wait; on a file system without locks nobody does
  StudentFolder now(path_);
  add_to(now);
  std::string text = heading;
  text += "seed " + std::to_string(now.seed_) + "\n";
  for (const auto& [id, record] : now.records_) {
    text += id + " " + record.verdict + " " + std::to_string(record.attempts) + " " +
            std::to_string(record.hints) + (record.has_seen_solution ? " 1\n" : " 0\n");
  }
  write_whole(path_ / "progress.txt", text);
  records_read_ = records_;
  seed_read_ = seed_;
}

}  // namespace magicmass::command
