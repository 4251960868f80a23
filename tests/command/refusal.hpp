// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "program_run.hpp"

/// What bad input gets: exit code 2, nothing on stdout, and one line of the program's that says this.
void check_refused(const ProgramRun& run, const std::string& part_of_message);
