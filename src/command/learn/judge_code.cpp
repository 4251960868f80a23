// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "command/learn/code_cases.hpp"
#include "command/learn/code_run.hpp"
#include "command/learn/judgement.hpp"
#include "command/learn/variant.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::command {
namespace {

long double error_in_ulp(double got, long double exact) {
  const double nearest = std::abs(static_cast<double>(exact));
  const long double ulp =
      static_cast<long double>(std::nextafter(nearest, std::numeric_limits<double>::infinity())) -
      static_cast<long double>(nearest);
  return std::abs(static_cast<long double>(got) - exact) / ulp;
}

bool is_close(double got, long double exact, const CodeCheck& code) {
  return std::isfinite(got) && (error_in_ulp(got, exact) <= static_cast<long double>(code.ulp) ||
                                std::abs(static_cast<long double>(got) - exact) <= code.absolute);
}

std::string motion(double velocity) {
  if (std::isnan(velocity)) return "has no velocity (nan)";
  return velocity > 0 ? "moves right" : velocity < 0 ? "moves left" : "stands still";
}

/// "your C moves left, it should move right".
std::string told(const ComparedOutput& output, double got, long double exact) {
  const auto expected = static_cast<double>(exact);
  const std::string velocity_of = "velocity of ";
  if (output.words.starts_with(velocity_of)) {
    const std::string body = output.words.substr(velocity_of.size());
    std::string should = motion(expected);
    if (motion(got) != should) {
      should.erase(should.find('s', 4), 1);  // moves, stands: move, stand
      return fmt::format("your {} {}, it should {}", body, motion(got), should);
    }
    return fmt::format("your {} {} at {}, it should at {}", body, motion(got), std::abs(got),
                       std::abs(expected));
  }
  const std::string what = output.words.empty() ? output.name : output.words;
  return fmt::format("your {} is {}, it should be {}", what, got, expected);
}

/// Of an open exercise: the student's function among ours, by the worst error and then by time.
std::string ranking(const Exercise& exercise, const std::string& program,
                    const std::vector<ExpectedCase>& cases,
                    const std::vector<std::vector<double>>& inputs) {
  const std::vector<std::string>& names = exercise.code.contestants;
  if (names.empty()) return {};
  const CodeRun run = run_contest(exercise, program, inputs);
  if (!run.is_complete(names.size())) return "The contest was stopped: " + why_stopped(run.end);
  struct Place {
    double error, nanoseconds;
    std::string name;
  };
  std::vector<Place> places;
  const std::size_t outputs = exercise.code.outputs.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<double>& row = run.results[i];
    if (row.size() != cases.size() * outputs + 1)
      throw InvalidInput((exercise.folder / "rank.cpp").string() + ": a row of another length");
    long double worst = 0;
    for (std::size_t k = 0; k < cases.size(); ++k)
      for (std::size_t j = 0; j < outputs; ++j)
        worst = std::max(worst, error_in_ulp(row[k * outputs + j + 1], cases[k].outputs[j]));
    places.push_back({static_cast<double>(worst), row.front(), names[i]});
  }
  std::sort(places.begin(), places.end(), [](const Place& x, const Place& y) {
    return std::tie(x.error, x.nanoseconds) < std::tie(y.error, y.nanoseconds);
  });
  std::string text;
  for (std::size_t i = 0; i < places.size(); ++i)
    text += fmt::format("{}{}. {}: worst error {:.2f} ulp, {:.0f} ns a call", i == 0 ? "" : "\n",
                        i + 1, places[i].name, places[i].error, places[i].nanoseconds);
  return text;
}

std::string place_of(const Exercise& exercise, const ExpectedCase& expected) {
  if (!exercise.code.place.empty())
    return capitalised(filled(exercise.code.place, expected.labels));
  return capitalised("for " + shown_variant(expected.labels));
}

/// The first case where the results differ from what is expected, told; empty where none does.
std::string first_difference(const Exercise& exercise, const std::vector<ExpectedCase>& cases,
                             const std::vector<std::vector<double>>& results) {
  for (std::size_t i = 0; i < results.size(); ++i)
    for (std::size_t k = 0; k < exercise.code.outputs.size(); ++k) {
      if (results[i].size() != exercise.code.outputs.size())
        throw InvalidInput((exercise.folder / "driver.cpp").string() +
                           ": it gives another number of results than there are outputs");
      if (!is_close(results[i][k], cases[i].outputs[k], exercise.code))
        return place_of(exercise, cases[i]) + ": " +
               told(exercise.code.outputs[k], results[i][k], cases[i].outputs[k]) + ".";
    }
  return {};
}

bool are_alike(const std::vector<std::vector<double>>& left,
               const std::vector<std::vector<double>>& right) {
  if (left.size() != right.size()) return false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i].size() != right[i].size()) return false;
    for (std::size_t k = 0; k < left[i].size(); ++k) {
      const double x = left[i][k];
      const double y = right[i][k];
      if (std::isnan(x) && std::isnan(y)) continue;
      if (!(std::abs(x - y) <= 1e-9 * (1 + std::abs(x)))) return false;
    }
  }
  return true;
}

/// What a program of the exercise gives; run once, however often it is asked for.
const std::vector<std::vector<double>>& known_results(
    const Exercise& exercise, const std::string& program,
    const std::vector<std::vector<double>>& inputs) {
  using Rows = std::vector<std::vector<double>>;
  static std::map<std::tuple<std::string, std::string, Rows>, Rows> known;
  const std::string text = text_of(exercise.folder / program);
  const auto [place, is_new] = known.try_emplace({exercise.folder.string(), text, inputs});
  if (is_new) place->second = run_code(exercise, text, inputs).results;
  return place->second;
}

const Misconception* recognised(const Exercise& exercise,
                                const std::vector<std::vector<double>>& inputs,
                                const std::vector<std::vector<double>>& results) {
  for (const Misconception& one : exercise.misconceptions)
    if (are_alike(known_results(exercise, one.program, inputs), results)) return &one;
  return nullptr;
}

}  // namespace

Judgement judge_code(const Posed& posed, const std::string& program) {
  const Exercise& exercise = posed.exercise;
  const std::vector<ExpectedCase> cases = expected_cases(exercise);
  std::vector<std::vector<double>> inputs;
  inputs.reserve(cases.size());
  for (const ExpectedCase& one : cases) inputs.push_back(one.inputs);
  const CodeRun run = run_code(exercise, program, inputs);
  if (!run.has_compiler)
    return unread(run.compile_error + "; install one, on Debian: apt install g++");
  Judgement judgement;
  if (!run.compile_error.empty()) {
    judgement.verdict = Judged::unread;
    judgement.said = "This does not compile:";
    judgement.read_as = {};
    judgement.explanation = run.compile_error;
    return judgement;
  }
  judgement.explanation = first_difference(exercise, cases, run.results);
  if (run.is_complete(cases.size()) && judgement.explanation.empty()) {
    judgement.verdict = Judged::right;
    judgement.said = fmt::format("Right in all {} cases.", cases.size());
    judgement.explanation = ranking(exercise, program, cases, inputs);
    return judgement;
  }
  judgement.verdict = Judged::wrong;
  judgement.said = "Not right.";
  if (!run.is_complete(cases.size())) {
    const std::string reason = why_stopped(run.end);
    const std::string stopped =
        run.results.size() < cases.size()
            ? place_of(exercise, cases[run.results.size()]) + ": your program was stopped: " +
                  (reason.empty() ? "it ended before all cases were done" : reason) + "."
            : "After the last case: " + reason + ".";
    judgement.explanation += (judgement.explanation.empty() ? "" : "\n") + stopped;
    return judgement;
  }
  if (const Misconception* one = recognised(exercise, inputs, run.results)) {
    judgement.misconception = one->name;
    judgement.explanation += "\n" + one->feedback;
  }
  return judgement;
}

}  // namespace magicmass::command
