// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "algebraic/terms.hpp"

namespace magicmass::algebraic {

/// Multiplies a term out, with roots of unity for cosines and a generator for each prime and each other radicand
/// under a root, and removes the radicals from the last to the first (RadicalRing::is_zero). If the term is thereby
/// proved to be 0, a sentence that says so. Nothing if it is not 0, or if this method or the budget does not suffice.
std::optional<std::string> proof_of_zero(const Terms& terms, std::size_t id, const Work& work);

}  // namespace magicmass::algebraic
