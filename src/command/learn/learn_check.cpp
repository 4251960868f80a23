// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <iostream>

#include <fmt/format.h>

#include "command/learn/exercise_text.hpp"
#include "command/learn/learn.hpp"
#include "command/learn/own_answer.hpp"
#include "command/learn/variant.hpp"
#include "command/terminal_style.hpp"
#include "magicmass/errors.hpp"
#include "render/wrapping.hpp"

namespace magicmass::command {
namespace {

std::string coloured(const std::string& text, const char* code, const render::TextStyle& style) {
  return style.colourful ? "\x1b[" + std::string(code) + "m" + text + "\x1b[0m" : text;
}

std::string explanation_lines(const std::string& text) {
  std::string lines;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines += render::wrapped_sentences(text.substr(at, end - at), "  ");
    at = end + 1;
  }
  return lines;
}

/// A hint is worth more the more often one has tried.
std::string hint_for(const Posed& posed, const Record& record, const Judgement& judgement) {
  if (judgement.verdict != Judged::wrong) return {};
  const auto last = static_cast<long>(posed.exercise.hints.size()) - 1;
  const long which = std::clamp<long>(record.attempts - 1, 0, last);
  return posed.exercise.hints[static_cast<std::size_t>(which)];
}

std::string after_success(const Posed& posed, const render::TextStyle& style) {
  std::string page;
  const Exercise& exercise = posed.exercise;
  if (exercise.kind == ExerciseKind::predict)
    page += "\n" + own_answer(exercise.run, "text", exercise.folder, posed.variant);
  return page + "\n" + page_of(text_of(exercise.folder / "after.md"), posed, style);
}

std::string page(const Catalogue& catalogue, const Posed& posed, const StudentFolder& student,
                 const Judgement& judgement, const render::TextStyle& style) {
  std::string text;
  for (std::size_t i = 0; i < judgement.read_as.size(); ++i)
    text += render::wrapped(judgement.read_as[i], i == 0 ? "Read as: " : "         ");
  const bool is_right = judgement.verdict == Judged::right;
  const std::string said = render::wrapped_sentences(judgement.said, "");
  text += coloured(said.substr(0, said.size() - 1), is_right ? "1;32" : "1;31", style) + "\n";
  if (judgement.verdict == Judged::unread && posed.exercise.kind == ExerciseKind::code)
    text += judgement.explanation + "\n";  // what a compiler says stays in its lines
  else
    text += explanation_lines(judgement.explanation);
  const std::string hint = hint_for(posed, student.record(posed.exercise.id), judgement);
  if (!hint.empty()) text += render::wrapped_sentences(hint, "A hint: ");
  if (!is_right) return text;
  text += after_success(posed, style);
  const Exercise* next = next_exercise(catalogue, student, posed.exercise.id);
  text += next == nullptr ? "\nThat was the last one: all are right.\n"
                          : "\nNext: magicmass learn show " + next->id + "\n";
  return text;
}

std::string json(const Posed& posed, const StudentFolder& student, const Judgement& judgement) {
  std::string feedback = judgement.said;
  if (!judgement.explanation.empty()) feedback += " " + judgement.explanation;
  const std::string hint = hint_for(posed, student.record(posed.exercise.id), judgement);
  if (!hint.empty()) feedback += " A hint: " + hint;
  const auto optional = [](const std::string& text) {
    return text.empty() ? missing_cell() : text_cell(text);
  };
  return json_object({"id", "verdict", "feedback", "read_as", "misconception"},
                     {text_cell(posed.exercise.id), text_cell(name_of(judgement.verdict)),
                      text_cell(feedback), Cell{json_array(judgement.read_as)},
                      optional(judgement.misconception)}) +
         "\n";
}

/// "-" is what is on stdin, no more of it than could be an answer.
std::string from_stdin() {
  std::string text;
  std::array<char, 4096> buffer{};
  while (text.size() < 200000) {
    std::cin.read(buffer.data(), buffer.size());
    text.append(buffer.data(), static_cast<std::size_t>(std::cin.gcount()));
    if (!std::cin) break;
  }
  return text;
}

/// An answer from the command line goes into the student's file, for the teacher to find, but not over work.
bool is_worth_keeping(const StudentFolder& student, const Exercise& exercise,
                      const Judgement& judgement) {
  if (judgement.verdict == Judged::unread) return false;
  if (judgement.verdict == Judged::right && exercise.kind != ExerciseKind::code) return true;
  const std::filesystem::path file = student.answer_of(exercise);
  return !std::filesystem::exists(file) ||
         text_of(file) == text_of(exercise.folder / exercise.answer_file());
}

/// What an answer without an id is for: the exercise that `learn show` shows.
const Exercise& answered_without_id(const Catalogue& catalogue, const StudentFolder& student,
                                    const std::string& answer) {
  const Exercise* next = next_exercise(catalogue, student, "");
  return next == nullptr ? catalogue.at(answer) : *next;
}

}  // namespace

ExitCode exit_code_of(Judged verdict) {
  if (verdict == Judged::right) return ExitCode::done;
  if (verdict == Judged::undecided) return ExitCode::undecided;
  return verdict == Judged::unread ? ExitCode::bad_input : ExitCode::check_failed;
}

StudentFolder student_folder(const LearnOptions& options) {
  StudentFolder student(options.folder);
  if (options.seed) student.set_seed(*options.seed);
  return student;
}

Posed posed_to(const StudentFolder& student, const Exercise& exercise) {
  return posed(exercise, variant_of(exercise, student.seed()));
}

const Exercise* next_exercise(const Catalogue& catalogue, const StudentFolder& student,
                              const std::string& id) {
  const auto& all = catalogue.exercises();
  const auto start =
      std::find_if(all.begin(), all.end(), [&](const Exercise& one) { return one.id == id; });
  const std::size_t first = start == all.end() ? 0 : static_cast<std::size_t>(start - all.begin());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Exercise& one = all[(first + i) % all.size()];
    if (student.record(one.id).verdict != "right") return &one;
  }
  return nullptr;
}

Judgement check_and_say(const Catalogue& catalogue, const Exercise& exercise,
                        StudentFolder& student, const std::string& answer,
                        const std::string& format, Destination& output,
                        const render::TextStyle& style) {
  const Posed exercise_posed = posed_to(student, exercise);
  const Judgement judgement = judge(exercise_posed, answer, style);
  if (judgement.verdict != Judged::unread) {
    Record& record = student.record(exercise.id);
    ++record.attempts;
    if (record.verdict != "right") record.verdict = name_of(judgement.verdict);
    student.save();
  }
  output.write(format == "json" ? json(exercise_posed, student, judgement)
                                : page(catalogue, exercise_posed, student, judgement, style));
  output.flush();
  return judgement;
}

ExitCode learn_check(const LearnOptions& options) {
  const Catalogue catalogue{std::filesystem::path(options.content)};
  StudentFolder student = student_folder(options);
  const bool is_for_next = options.answer.empty() && !options.id.empty() && !is_id(options.id);
  const Exercise& exercise =
      is_for_next ? answered_without_id(catalogue, student, options.id) : catalogue.at(options.id);
  std::string answer = is_for_next ? options.id : options.answer;
  if (answer == "-") {
    answer = from_stdin();
  } else if (answer.empty() || exercise.kind == ExerciseKind::code) {
    const std::filesystem::path file =
        answer.empty() ? student.answer_of(exercise) : std::filesystem::path(answer);
    if (!std::filesystem::exists(file))
      throw InvalidInput(fmt::format(
          "no answer: {} is not there; magicmass learn show {} puts a starter there, or give the "
          "answer as an argument",
          file.string(), exercise.id));
    answer = text_of(file);
  }
  Destination output(options.output.path);
  if (is_for_next && options.output.format == "text")
    output.write("Exercise " + exercise.id + ":\n");
  const Judgement judgement =
      check_and_say(catalogue, exercise, student, answer, options.output.format, output,
                    text_style(output, options.ascii));
  const bool is_from_a_file = options.answer.empty() && !is_for_next;
  if (!is_from_a_file && is_worth_keeping(student, exercise, judgement))
    student.keep(exercise, answer);
  output.finish();
  return exit_code_of(judgement.verdict);
}

}  // namespace magicmass::command
