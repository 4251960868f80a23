// SPDX-License-Identifier: GPL-2.0-or-later
// The commands behind `magicmass learn`, one function each.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "command/data_folder.hpp"
#include "command/exit_code.hpp"
#include "command/learn/catalogue.hpp"
#include "command/learn/judgement.hpp"
#include "command/learn/progress.hpp"
#include "command/records.hpp"

namespace magicmass::command {

struct LearnOptions {
  std::string content = data_folder("tutorials", "tutorials").string();
  std::string folder = "magicmass-exercises";
  std::string id;
  std::string answer;
  std::string kind = "symbolic", chapter;  // of a new exercise
  std::optional<std::uint64_t> seed;
  bool reveal = false;
  bool all = false;
  bool ascii = false;
  double seconds = 0;  // that watch goes on for; 0: until it is stopped
  OutputOptions output;
};

// For students.
ExitCode learn_list(const LearnOptions& options);
ExitCode learn_show(const LearnOptions& options);
ExitCode learn_check(const LearnOptions& options);
ExitCode learn_hint(const LearnOptions& options);
ExitCode learn_solution(const LearnOptions& options);
ExitCode learn_reset(const LearnOptions& options);
ExitCode learn_watch(const LearnOptions& options);

// For teachers.
ExitCode learn_new(const LearnOptions& options);
ExitCode learn_test(const LearnOptions& options);
ExitCode learn_grade(const LearnOptions& options);
ExitCode learn_export(const LearnOptions& options);

/// The student's folder with the seed that was asked for, if any.
StudentFolder student_folder(const LearnOptions& options);

/// The exercise as this student gets it.
Posed posed_to(const StudentFolder& student, const Exercise& exercise);

/// Judges, keeps the record, and says so: how it was read, right or wrong, why, a hint, and after success what it is
/// good for.
Judgement check_and_say(const Catalogue& catalogue, const Exercise& exercise,
                        StudentFolder& student, const std::string& answer,
                        const std::string& format, Destination& output,
                        const render::TextStyle& style);

/// The prompt as a page, and how to answer it.
std::string prompt_page(const Posed& posed, const StudentFolder& student,
                        const render::TextStyle& style);

/// The first that is not right yet, after `id` if that is given; nothing when all are.
const Exercise* next_exercise(const Catalogue& catalogue, const StudentFolder& student,
                              const std::string& id);

ExitCode exit_code_of(Judged verdict);

}  // namespace magicmass::command
