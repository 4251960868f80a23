// SPDX-License-Identifier: GPL-2.0-or-later
// Programs that are not trusted, run with limits.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace magicmass::command {

struct ProcessLimits {
  std::chrono::milliseconds time{3000};          ///< on the clock; CPU time is bounded by the same
  std::size_t memory = std::size_t{512} << 20U;  ///< bytes of address space; 0: no bound
  std::size_t output = std::size_t{1} << 20U;    ///< bytes that are read from it
  bool is_computing_only =
      true;  ///< no file is written, no process started or sent a signal, no network used
};

struct ProcessEnd {
  int exit_code = -1;       ///< -1 where it did not exit by itself
  int signal = 0;           ///< that ended it
  bool is_late = false;     ///< killed at the end of its time
  bool is_verbose = false;  ///< killed for too much output
  std::string output;       ///< stdout and stderr
  std::string results;      ///< what it wrote to descriptor 3

  bool is_good() const { return exit_code == 0; }
};

/// Runs `words` in `folder`, with `input` on stdin, and waits for its end; the whole process group is then killed.
/// exit_code 127 where there is no such program. Throws std::system_error where no process is to be had.
ProcessEnd run_confined(const std::vector<std::string>& words, const std::string& input,
                        const std::filesystem::path& folder, const ProcessLimits& limits);

/// Whether allow_computing_only() can be had here. To be asked before fork: it makes what a child needs for that.
bool can_allow_computing_only();

/// In a child, before exec: from now on the system kills the process (SIGSYS) when it opens a file for writing,
/// changes a folder, starts a process or uses the network. False where the system has no such filter.
bool allow_computing_only();

}  // namespace magicmass::command
