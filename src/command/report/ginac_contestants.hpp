// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command/report/derived_formulas.hpp"
#include "report/contestant.hpp"

namespace magicmass::command {

/// The forms through GiNaC: compile_ex, which calls gcc (here with -O2), and evalf at 17 digits, of
/// the paper's form. Their last bits are not reproducible: GiNaC's terms change places from run to run. Without
/// compiler, or without Debian's ginac-tools, a line in `remarks` instead.
std::vector<report::Contestant> ginac_contestants(const std::vector<DerivedForm>& forms,
                                                  std::vector<std::string>& remarks);

}  // namespace magicmass::command
