// An exercise's expressions: read, given their values, compared.
#pragma once

#include "answers/table.hpp"
#include "equality/decide.hpp"
#include "learn/exercise.hpp"

namespace learn {
using answers::InvalidInput;
using kernel::Expr;

class Terms {
public:
  explicit Terms(const Exercise& exercise);

  /// What a student typed, an equation or not. Refused (kernel::Refused) where it cannot be read.
  notation::Typed typed(std::string text, Texts& notes) const;
  /// Of an equation the side without the name that is asked for; Refused where neither is that.
  Expr typed_for_name(const std::string& text, Texts& notes) const;
  /// What the exercise says. Throws answers::InvalidInput.
  Expr content(const std::string& text) const;
  /// The answer: typed by the teacher (`faults` compares it with the step), or the step's.
  Expr answer() const;
  Expr from_step(const std::string& id) const;
  Expr stated(const std::string& text) const;  ///< a step's id, or a formula
  /// In full, with what the book says of all names: a_t, t_j, N_A.
  Expr in_book(Expr term) const;
  /// Names that an answer has no right to, "" where there are none: with what is allowed.
  std::string foreign(Expr term, const std::string& typed = "") const;
  Expr in_full(Expr term) const;  ///< with values and the meanings of the paper's names
  /// Terms in full: right, wrong or undecided. "At alpha = 1, where psi = 2.09, yours is 2."
  Judgement compare(Expr given, Expr expected, Expr typed = 0) const;
  bool are_equal(Expr a, Expr b) const { return compare(a, b).mark == Mark::right; }
  Judgement mistake(Expr given, const std::string& otherwise) const;
  /// The least of what was typed that has this part, where that is short; or the part.
  std::string quoted(const std::string& typed, Expr part) const;
  equality::Domain domain(const std::set<std::string>& symbols) const;
  /// What a term lacks of the exercise's form, in the words of its text; "" where nothing.
  std::string lacking(Expr term, const std::string& text) const;
  Texts allowed() const;  ///< the symbols that an answer in this form may use

  const Exercise& exercise;

private:
  std::set<std::string> symbols, known;  // those that an answer may use; of numbers also values
  kernel::Substitution values;           // the exercise's, and what was run
  Judgement compare_numbers(Expr given, Expr expected, Expr typed) const;
  std::string names_at(const equality::Point&, Expr typed) const;  // ", where psi = 2.0944,"
};

Texts forms();

using IsAnswer = std::function<bool(const std::string& answer)>;
/// Wrong, with the feedback of the first misconception that has an answer that was given.
Judgement mistake(const Exercise&, const IsAnswer& was_given, const std::string& otherwise);

/// Also says how the typed text was read.
Judgement judge_derivation(const Exercise& exercise, const std::string& typed, Texts& notes);
Judgement judge_code(const Exercise& exercise, const std::string& code, const Run& run);

}  // namespace learn
