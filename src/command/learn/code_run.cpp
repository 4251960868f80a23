// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/code_run.hpp"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "command/data_folder.hpp"
#include "command/generated_tree.hpp"
#include "command/learn/pass_program.hpp"
#include "command/scratch_folder.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

constexpr std::chrono::milliseconds compile_time{6000};
constexpr std::chrono::milliseconds run_time{
    3000};  // with compiling below the 10 s that are promised for a loop
constexpr int compiler_missing = 127;

std::string input_text(const std::vector<std::vector<double>>& inputs) {
  std::string text;
  for (const auto& row : inputs)
    for (const double value : row) text += fmt::format("{:a} ", value);
  return fmt::format("{} {}\n", inputs.size(), text);
}

/// The first errors alone: a page of template notes teaches nobody.
std::string first_errors(const std::string& output) {
  std::istringstream lines(output);
  std::string kept;
  int errors = 0;
  for (std::string line; errors < 2 && std::getline(lines, line);)
    if (line.find("error") != std::string::npos || line.find("undefined") != std::string::npos) {
      kept += (kept.empty() ? "" : "\n") + shown_text(line, 300);
      ++errors;
    }
  return kept.empty() ? shown_text(output, 300) : kept;
}

std::vector<std::vector<double>> rows_of(const std::string& text) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line) && !lines.eof();) {  // whole lines alone
    rows.emplace_back();
    std::istringstream words(line);
    for (std::string word; words >> word;)
      rows.back().push_back(std::strtod(word.c_str(), nullptr));
  }
  return rows;
}

}  // namespace

std::filesystem::path driver_header() {
  return data_folder("tutorials", "tutorials") / "exercise_driver.hpp";
}

namespace {

CodeRun run_with(const Exercise& exercise, const std::string& program,
                 const std::vector<std::vector<double>>& inputs, const std::string& driver,
                 const std::vector<std::string>& flags) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "answer.cpp") << program;
  std::ofstream(scratch.path() / "driver.cpp") << text_of(exercise.folder / driver);
  std::ofstream(scratch.path() / "exercise_driver.hpp") << text_of(driver_header());
  if (!exercise.code.pass.name.empty())
    std::ofstream(scratch.path() / "program_before.hpp") << pass_program(exercise).header;
  ProcessLimits limits;
  limits.time = compile_time;
  limits.memory = std::size_t{2} << 30U;
  limits.is_computing_only = false;
  CodeRun run;
  std::vector<std::string> words{"env",      "LC_ALL=C",       "TMPDIR=" + scratch.path().string(),
                                 "c++",      "-std=c++20",     "-ffp-contract=off",
                                 "-w",       "-fmax-errors=3", "-o",
                                 "exercise", "driver.cpp",     "answer.cpp"};
  words.insert(words.end(), flags.begin(), flags.end());
  const ProcessEnd compiled = run_confined(words, "", scratch.path(), limits);
  run.has_compiler = compiled.exit_code != compiler_missing;
  if (!run.has_compiler) {
    run.compile_error = "there is no C++ compiler called c++";
  } else if (compiled.is_late) {
    run.compile_error = fmt::format("compiling took more than {} s", compile_time.count() / 1000);
  } else if (!compiled.is_good()) {
    run.compile_error = first_errors(compiled.output);
  }
  if (!run.compile_error.empty()) return run;
  std::filesystem::create_directory(scratch.path() / "empty");
  ProcessLimits confined;
  confined.time = run_time;
  run.end = run_confined({"../exercise"}, input_text(inputs), scratch.path() / "empty", confined);
  run.results = rows_of(run.end.results);
  return run;
}

}  // namespace

CodeRun run_code(const Exercise& exercise, const std::string& program,
                 const std::vector<std::vector<double>>& inputs) {
  return run_with(exercise, program, inputs, "driver.cpp", {"-O1"});
}

CodeRun run_contest(const Exercise& exercise, const std::string& program,
                    const std::vector<std::vector<double>>& inputs) {
  return run_with(exercise, program, inputs, "rank.cpp",
                  {"-O2", "-I", source_generated_folder().string()});
}

std::string why_stopped(const ProcessEnd& end) {
  const bool had_no_memory = end.output.find("bad_alloc") != std::string::npos ||
                             end.output.find("length_error") != std::string::npos;
  if (end.is_late || end.signal == SIGXCPU)
    return fmt::format("it did not come to an end within {} s: is there a loop that never stops",
                       run_time.count() / 1000);
  if (end.is_verbose) return "it wrote more than 1 MiB of output";
  if (end.signal == SIGSYS || end.signal == SIGXFSZ)
    return "it tried to write a file, to start another program, to disturb one or to use the "
           "network, and an exercise may only compute";
  if (had_no_memory) return "it asked for more memory than the 512 MiB it may have";
  if (end.signal == SIGSEGV || end.signal == SIGBUS)
    return "it crashed: it used memory that is not its own, or called itself without end";
  if (end.signal == SIGFPE) return "it divided a whole number by zero";
  if (end.signal == SIGABRT)
    return "it gave up: " + end.output.substr(0, std::min<std::size_t>(end.output.find('\n'), 160));
  if (end.signal != 0) return fmt::format("it was ended by signal {}", end.signal);
  if (end.exit_code != 0) return fmt::format("it ended with exit code {}", end.exit_code);
  return {};
}

}  // namespace magicmass::command
