// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "command/learn/exercise_text.hpp"
#include "command/learn/expressions.hpp"
#include "command/learn/learn.hpp"
#include "command/learn/variant.hpp"
#include "command/terminal_style.hpp"
#include "equality/point.hpp"
#include "magicmass/errors.hpp"
#include "render/wrapping.hpp"

namespace magicmass::command {
namespace {

std::string mark_of(const Record& record) {
  if (record.verdict == "right") return record.has_seen_solution ? "[s]" : "[x]";
  return record.attempts > 0 ? "[.]" : "[ ]";
}

std::string list_page(const Catalogue& catalogue, const StudentFolder& student) {
  std::string page;
  std::string chapter;
  long right = 0;
  for (const Exercise& exercise : catalogue.exercises()) {
    const Record record = student.record(exercise.id);
    right += record.verdict == "right" ? 1 : 0;
    if (exercise.chapter != chapter) page += (page.empty() ? "" : "\n") + exercise.chapter + "\n";
    chapter = exercise.chapter;
    page += render::wrapped(
        exercise.title,
        fmt::format("{} {:<22} {:<8} {:<5} ", mark_of(record), exercise.id, name_of(exercise.kind),
                    std::string(static_cast<std::size_t>(exercise.difficulty), '*')));
  }
  const Exercise* next = next_exercise(catalogue, student, "");
  page += fmt::format("\n{} of {} right.", right, catalogue.exercises().size());
  return page + (next == nullptr ? "\n" : " Next: magicmass learn show " + next->id + "\n");
}

/// A path stands on a line of its own, so that it can be copied whole.
std::string how_to_answer(const Posed& posed, const StudentFolder& student) {
  const Exercise& exercise = posed.exercise;
  const std::string file = "\n    " + student.answer_of(exercise).string() + "\n";
  const std::string check = "magicmass learn check " + exercise.id;
  if (exercise.kind == ExerciseKind::code)
    return "Write your function in" + file + "and then: " + check + "\n";
  if (exercise.shape == Shape::derivation || exercise.shape == Shape::equations)
    return "Write one step a line in" + file + "and then: " + check + "\n";
  return "Answer: " + check + " \"YOUR ANSWER\"\nor write it in" + file;
}

std::string choices_page(const Posed& posed) {
  std::string page;
  for (std::size_t i = 0; i < posed.exercise.choices.size(); ++i)
    page += render::wrapped_sentences(posed.exercise.choices[i].text,
                                      fmt::format("  {}) ", static_cast<char>('a' + i)));
  return page.empty() ? page : "\n" + page;
}

/// The solution as a student would type it; of a prediction what the program found.
std::string solution_page(const Posed& posed) {
  const Exercise& exercise = posed.exercise;
  std::string text = posed.solution;
  if (exercise.kind == ExerciseKind::predict && exercise.choices.empty())
    text = equality::to_text(equality::at(
        {}, with_values(read_content(posed.solution, "solution/answer.txt"), posed.values)));
  for (std::size_t i = 0; i < exercise.choices.size(); ++i)
    if (text == std::string(1, static_cast<char>('a' + i))) text += ") " + exercise.choices[i].text;
  return text + (text.ends_with('\n') ? "\n" : "\n\n");
}

}  // namespace

std::string prompt_page(const Posed& posed, const StudentFolder& student,
                        const render::TextStyle& style) {
  const Exercise& exercise = posed.exercise;
  std::string page = exercise.title + "\n" + std::string(render::columns(exercise.title), '=') +
                     "\n\n" + page_of(text_of(exercise.folder / "prompt.md"), posed, style) +
                     choices_page(posed);
  if (!exercise.form.empty()) page += "\nForm asked for: " + exercise.form + ".\n";
  return page + "\n" + how_to_answer(posed, student);
}

ExitCode learn_list(const LearnOptions& options) {
  const Catalogue catalogue{std::filesystem::path(options.content)};
  const StudentFolder student(options.folder);
  Destination output(options.output.path);
  if (options.output.format == "text") {
    output.write(list_page(catalogue, student));
  } else {
    RecordWriter records(
        output, options.output.format,
        {"id", "chapter", "kind", "difficulty", "title", "verdict", "attempts", "hints"}, false);
    for (const Exercise& exercise : catalogue.exercises()) {
      const Record record = student.record(exercise.id);
      records.write({text_cell(exercise.id), text_cell(exercise.chapter),
                     text_cell(name_of(exercise.kind)),
                     number_cell(std::int64_t{exercise.difficulty}), text_cell(exercise.title),
                     text_cell(record.verdict), number_cell(std::int64_t{record.attempts}),
                     number_cell(std::int64_t{record.hints})});
    }
    records.finish();
  }
  output.finish();
  return ExitCode::done;
}

ExitCode learn_show(const LearnOptions& options) {
  const Catalogue catalogue{std::filesystem::path(options.content)};
  StudentFolder student = student_folder(options);
  const Exercise* exercise =
      options.id.empty() ? next_exercise(catalogue, student, "") : &catalogue.at(options.id);
  Destination output(options.output.path);
  if (exercise == nullptr) {
    output.write("All exercises are right.\n");
  } else {
    const Posed exercise_posed = posed_to(student, *exercise);
    student.begin(*exercise, prompt_page(exercise_posed, student, {}));
    student.save();
    output.write(prompt_page(exercise_posed, student, text_style(output, options.ascii)));
  }
  output.finish();
  return ExitCode::done;
}

ExitCode learn_hint(const LearnOptions& options) {
  const Catalogue catalogue{std::filesystem::path(options.content)};
  const Exercise& exercise = catalogue.at(options.id);
  StudentFolder student = student_folder(options);
  const Posed exercise_posed = posed_to(student, exercise);
  Record& record = student.record(exercise.id);
  const auto count = static_cast<long>(exercise.hints.size());
  record.hints = std::min(record.hints + 1, count);
  student.save();
  Destination output(options.output.path);
  output.write(render::wrapped_sentences(
      exercise_posed.exercise.hints[static_cast<std::size_t>(record.hints - 1)],
      fmt::format("Hint {} of {}: ", record.hints, count)));
  output.finish();
  return ExitCode::done;
}

ExitCode learn_solution(const LearnOptions& options) {
  const Catalogue catalogue{std::filesystem::path(options.content)};
  const Exercise& exercise = catalogue.at(options.id);
  StudentFolder student = student_folder(options);
  Record& record = student.record(exercise.id);
  if (record.attempts == 0 && !options.reveal)
    throw InvalidInput("the solution of " + exercise.id +
                       " is shown after an attempt, or with --reveal");
  const Posed exercise_posed = posed_to(student, exercise);
  record.has_seen_solution = record.has_seen_solution || record.verdict != "right";
  student.save();
  Destination output(options.output.path);
  output.write(solution_page(exercise_posed) + page_of(text_of(exercise.folder / "after.md"),
                                                       exercise_posed,
                                                       text_style(output, options.ascii)));
  output.finish();
  return ExitCode::done;
}

ExitCode learn_reset(const LearnOptions& options) {
  const Catalogue catalogue{std::filesystem::path(options.content)};
  StudentFolder student = student_folder(options);
  if (options.id.empty() && !options.all)
    throw InvalidInput("reset needs an exercise, or --all; your answers there are lost");
  for (const Exercise& exercise : catalogue.exercises()) {
    if (!options.all && exercise.id != catalogue.at(options.id).id) continue;
    student.forget(exercise.id);
    if (std::filesystem::exists(student.answer_of(exercise))) student.restart(exercise);
  }
  student.save();
  return ExitCode::done;
}

}  // namespace magicmass::command
