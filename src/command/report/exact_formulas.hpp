// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command/report/derived_formulas.hpp"
#include "report/contestant.hpp"
#include "report/oracle.hpp"

namespace magicmass::command {

/// Quantities of these forms that the oracle does not know by itself.
std::vector<std::string> unknown_quantities(const std::vector<DerivedForm>& forms);

/// Teaches the oracle such quantities: each form's own theorems, evaluated by CLN's functions with more and more digits
/// until two evaluations agree and every rounding is certain. That shows what an evaluator loses against its
/// theorem, not whether the theorem is what one wants. Where no value or no certainty comes out, nothing exists.
void teach(report::Oracle& oracle, const std::vector<DerivedForm>& forms);

/// The value of one of a form's inputs by name, alpha, e, or an index.
double input_named(const std::string& name, const report::Input& input);

}  // namespace magicmass::command
