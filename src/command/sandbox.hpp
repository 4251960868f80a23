// SPDX-License-Identifier: GPL-2.0-or-later
// Code of others, compiled and run where it can do nothing but compute.
#pragma once

#include "learn/code.hpp"

namespace command {

/// From now on the system ends this process (SIGSYS) with whatever a statically linked program that
/// computes does not ask for: it opens no file, starts no process, signals none, sees no network.
/// It may become `program`, by this very pointer. False where the system has no such filter.
bool compute_only(const char* program);

/// Compiles the answer with the exercise's driver and runs it with these inputs: no file of it is
/// left, no process. Throws answers::Undecided where there is no compiler or no filter: nothing is
/// run without one.
learn::Ran run_code(const learn::Exercise& exercise, const std::string& code,
                    const learn::Rows& inputs);

}  // namespace command
