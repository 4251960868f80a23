// SPDX-License-Identifier: GPL-2.0-or-later
// Expressions of exercises and answers, on their way to the kernel of `equal`.
#pragma once

#include <string>
#include <vector>

#include "command/learn/exercise.hpp"
#include "equality/bounded.hpp"
#include "equality/expression.hpp"
#include "magicmass/errors.hpp"
#include "render/formula_text.hpp"

namespace magicmass::command {

/// The answer cannot be read; the message says why and what would do.
struct NotUnderstood : InvalidInput {
  using InvalidInput::InvalidInput;
};

/// What a student typed, LaTeX too. Throws NotUnderstood for what is no expression, and for symbols that are not
/// `allowed` (all are if that is empty).
equality::Tree read_answer(const std::string& typed, const std::vector<std::string>& allowed);

/// An expression of the content. Throws InvalidInput that begins with `place`.
equality::Tree read_content(const std::string& text, const std::string& place);

/// Defined names written out, and values put in for their names.
equality::Tree with_values(const equality::Tree& tree, const Values& values);

/// Every key of `replace` replaced at the same time, in names that are defined by others, too.
equality::Tree replaced(const equality::Tree& tree, const Values& replace,
                        const std::string& place);

/// The kernel's verdict on two expressions whose values are filled in; conditions on symbols that are in neither are
/// left out. "undecided" where the kernel refuses the question.
equality::Verdict decided(const equality::Tree& left, const equality::Tree& right,
                          const std::vector<std::string>& domain);

bool are_equal(const equality::Tree& left, const equality::Tree& right,
               const std::vector<std::string>& domain);

/// Whether relations between constants, separated by commas, hold, certainly.
bool holds(const std::string& relations, const Values& values, const std::string& place);

/// So many digits of a constant: "0.2361".
std::string digits_of(const equality::Tree& constant, int digits, const std::string& place);

/// The expression for a reader, on one line.
std::string shown(const equality::Tree& tree, const render::TextStyle& style);

/// "at alpha = 1, n = 1 yours is 1/3, where it should be 2/3."; for constants "yours is 0.333..., which is too small."
std::string shown(const equality::Counterexample& counterexample);

}  // namespace magicmass::command
