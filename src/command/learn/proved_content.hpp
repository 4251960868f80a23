// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>

#include "command/learn/judgement.hpp"
#include "derivation/derivation.hpp"

namespace magicmass::command {

/// The theorems that solutions are held against; derived when the first is asked for.
class ProvedContent {
public:
  /// Empty where `solution` is what the theorem says (its right side), with the exercise's notation and `where`; else
  /// what is wrong: no such theorem, or a counterexample.
  std::string complaint(const Posed& posed, const std::string& solution,
                        const std::string& theorem);

private:
  std::unique_ptr<derivation::Derivation> derivation_;
};

}  // namespace magicmass::command
