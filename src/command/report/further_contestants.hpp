// SPDX-License-Identifier: GPL-2.0-or-later
// Contestants that need the derivation: the same theorems computed by GiNaC, by compiled GiNaC, by SymPy on NumPy.
#pragma once

#include <string>
#include <vector>

#include "command/report/derived_formulas.hpp"
#include "command/report/report_tasks.hpp"
#include "report/contestant.hpp"

namespace magicmass::command {

/// The forms of these quantities; none, and a line in `remarks`, if the derivation is refused.
std::vector<DerivedForm> forms_from_derivation(const std::vector<std::string>& quantities,
                                               std::vector<std::string>& remarks);

/// What is not there (a C compiler, SymPy) leaves a line in `remarks` instead. Peers other than GiNaC on
/// request, and the reader's own function.
std::vector<report::Contestant> further_contestants(const std::vector<DerivedForm>& forms,
                                                    const ReportRequest& request,
                                                    std::vector<std::string>& remarks);

}  // namespace magicmass::command
