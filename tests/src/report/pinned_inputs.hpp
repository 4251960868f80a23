// SPDX-License-Identifier: GPL-2.0-or-later
// The pinned worst inputs, replayed. After a change that moves them, of all contestants or of one by its name:
//   MAGICMASS_PIN=1 magicmass_report_tests "[pin]"      and of what needs the derivation, magicmass_command_tests "[pin]"
//   MAGICMASS_PIN=fast magicmass_report_tests "[pin]"
#pragma once

#include <cstddef>
#include <string>

#include "report/oracle.hpp"
#include "report/worst_inputs.hpp"

namespace magicmass::testing {

/// The file.
std::vector<report::WorstInput> pinned_inputs();

/// Checks our contestants of a quantity where each was worst: not much worse now, and what the tiers promise. How many
/// inputs that were. The oracle knows the quantity.
std::size_t replay_pinned(const std::string& quantity, report::Oracle& oracle);

/// Where MAGICMASS_PIN asks for it: looks for worse inputs of our contestants, in families of that size and from what is
/// pinned, and writes the file.
void pin_worst(const std::string& quantity, report::Oracle& oracle, std::size_t size);

}  // namespace magicmass::testing
