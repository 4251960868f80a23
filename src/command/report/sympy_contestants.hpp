// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command/report/derived_formulas.hpp"
#include "report/contestant.hpp"

namespace magicmass::command {

/// The forms through SymPy's lambdify on NumPy arrays, in a python3 of its own that lives as long
/// as the contestants and times itself. Without it, SymPy or NumPy a line in `remarks` instead.
std::vector<report::Contestant> sympy_contestants(const std::vector<DerivedForm>& forms,
                                                  std::vector<std::string>& remarks);

}  // namespace magicmass::command
