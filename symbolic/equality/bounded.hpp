// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "equality/decide.hpp"
#include "equality/parse.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::equality {

/// A question as it was typed.
struct Question {
  std::string lhs;                  ///< left side
  std::string rhs;                  ///< right side
  std::vector<std::string> domain;  ///< conditions, each a list with commas
};

/// What an answer may cost.
struct Bounds {
  std::chrono::milliseconds time{1600};          ///< for the whole answer
  std::size_t memory = std::size_t{400} << 20U;  ///< bytes of address space
};

/// The question cannot be asked: one line that says why, and which side of it.
struct Refused : InvalidInput {
  using InvalidInput::InvalidInput;
};

/// Reads and decides, here and now and without bounds on time. Throws Refused.
Verdict answer(const Question& question,
               const std::function<void(const Verdict&)>& provisional = {});

/// The same in a child process, which is killed when it takes too much: GiNaC cannot be interrupted. What is then
/// known is the verdict "undecided", with the digits that agree if it got so far. Throws Refused; std::system_error
/// where there is no process to be had.
Verdict answer_within(const Question& question, const Bounds& bounds = {});

}  // namespace magicmass::equality
