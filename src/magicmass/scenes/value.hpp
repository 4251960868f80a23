// SPDX-License-Identifier: MIT
// A number as a scene writes it, kept as it was written: what it is worth is decided where exact arithmetic is.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass {

/// Whole numbers, + - * / ^ (whole exponent), sqrt(whole number) and parentheses: "1/7", "sqrt(5)-2", "100^6".
/// Well-formed, and no more is known: it may divide by zero or leave every quadratic field.
struct Expression {
  std::string text;  ///< as it was written

  /// The same text.
  friend bool operator==(const Expression&, const Expression&) = default;
};

/// A double stands for itself, exactly; so does everything else.
using Value = std::variant<double, Expression, Magic, Deficient>;

/// Longest text parse_value reads, in characters.
inline constexpr std::size_t longest_value_text = 4096;

/// What parse_value takes, for messages.
inline constexpr std::string_view allowed_values =
    "a number, or a string with a decimal, a hex float, a fraction like \"1/7\", an expression of "
    "whole numbers "
    "and one square root like \"sqrt(5)-2\" or \"100^6\", \"magic:k\" or \"deficient:k\"";

/// Reads a value. A decimal point, an exponent or 0x makes it a double; else it is an expression.
/// Throws InvalidInput, one line that says what was wrong.
Value parse_value(std::string_view text);

/// Text that parse_value reads back as the same value.
std::string to_text(const Value& value);

}  // namespace magicmass
