// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "report/contestant.hpp"
#include "report/exact_value.hpp"
#include "report/oracle.hpp"

namespace magicmass::report {

/// The contestant's answer to one input, compared member by member; nothing if the input, which
/// is one of rounded_input's, has no meaning or is more than this contestant can take. A member that does not exist
/// there is nullopt.
std::optional<std::vector<std::optional<Deviation>>> compared(const Contestant& contestant,
                                                              const Input& input, Oracle& oracle);

}  // namespace magicmass::report
