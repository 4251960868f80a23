// SPDX-License-Identifier: GPL-2.0-or-later
// A student's function, compiled and called with each case in a process of its own.
#pragma once

#include <string>
#include <vector>

#include "command/learn/confined_process.hpp"
#include "command/learn/exercise.hpp"

namespace magicmass::command {

/// What a function gave, as far as it came.
struct CodeRun {
  std::string compile_error;  ///< first lines of it; empty where it was compiled
  bool has_compiler = true;
  ProcessEnd end;                            ///< of the run
  std::vector<std::vector<double>> results;  ///< a row for each case that was finished

  bool is_complete(std::size_t cases) const {
    return compile_error.empty() && end.is_good() && results.size() == cases;
  }
};

/// Compiles `program` with the exercise's driver.cpp and calls it with these inputs, a row a case.
CodeRun run_code(const Exercise& exercise, const std::string& program,
                 const std::vector<std::vector<double>>& inputs);

/// The same with rank.cpp, optimised and with generated/ at hand: a row a contestant, nanoseconds a call and then what
/// it gave for each case.
CodeRun run_contest(const Exercise& exercise, const std::string& program,
                    const std::vector<std::vector<double>>& inputs);

/// Why it came no further, the limit named: "it did not come to an end within 3 s"; empty where it ended well.
std::string why_stopped(const ProcessEnd& end);

/// The header that reads the cases for a driver.
std::filesystem::path driver_header();

}  // namespace magicmass::command
