// SPDX-License-Identifier: GPL-2.0-or-later
// The derivation for a reader (text, Markdown) and for a program (JSON).
#pragma once

#include <string>
#include <vector>

#include "proof/theorem.hpp"

namespace magicmass::render {

/// A verdict, coloured where `colourful`.
std::string verdict_text(const std::string& verdict, bool colourful);

/// Chapter by chapter, each step with its words, equation, conditions, label and verdict; 80 columns.
std::string derivation_text(const std::vector<proof::Step>& steps, bool colourful);
std::string derivation_markdown(const std::vector<proof::Step>& steps);
std::string derivation_json(const std::vector<proof::Step>& steps);

/// The laws in full, then a chapter at a time its counts and main theorems; 80 columns.
std::string derivation_summary(const std::vector<proof::Step>& steps, bool colourful);

}  // namespace magicmass::render
