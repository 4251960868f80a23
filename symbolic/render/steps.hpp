// SPDX-License-Identifier: GPL-2.0-or-later
// The derivation as plain steps, and which of them a reader asked for.
#pragma once

#include <string>
#include <vector>

#include "derivation/derivation.hpp"
#include "proof/theorem.hpp"

namespace magicmass::render {

/// Every step in order; a refused one, if any, last.
std::vector<proof::Step> steps_of(const derivation::Derivation& derivation);

/// The part of a step's id before the first dot.
std::string chapter_of(const proof::Step& step);

/// How many of the steps have this verdict.
std::size_t count_verdict(const std::vector<proof::Step>& steps, const std::string& verdict);

}  // namespace magicmass::render
