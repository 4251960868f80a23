// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/content_test.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

#include <fmt/format.h>

#include "command/learn/exercise_text.hpp"
#include "command/learn/expressions.hpp"
#include "command/learn/learn.hpp"
#include "command/learn/variant.hpp"
#include "command/records.hpp"
#include "equality/paper_names.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::command {
namespace {

constexpr std::uint64_t seeds_tried = 3;  // of ranges, which may be large

class Examination {
public:
  Examination(const Exercise& exercise, ProvedContent& proved)
      : exercise_(exercise), proved_(proved) {}

  ContentReport report() {
    const std::uint64_t most = std::max<std::uint64_t>(exercise_.variants.size(),
                                                       exercise_.ranges.empty() ? 1 : seeds_tried);
    std::set<std::string> seen;
    for (std::uint64_t seed = 0; seed < most; ++seed) {
      const Values variant = variant_of(exercise_, seed);
      if (!seen.insert(shown_variant(variant)).second) continue;
      ++report_.variants;
      place_ = variant.empty() ? "" : "with " + shown_variant(variant) + ": ";
      try {
        examine(posed(exercise_, variant));
      } catch (const std::exception& error) {
        fail(error.what());
      }
    }
    return report_;
  }

private:
  void fail(const std::string& what) { report_.failures.push_back(place_ + what); }

  Judgement judged(const Posed& posed, const std::string& answer) {
    ++report_.answers;
    return judge(posed, answer, {});
  }

  void examine(const Posed& posed) {
    const std::string starter = text_of(exercise_.folder / exercise_.answer_file());
    if (judged(posed, starter).verdict == Judged::right) fail("the starter is right already");
    expect(posed, posed.solution, Judged::right, "the solution");
    for (const std::string& theorem_complaint : theorem_complaints(posed)) fail(theorem_complaint);
    for (const Misconception& one : posed.exercise.misconceptions) examine(posed, one);
    for (const std::string& answer : posed.exercise.right)
      expect(posed, filled(answer, posed.values), Judged::right, "right answer " + answer);
    for (const std::string& answer : posed.exercise.other_form)
      expect(posed, filled(answer, posed.values), Judged::form, "answer in another form " + answer);
    for (const std::string& answer : posed.exercise.wrong)
      expect(posed, filled(answer, posed.values), Judged::wrong, "wrong answer " + answer);
    for (const char* file : {"prompt.md", "after.md"}) {
      const std::string text = text_of(exercise_.folder / file);
      if (!is_utf8(text)) fail(std::string(file) + ": not UTF-8");
      for (const std::string& complaint : complaints_about(text, posed))
        fail(std::string(file) + ": " + complaint);
    }
    if (posed.exercise.kind == ExerciseKind::predict && !posed.exercise.choices.empty())
      require_one_choice(posed);
    if (posed.exercise.kind == ExerciseKind::predict && posed.exercise.choices.empty())
      require_law(posed);
  }

  /// What is more than one field of the program's answer is typed, and must be held against something.
  void require_law(const Posed& posed) {
    const bool is_field = posed.exercise.fields.contains(posed.solution);
    if (posed.exercise.law.empty()) {
      if (!is_field) fail("law: missing; the solution is no field of the program's answer");
      return;
    }
    Values values = posed.values;
    values["answer"] = equality::to_text(
        with_values(read_content(posed.solution, "solution/answer.txt"), posed.values));
    if (!holds(posed.exercise.law, values, "law"))
      fail("the law does not hold: " + posed.exercise.law);
  }

  void expect(const Posed& posed, const std::string& answer, Judged expected,
              const std::string& what) {
    const Judgement judgement = judged(posed, answer);
    if (judgement.verdict != expected)
      fail(fmt::format("{} is judged {}: {} {}", what, name_of(judgement.verdict), judgement.said,
                       judgement.explanation));
    const bool has_reason = !judgement.explanation.empty() || !exercise_.choices.empty();
    if (expected == Judged::wrong && !has_reason) fail(what + " is refused without a reason");
  }

  void require_one_choice(const Posed& posed) {
    long right = 0;
    for (std::size_t i = 0; i < posed.exercise.choices.size(); ++i)
      right += judged(posed, std::string(1, static_cast<char>('a' + i))).verdict == Judged::right;
    if (right != 1) fail(fmt::format("{} choices are right; one is asked for", right));
  }

  std::vector<std::string> theorem_complaints(const Posed& posed) {
    std::vector<std::string> complaints;
    const auto require = [&](const std::string& solution, const std::string& theorem) {
      if (theorem.empty()) return;
      if (std::string complaint = proved_.complaint(posed, solution, theorem); !complaint.empty())
        complaints.push_back(std::move(complaint));
    };
    if (exercise_.kind == ExerciseKind::symbolic) {
      std::string last = posed.solution;
      if (exercise_.shape == Shape::derivation || exercise_.shape == Shape::equations) {
        last = last.substr(last.rfind('\n') + 1);
        last = last.substr(last.rfind('=') + 1);
      }
      require(last, exercise_.theorem);
      for (const auto& [name, value] : posed.exercise.truth)
        if (posed.exercise.truth_theorems.contains(name))
          require(value, posed.exercise.truth_theorems.at(name));
        else
          complaints.push_back("truth." + name + ": no theorem in truth_theorems says so");
    }
    for (const ComparedOutput& output : exercise_.code.outputs) {
      const bool is_paper_name = equality::meaning(output.exact).has_value();
      if (!output.exact.empty() && !is_paper_name && output.theorem.empty())
        complaints.push_back("output " + output.name + ": a theorem must say what is exact");
      require(output.exact, output.theorem);
    }
    return complaints;
  }

  /// What one types who has it: as it stands, or with names that the exercise does not know written out.
  std::vector<std::string> typed(const Posed& posed, const Misconception& one) {
    if (!one.program.empty()) return {text_of(exercise_.folder / one.program)};
    std::vector<std::string> answers;
    for (const std::string& answer : one.answers) answers.push_back(filled(answer, posed.values));
    if (!one.replace.empty()) answers.push_back(replaced_solution(posed, one));
    return answers;
  }

  void examine(const Posed& posed, const Misconception& one) {
    ++report_.misconceptions;
    for (const std::string& answer : typed(posed, one)) {
      Judgement judgement = judged(posed, answer);
      const bool is_scalar = exercise_.kind != ExerciseKind::code &&
                             exercise_.shape == Shape::expression && exercise_.choices.empty();
      if (judgement.verdict == Judged::unread && is_scalar) {
        equality::Tree tree = read_content(answer, "misconceptions.toml");
        for (const auto& [name, value] : posed.values)
          tree = equality::substituted(tree, name, read_content(value, name));
        judgement = judged(posed, equality::to_text(tree));
        if (judgement.verdict == Judged::unread)
          judgement = judged(posed, equality::to_text(equality::with_meanings(tree)));
      }
      if (judgement.misconception != one.name)
        fail(fmt::format("misconception \"{}\" is not recognised in {}: {} {} {}", one.name,
                         exercise_.kind == ExerciseKind::code ? one.program : answer,
                         name_of(judgement.verdict), judgement.said, judgement.explanation));
    }
  }

  const Exercise& exercise_;
  ProvedContent& proved_;
  ContentReport report_;
  std::string place_;
};

std::string json_of(const std::vector<std::pair<std::string, ContentReport>>& reports) {
  std::int64_t answers = 0;
  std::string list;
  for (const auto& [id, report] : reports) {
    answers += report.answers;
    for (const std::string& failure : report.failures)
      list += (list.empty() ? "" : ", ") +
              json_object({"id", "what"}, {text_cell(id), text_cell(failure)});
  }
  return json_object({"checked", "answers", "failures"},
                     {number_cell(static_cast<std::int64_t>(reports.size())), number_cell(answers),
                      Cell{"[" + list + "]"}}) +
         "\n";
}

}  // namespace

ContentReport content_report(const Exercise& exercise, ProvedContent& proved) {
  return Examination(exercise, proved).report();
}

ExitCode learn_test(const LearnOptions& options) {
  const Catalogue catalogue{std::filesystem::path(options.content)};
  Destination output(options.output.path);
  const bool is_text = options.output.format == "text";
  ProvedContent proved;
  std::vector<std::pair<std::string, ContentReport>> reports;
  std::size_t failures = 0;
  int answers = 0;
  for (const Exercise& exercise : catalogue.exercises()) {
    if (!options.id.empty() && exercise.id != catalogue.at(options.id).id) continue;
    reports.emplace_back(exercise.id, content_report(exercise, proved));
    const ContentReport& report = reports.back().second;
    failures += report.failures.size();
    answers += report.answers;
    if (!is_text) continue;
    output.write(fmt::format("{} {} ({} variants, {} answers, {} misconceptions)\n",
                             report.failures.empty() ? "good  " : "FAILED", exercise.id,
                             report.variants, report.answers, report.misconceptions));
    for (const std::string& failure : report.failures) output.write("  " + failure + "\n");
    output.flush();
  }
  output.write(is_text ? fmt::format("{} exercises, {} answers judged, {} failures\n",
                                     reports.size(), answers, failures)
                       : json_of(reports));
  output.finish();
  return failures == 0 ? ExitCode::done : ExitCode::check_failed;
}

}  // namespace magicmass::command
