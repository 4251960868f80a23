// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "equality/domain.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::equality {

/// What a question comes to.
enum class Answer { equal, different, undecided };

/// A point where the sides differ, or where one of them alone is defined, and what they are there.
struct Counterexample {
  std::map<std::string, std::string> point;  ///< empty for constants
  std::string left;                          ///< "1/2", "0.7071067811865475", "not defined (...)"
  std::string right;                         ///< likewise
  std::string difference = {};  ///< left - right, a few digits of it; empty if one is not defined
};

/// An answer, and how it is known.
struct Verdict {
  Answer answer = Answer::undecided;  ///< undecided where neither was proved
  std::string proof;                ///< the method, in a sentence; for "undecided", what was tried
  std::vector<std::string> domain;  ///< where: "alpha > 0", "n integer, n >= 1"
  std::vector<std::string>
      conditions;                  ///< besides: "alpha - 1 != 0"; elsewhere a side is not defined
  std::vector<std::string> notes;  ///< "psi = 2*atan(...)", "alhpa is taken as a symbol; alpha?"
  std::optional<Counterexample> counterexample;  ///< where the answer is "different"
  int agreeing_digits = 0;  ///< of both sides at `points` points, where the answer is "undecided"
  int points = 0;           ///< see agreeing_digits
};

/// The question has no answer: a side has no value anywhere that was tried, or the domain is empty.
struct NoQuestion : InvalidInput {
  using InvalidInput::InvalidInput;
};

/// The names that the paper defines, written out.
Tree with_meanings(const Tree& tree);

/// Equal: the same value wherever the conditions hold, and elsewhere on the domain neither side is defined or one of
/// them divides by zero. Different: there is a counterexample. Never a guess. `provisional` hears of an undecided
/// verdict, with the digits that agree, before the proofs begin; they can take long. Throws NoQuestion.
Verdict decide(const Tree& lhs, const Tree& rhs, const Domain& domain,
               const std::function<void(const Verdict&)>& provisional = {});

}  // namespace magicmass::equality
