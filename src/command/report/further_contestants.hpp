// SPDX-License-Identifier: GPL-2.0-or-later
// Contestants that need the derivation: the same theorems computed by GiNaC, by compiled GiNaC, by SymPy on NumPy.
#pragma once

#include <string>
#include <vector>

#include "report/contestant.hpp"

namespace magicmass::command {

/// What is not there (a C compiler, SymPy) leaves a line in `remarks` instead. Peers other than GiNaC on
/// request. Of these quantities alone.
std::vector<report::Contestant> further_contestants(bool peers,
                                                    const std::vector<std::string>& quantities,
                                                    std::vector<std::string>& remarks);

}  // namespace magicmass::command
