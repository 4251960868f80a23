// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "magicmass/errors.hpp"

namespace magicmass::equality {

/// The text is no expression, or too large a one; the message is one line and begins with the column.
struct NotAnExpression : InvalidInput {
  using InvalidInput::InvalidInput;
};

/// A word of an expression.
struct Token {
  /// What a word can be.
  enum class Kind {
    number,
    name,
    sign,
    end
  };                   ///< sign: one of + - * / ^ ( ) , < > = or "<=" ">=" "!="
  Kind kind;           ///< what it is
  std::string text;    ///< in ASCII
  std::size_t column;  ///< in characters, from 1
};

/// Throws NotAnExpression: "column 7: reason".
[[noreturn]] void refuse_at(std::size_t column, const std::string& reason);

/// ASCII, and what people paste: pi and other Greek letters, the root sign, dots and crosses for products, long
/// minus signs, superscripts, relations. The last token is the end. Throws NotAnExpression.
std::vector<Token> tokens(std::string_view text, std::size_t longest);

}  // namespace magicmass::equality
