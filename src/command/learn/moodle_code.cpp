// SPDX-License-Identifier: GPL-2.0-or-later
// CodeRunner questions, and Moodle's own kinds for predictions.
#include <cmath>

#include <fmt/format.h>

#include "command/learn/code_cases.hpp"
#include "command/learn/code_run.hpp"
#include "command/learn/expressions.hpp"
#include "command/learn/moodle.hpp"
#include "command/learn/pass_program.hpp"
#include "command/learn/variant.hpp"
#include "magicmass/errors.hpp"
#include "render/formula_mathml.hpp"

namespace magicmass::command {
namespace {

std::string without_line(const std::string& text, const std::string& line) {
  const std::size_t at = text.find(line);
  if (at == std::string::npos) return text;
  return text.substr(0, at) + text.substr(std::min(text.find('\n', at) + 1, text.size()));
}

/// The driver without what the starter defines, too: types, which a file may define but once.
std::string without_types_of(const std::string& starter, const std::string& driver) {
  std::string kept;
  for (std::size_t at = 0; at < driver.size();) {
    const std::size_t end = std::min(driver.find('\n', at), driver.size() - 1) + 1;
    const bool is_type =
        driver.compare(at, 7, "struct ") == 0 || driver.compare(at, 5, "enum ") == 0;
    const std::size_t last = is_type ? driver.find("};\n", at) : std::string::npos;
    if (last != std::string::npos &&
        starter.find(driver.substr(at, last + 3 - at)) != std::string::npos) {
      at = last + 3;
      continue;
    }
    kept += driver.substr(at, end - at);
    at = end;
  }
  return kept;
}

std::string driver_of(const Exercise& exercise) {
  std::string driver = without_types_of(
      text_of(exercise.folder / "answer.cpp"),
      without_line(text_of(exercise.folder / "driver.cpp"), "#include \"exercise_driver.hpp\""));
  const std::string include = "#include \"program_before.hpp\"\n";
  const std::size_t at = driver.find(include);
  if (at != std::string::npos) driver.replace(at, include.size(), pass_program(exercise).header);
  return driver;
}

/// The whole program in one file; Twig, which fills it in, must leave the braces of C++ alone.
std::string program_template(const Exercise& exercise) {
  return "{% verbatim %}\n#define MAGICMASS_PRINT\n" +
         without_line(text_of(driver_header()), "#pragma once") +
         "{% endverbatim %}\n{{ STUDENT_ANSWER }}\n{% verbatim %}\n" + driver_of(exercise) +
         "{% endverbatim %}\n";
}

std::string test_case(const ExpectedCase& one, bool is_example) {
  std::string input = "1";
  for (const double value : one.inputs) input += fmt::format(" {:a}", value);
  std::string expected;
  for (const long double value : one.outputs) {
    const auto rounded = static_cast<double>(value);
    expected += fmt::format("{:.9g} ", std::abs(rounded) < 1e-12 ? 0.0 : rounded);
  }
  return fmt::format(
             "<testcase testtype=\"0\" useasexample=\"{}\" hiderestiffail=\"0\" "
             "mark=\"1.0\">\n",
             is_example ? 1 : 0) +
         text_element("testcode", "// " + shown_variant(one.labels)) +
         text_element("stdin", input) + text_element("expected", expected) +
         text_element("extra", "") + "<display><text>SHOW</text></display>\n</testcase>\n";
}

std::string fraction_answer(const std::string& fraction, const std::string& text,
                            const std::string& feedback, const std::string& further = "") {
  return "<answer fraction=\"" + fraction + "\" format=\"html\">\n" + "<text>" +
         render::html_escaped(text) + "</text>\n" + html_element("feedback", feedback) + further +
         "</answer>\n";
}

const Misconception* about(const Posed& posed, const std::string& answer) {
  for (const Misconception& one : posed.exercise.misconceptions)
    for (const std::string& text : one.answers)
      if (text == answer) return &one;
  return nullptr;
}

std::string choices(const Posed& posed) {
  std::string xml = element("single", "true") + element("shuffleanswers", "0") +
                    element("answernumbering", "abc");
  for (std::size_t i = 0; i < posed.exercise.choices.size(); ++i) {
    const Choice& choice = posed.exercise.choices[i];
    const Misconception* one = about(posed, std::string(1, static_cast<char>('a' + i)));
    xml += fraction_answer(holds(choice.when, posed.values, posed.exercise.id) ? "100" : "0",
                           render::html_escaped(choice.text), one == nullptr ? "" : one->feedback);
  }
  return xml;
}

std::string decimal(const std::string& expression, const Posed& posed) {
  std::string text =
      digits_of(with_values(read_content(expression, posed.exercise.id), posed.values), 12,
                posed.exercise.id);
  if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string numbers(const Posed& posed) {
  const std::string within =
      posed.exercise.within.empty() ? "0" : decimal(posed.exercise.within, posed);
  std::string xml =
      fraction_answer("100", decimal(posed.solution, posed), "", element("tolerance", within));
  for (const Misconception& one : posed.exercise.misconceptions)
    for (const std::string& answer : one.answers)
      xml += fraction_answer("0", decimal(answer, posed), one.feedback, element("tolerance", "0"));
  return xml;
}

}  // namespace

std::string moodle_code(const Posed& posed) {
  const Exercise& exercise = posed.exercise;
  std::string xml = element("coderunnertype", "cpp_program") + element("prototypetype", "0") +
                    element("allornothing", "1") + element("penaltyregime", "0, 10, 20, ...") +
                    element("precheck", "0") + element("showsource", "0") +
                    element("answerboxlines", "20") + element("answerboxcolumns", "100") +
                    element("answerpreload", text_of(exercise.folder / "answer.cpp")) +
                    element("globalextra", "") + element("useace", "1") +
                    element("template", program_template(exercise)) +
                    element("iscombinatortemplate", "0") + element("allowmultiplestdins", "0") +
                    element("answer", posed.solution) + element("validateonsave", "1") +
                    element("grader", "EqualityGrader") + element("cputimelimitsecs", "3") +
                    element("memlimitmb", "512") + "<testcases>\n";
  const std::vector<ExpectedCase> cases = expected_cases(exercise);
  for (std::size_t i = 0; i < cases.size(); ++i) xml += test_case(cases[i], i == 0);
  return xml + "</testcases>\n";
}

std::string moodle_prediction(const Posed& posed) {
  return posed.exercise.choices.empty() ? numbers(posed) : choices(posed);
}

}  // namespace magicmass::command
