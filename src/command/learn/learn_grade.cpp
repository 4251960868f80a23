// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <iostream>
#include <system_error>

#include "command/learn/learn.hpp"
#include "command/learn/variant.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> students_of(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> students;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_directory()) students.push_back(entry.path());
  if (error || students.empty())
    throw InvalidInput(shown_text(folder, 300) +
                       ": no students there; a folder with a folder "
                       "for each student is expected");
  std::sort(students.begin(), students.end());
  return students;
}

/// The verdict on what is in the student's file now: progress.txt is theirs to edit, so it is not believed.
std::string verdict_on(const StudentFolder& student, const Exercise& exercise) {
  if (!fs::exists(student.answer_of(exercise))) return "missing";
  const std::string answer = text_of(student.answer_of(exercise));
  if (answer == text_of(exercise.folder / exercise.answer_file())) return "missing";
  return name_of(judge(posed_to(student, exercise), answer, {}).verdict);
}

}  // namespace

ExitCode learn_grade(const LearnOptions& options) {
  const Catalogue catalogue{fs::path(options.content)};
  const std::vector<fs::path> students = students_of(options.folder);
  Destination output(options.output.path);
  std::vector<std::string> columns{"student", "right", "of"};
  for (const std::string& id : catalogue.ids()) columns.push_back(id);
  RecordWriter records(output, options.output.format, columns, false);
  for (const fs::path& path : students) {
    const fs::path inner = path / "magicmass-exercises";
    std::vector<Cell> verdicts;
    std::int64_t right = 0;
    const auto leave_unread = [&](const std::string& why) {
      std::cerr << "magicmass: " + shown_text(why, 1000) + "\n";
      verdicts.resize(catalogue.exercises().size(), text_cell("unread"));
    };
    try {
      const StudentFolder student(fs::exists(inner) ? inner : path);
      for (const Exercise& exercise : catalogue.exercises()) {
        const std::string verdict = verdict_on(student, exercise);
        right += verdict == "right" ? 1 : 0;
        verdicts.push_back(text_cell(verdict));
      }
    } catch (const InvalidInput& error) {
      leave_unread(error.what());
    } catch (const fs::filesystem_error& error) {
      leave_unread(words_of(error));
    }
    verdicts.insert(verdicts.begin(),
                    {text_cell(path.filename().string()), number_cell(right),
                     number_cell(static_cast<std::int64_t>(catalogue.exercises().size()))});
    records.write(verdicts);
    output.flush();
  }
  records.finish();
  output.finish();
  return ExitCode::done;
}

}  // namespace magicmass::command
