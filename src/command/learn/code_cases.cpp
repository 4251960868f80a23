// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/code_cases.hpp"

#include <cstdlib>

#include <fmt/format.h>

#include "command/learn/expressions.hpp"
#include "command/learn/own_answer.hpp"
#include "command/learn/pass_program.hpp"
#include "command/learn/variant.hpp"

namespace magicmass::command {
namespace {

long double number_of(const equality::Tree& constant, const std::string& place) {
  const std::string digits = digits_of(constant, 40, place);
  return std::strtold(digits.c_str(), nullptr);
}

ExpectedCase expected_case(const Exercise& exercise, const std::vector<std::string>& row,
                           std::map<std::string, std::string>& answers) {
  const CodeCheck& code = exercise.code;
  const std::string place = (exercise.folder / "exercise.toml").string() + ": code";
  ExpectedCase expected;
  Values decimal;                        // shortest decimals, which stand for the doubles
  Values exact{{"V", "1"}, {"L", "1"}};  // the units, unless they are inputs
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string& name = code.inputs[i];
    expected.labels[name] = row[i];
    expected.inputs.push_back(
        static_cast<double>(number_of(with_values(read_content(row[i], place), {}), place)));
    decimal[name] = fmt::format("{}", expected.inputs.back());
    exact[name] = fmt::format("{:.1100g}", expected.inputs.back());  // every digit of the double
    for (char& c : exact[name])
      if (c == 'e') c = 'E';
  }
  for (const ComparedOutput& output : code.outputs) {
    if (!output.exact.empty()) {
      expected.outputs.push_back(
          number_of(with_values(read_content(output.exact, place), exact), place));
      continue;
    }
    std::string key;
    for (const std::string& word : exercise.run) key += filled(word, decimal) + "\n";
    for (const auto& [name, value] : decimal) key += value + "\n";
    if (!answers.contains(key))
      answers[key] = code.pass.name.empty()
                         ? own_answer(exercise.run, "json", exercise.folder, decimal)
                         : pass_program(exercise).json;
    const std::string field = field_of(answers[key], filled(output.field, expected.labels));
    expected.outputs.push_back(number_of(read_content(field, place), place));
  }
  return expected;
}

}  // namespace

std::vector<ExpectedCase> expected_cases(const Exercise& exercise) {
  std::vector<ExpectedCase> cases;
  std::map<std::string, std::string> answers;  // of the program, each question put once
  for (const auto& row : exercise.code.cases)
    cases.push_back(expected_case(exercise, row, answers));
  return cases;
}

}  // namespace magicmass::command
