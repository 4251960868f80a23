// SPDX-License-Identifier: MIT
#include "magicmass/scenes/value.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/expression_grammar.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass {
namespace {

/// Computes nothing: only the grammar is checked.
struct Unvalued {
  struct Number {};
  static Number number(const std::string& /*digits*/) { return {}; }
  static Number negated(Number /*x*/) { return {}; }
  static Number added(Number /*x*/, Number /*y*/) { return {}; }
  static Number subtracted(Number /*x*/, Number /*y*/) { return {}; }
  static Number multiplied(Number /*x*/, Number /*y*/) { return {}; }
  static Number divided(Number /*x*/, Number /*y*/) { return {}; }
  static Number raised(Number /*x*/, const std::string& /*exponent*/) { return {}; }
  static Number root(const std::string& /*radicand*/) { return {}; }
};

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw InvalidInput("got \"" + shown_text(text) + "\": " + why);
}

/// A double with a sign; zero is fine.
double signed_double(std::string_view text) {
  const bool negative = text.starts_with('-');
  const std::string_view size = text.substr(negative ? 1 : 0);
  const bool hex = size.starts_with("0x") || size.starts_with("0X");
  const std::string_view digits = size.substr(hex ? 2 : 0);
  const bool starts_well =
      !digits.empty() && digits.find_first_of(hex ? ".0123456789abcdefABCDEF" : ".0123456789") == 0;
  double value = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(
      digits.data(), end, value, hex ? std::chars_format::hex : std::chars_format::general);
  if (!starts_well || stop != end || error == std::errc::invalid_argument)
    refuse(text, "not a number");
  if (error == std::errc::result_out_of_range || !std::isfinite(value))
    refuse(text, "it does not fit a double; write it as a fraction");
  return negative ? -value : value;
}

bool is_float(std::string_view text) {
  const bool hex =
      text.find("0x") != std::string_view::npos || text.find("0X") != std::string_view::npos;
  return hex || (text.find_first_of(".eE") != std::string_view::npos &&
                 text.find_first_of("()/*^") == std::string_view::npos);
}

}  // namespace

Value parse_value(std::string_view text) {
  if (text.empty()) throw InvalidInput("got the empty text");
  if (text.size() > longest_value_text)
    throw InvalidInput("got " + std::to_string(text.size()) + " characters; a value has at most " +
                       std::to_string(longest_value_text));
  if (text.starts_with("magic:") || text.starts_with("deficient:")) {
    const MassRatio ratio = parse_mass_ratio(text);
    if (const auto* magic = std::get_if<Magic>(&ratio)) return *magic;
    return std::get<Deficient>(ratio);
  }
  if (is_float(text)) return signed_double(text);
  try {
    ExpressionReader<Unvalued>(text, Unvalued{}).read();
  } catch (const InvalidInput& error) {
    refuse(text, error.what());
  }
  return Expression{std::string(text)};
}

std::string to_text(const Value& value) {
  if (const auto* expression = std::get_if<Expression>(&value)) return expression->text;
  if (const auto* magic = std::get_if<Magic>(&value)) return "magic:" + std::to_string(magic->k);
  if (const auto* deficient = std::get_if<Deficient>(&value))
    return "deficient:" + std::to_string(deficient->k);
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), std::get<double>(value)).ptr;
  std::string shortest(text.data(), end);
  if (shortest.find_first_of(".e") == std::string::npos) shortest += ".0";  // else an expression
  return shortest;
}

}  // namespace magicmass
