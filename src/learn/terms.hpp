// SPDX-License-Identifier: GPL-2.0-or-later
// An exercise's expressions: read, given their values, compared.
#pragma once

#include "learn/judge.hpp"
#include "notation/typed.hpp"

namespace learn {
using kernel::Expr;

class Terms {
public:
  explicit Terms(const Exercise& exercise);

  /// What a student typed. Refused (kernel::Refused) where it cannot be read.
  Expr typed(std::string text, Texts& notes) const;
  /// An equation's sides; another name than the one that is asked for, or two signs, are Refused.
  Expr typed_for_name(const std::string& text, Texts& notes) const;
  /// What the exercise says. Throws answers::InvalidInput.
  Expr content(const std::string& text) const;
  /// The answer: of the derivation's step, or typed by the teacher.
  Expr answer() const;
  Expr from_step(const std::string& id) const;
  /// Names that an answer has no right to, "" where there are none: with what is allowed.
  std::string foreign(Expr term) const;
  Expr in_full(Expr term) const;  ///< with values and the meanings of the paper's names
  /// Terms in full, numbers or matrices: right, wrong or undecided. "At alpha = 1 yours is 2; it
  /// should be 3."
  Judgement compare(Expr given, Expr expected) const;
  bool are_equal(Expr a, Expr b) const { return compare(a, b).mark == Mark::right; }
  equality::Domain domain(const std::set<std::string>& symbols) const;

  const Exercise& exercise;

private:
  kernel::Substitution values;  // the exercise's, and what was run
  int columns() const;          // of the matrix that is asked for; 0 of a number
  Judgement compare_numbers(Expr given, Expr expected) const;
};

/// What was typed, where it is short and all ASCII; else the term that was read.
std::string quoted(const std::string& typed, Expr read);
/// The feedback of the misconception that has this answer, in full; "" where there is none.
std::string misconception_of(const Terms& terms, Expr given);

Judgement judge_symbolic(const Exercise& exercise, const std::string& typed);
Judgement judge_prediction(const Exercise& exercise, const std::string& typed);
Judgement judge_derivation(const Exercise& exercise, const std::string& typed);
Judgement judge_code(const Exercise& exercise, const std::string& code, const Run& run);
/// The letter of the right one of the choices.
char right_choice(const Exercise& exercise);

}  // namespace learn
