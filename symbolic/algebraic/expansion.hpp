// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "algebraic/terms.hpp"

namespace magicmass::algebraic {

/// Multiplies a term out, with roots of unity for cosines and one generator for each prime and each other radicand
/// under a root, and looks whether everything cancels. If so, the term is 0, and the sentence says how that is known.
/// Nothing if not everything cancels, which alone says nothing, or if the budget is too small for it.
std::optional<std::string> cancels(const Terms& terms, std::size_t id, const Work& work);

}  // namespace magicmass::algebraic
