// SPDX-License-Identifier: GPL-2.0-or-later
// Are two expressions equal over the reals, wherever both have a value? Never a guess.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "equality/domain.hpp"

namespace equality {
enum class Answer { Equal, Different, Undecided };

/// A point where both sides have a value, and the values differ.
struct Counterexample {
  std::string point;  ///< "alpha = 1/2, n = 3"; "" for constants
  std::string left;   ///< "1/2", "0.7071067811865475"
  std::string right;
  std::string difference;  ///< left - right
};
struct Verdict {
  Answer answer = Answer::Undecided;
  std::string proof = {};                ///< how it is known, in a sentence; else what was tried
  std::vector<std::string> domain = {};  ///< "alpha > 0", "n integer, n >= 1"
  std::vector<std::string> conditions = {};  ///< where both sides have a value: "alpha - 1 != 0"
  std::vector<std::string> notes = {};       ///< where one side alone has a value
  std::optional<Counterexample> counterexample = {};
  std::string theorem = {};  ///< what the kernel certified, for rational functions
};
/// Equal: proved wherever both sides have a value, but for isolated points. Different: at a point
/// both values are certain, and differ. Refused (kernel::Refused): no point of the domain, or none
/// where both sides have a value, was found.
Verdict decide(Expr left, Expr right, const Domain& domain);
const char* word(Answer answer);  ///< "equal", "different", "undecided"
}  // namespace equality
