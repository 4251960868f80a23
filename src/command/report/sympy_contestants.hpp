// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "proof/theorem.hpp"
#include "report/contestant.hpp"

namespace magicmass::command {

/// Every form but the exact ones through SymPy's lambdify on NumPy arrays, in a python3 of its own that lives as long
/// as the contestants and times itself. Without it, SymPy or NumPy a line in `remarks` instead.
std::vector<report::Contestant> sympy_contestants(const std::vector<proof::Theorem>& theorems,
                                                  const std::vector<std::string>& quantities,
                                                  std::vector<std::string>& remarks);

}  // namespace magicmass::command
