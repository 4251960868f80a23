// SPDX-License-Identifier: GPL-2.0-or-later
// Programs of others, compiled and run where they can do nothing but compute.
#pragma once

#include "learn/judge.hpp"

namespace classroom {

/// Compiles the answer with the exercise's driver and runs it with these inputs, once however often
/// the results are asked for. No file of it is left, no process. Throws answers::Undecided where
/// there is no compiler, or no filter of system calls: nothing is run without one.
learn::Ran run_code(const learn::Exercise& exercise, const std::string& code,
                    const learn::Rows& inputs);

}  // namespace classroom
