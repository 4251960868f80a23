// SPDX-License-Identifier: GPL-2.0-or-later
// What is said to an answer: never a guess, and of what was typed.
#pragma once

#include "learn/exercise.hpp"

namespace learn {

using Numbers = std::vector<double>;
using Rows = std::vector<Numbers>;

/// What a program did that is an answer.
struct Ran {
  std::string unread = {};   ///< why it was not compiled
  std::string stopped = {};  ///< why it came no further: "it crashed"
  Rows rows = {};            ///< what it gave for each case, as far as it came
};
/// Runs an answer to the exercise: a row of inputs is a case. Who judges does not know how.
using Run = std::function<Ran(const Exercise&, const std::string& code, const Rows& inputs)>;

enum class Mark { right, other_form, incomplete, wrong, unread, undecided };
const char* word(Mark mark);

struct Judgement {
  Mark mark = Mark::undecided;
  std::string feedback;
  Texts notes = {};                ///< how it was read, and where it has no value
  std::string misconception = {};  ///< the name of the one that it shows
};
/// What is said to one answer; of kind code it is a program, which `run` runs.
Judgement judge(const Exercise& exercise, const std::string& typed, const Run& run = {});

/// What an answer may be, a line each: the choices; or its symbols, the name that it may be an
/// equation for, its form; none of code.
Texts rules(const Exercise& exercise);
/// The answer as it is shown.
std::string own_answer(const Exercise& exercise);
/// What is wrong with the exercise itself: its own answer is not right, it differs from what the
/// program says, the answer of a misconception is not recognised, or a starter is not wrong.
Texts faults(const Exercise& exercise, const Run& run = {});

}  // namespace learn
