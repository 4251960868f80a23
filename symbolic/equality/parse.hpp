// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "equality/expression.hpp"
#include "equality/tokens.hpp"

namespace magicmass::equality {

/// What an expression may not exceed. Sizes are known before anything is computed.
struct Limits {
  std::size_t characters = 20000;  ///< of the text
  int nesting = 200;               ///< of parentheses, functions and exponents
  std::size_t nodes = 5000;        ///< numbers, names and operations
  long bits = 70000;      ///< of a rational number's numerator or denominator: 21000 digits
  long exponent = 10000;  ///< of anything but a rational number
  std::vector<std::string> symbols = {};  ///< names before ( that are factors and no functions
};

/// Integers, decimals (exact: 0.1 is 1/10), + - * / ^ (or **), pi, names, functions; a product's sign may be left
/// out where that is not ambiguous: 2(2 + alpha). Throws NotAnExpression: "column 7: unknown function foo; ...".
Tree parse(std::string_view text, const Limits& limits = {});

/// The functions that can be called, by name.
const std::vector<std::string>& function_names();

/// Two expressions and < <= > >= = != between them; and chains of them: 0 < alpha <= 1.
struct Comparison {
  Tree left;             ///< one side
  std::string relation;  ///< "<", "<=", ">", ">=", "=" or "!="
  Tree right;            ///< the other side
};
/// Throws NotAnExpression.
std::vector<Comparison> parse_comparisons(std::string_view text, const Limits& limits = {});

}  // namespace magicmass::equality
