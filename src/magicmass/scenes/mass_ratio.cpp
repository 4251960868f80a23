// SPDX-License-Identifier: MIT
#include "magicmass/scenes/mass_ratio.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <system_error>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass {
namespace {

constexpr std::string_view allowed =
    "; allowed: a decimal like 0.1 or 1e-9, a hex float like 0x1.8p-3, a fraction like 1/7, "
    "magic:k or deficient:k";

bool is_digits(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

[[noreturn]] void refuse_value(std::string_view text) {
  throw InvalidInput("alpha must be a positive finite number, got " + shown_text(text));
}

[[noreturn]] void refuse_form(std::string_view text) {
  throw InvalidInput("alpha is not a number: \"" + shown_text(text) + '"' + std::string(allowed));
}

std::string without_leading_zeros(std::string_view digits) {
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  return std::string(digits.substr(first));
}

Fraction parse_fraction(std::string_view text, std::size_t slash) {
  std::string_view above = text.substr(0, slash);
  std::string_view below = text.substr(slash + 1);
  const bool negative = above.starts_with('-') != below.starts_with('-');
  above.remove_prefix(above.starts_with('-') ? 1 : 0);
  below.remove_prefix(below.starts_with('-') ? 1 : 0);
  if (!is_digits(above) || !is_digits(below)) {
    throw InvalidInput("alpha is not a fraction: \"" + shown_text(text) +
                       "\"; numerator and denominator must be whole decimal numbers, like 1/7");
  }
  Fraction fraction{without_leading_zeros(above), without_leading_zeros(below)};
  if (fraction.denominator == "0") {
    throw InvalidInput("alpha divides by zero: " + shown_text(text));
  }
  if (negative || fraction.numerator == "0") {
    refuse_value(text);
  }
  if (text.find('-') != std::string_view::npos) {
    refuse_form(text);
  }
  return fraction;
}

std::int64_t parse_index(std::string_view text, std::string_view name) {
  const std::string_view digits = text.substr(name.size());
  std::int64_t k = 0;
  const bool fits =
      is_digits(digits) &&
      std::from_chars(digits.data(), digits.data() + digits.size(), k).ec == std::errc{};
  if (!fits || k < 1) {
    throw InvalidInput(std::string(name) +
                       "k needs a whole number k from 1 to 9223372036854775807, got " +
                       shown_text(text));
  }
  return k;
}

bool is_one_of_ignoring_case(std::string_view text,
                             std::initializer_list<std::string_view> lowercase_words) {
  const auto same = [](char c, char lowercase) {
    return c == lowercase || c == lowercase - 'a' + 'A';
  };
  return std::any_of(lowercase_words.begin(), lowercase_words.end(), [&](std::string_view word) {
    return std::equal(text.begin(), text.end(), word.begin(), word.end(), same);
  });
}

/// The part of an unsigned decimal or hex float before its exponent has a digit that is not zero.
bool has_nonzero_digit(std::string_view mantissa, std::string_view exponent_marks) {
  const std::string_view digits = mantissa.substr(0, mantissa.find_first_of(exponent_marks));
  return digits.find_first_not_of("0.") != std::string_view::npos;
}

double parse_double(std::string_view text) {
  std::string_view number = text;
  const bool negative = number.starts_with('-');
  number.remove_prefix(negative ? 1 : 0);
  if (is_one_of_ignoring_case(number, {"inf", "infinity", "nan"})) {
    refuse_value(text);
  }
  const bool is_hex = number.starts_with("0x") || number.starts_with("0X");
  number.remove_prefix(is_hex ? 2 : 0);
  // from_chars would also take a second sign, and inf and nan after 0x: the first character rules them out.
  const bool starts_well =
      !number.empty() &&
      number.find_first_of(is_hex ? ".0123456789abcdefABCDEF" : ".0123456789") == 0;
  if (!starts_well || number.find_first_of("nN") != std::string_view::npos) {
    refuse_form(text);
  }
  double value = 0.0;
  const char* const end = number.data() + number.size();
  const auto [stop, error] = std::from_chars(
      number.data(), end, value, is_hex ? std::chars_format::hex : std::chars_format::general);
  if (stop != end || error == std::errc::invalid_argument) {
    refuse_form(text);
  }
  const bool is_zero = !has_nonzero_digit(number, is_hex ? "pP" : "eE");
  if (negative || is_zero) {
    refuse_value(text);
  }
  if (error == std::errc::result_out_of_range || value == 0.0 || !std::isfinite(value)) {
    throw InvalidInput("alpha does not fit a double: " + shown_text(text) +
                       "; doubles reach from 5e-324 to 1.8e308: write it as a fraction p/q");
  }
  return value;
}

}  // namespace

MassRatio parse_mass_ratio(std::string_view text) {
  if (text.empty()) {
    throw InvalidInput("alpha is empty" + std::string(allowed));
  }
  if (text.size() > longest_mass_ratio_text) {
    throw InvalidInput("alpha is " + std::to_string(text.size()) +
                       " characters long; allowed: up to " +
                       std::to_string(longest_mass_ratio_text));
  }
  if (text.starts_with("magic:")) {
    return Magic{parse_index(text, "magic:")};
  }
  if (text.starts_with("deficient:")) {
    return Deficient{parse_index(text, "deficient:")};
  }
  if (const std::size_t slash = text.find('/'); slash != std::string_view::npos) {
    return parse_fraction(text, slash);
  }
  return parse_double(text);
}

std::string to_text(const MassRatio& alpha) {
  if (const auto* fraction = std::get_if<Fraction>(&alpha)) {
    return fraction->numerator + "/" + fraction->denominator;
  }
  if (const auto* magic = std::get_if<Magic>(&alpha)) {
    return "magic:" + std::to_string(magic->k);
  }
  if (const auto* deficient = std::get_if<Deficient>(&alpha)) {
    return "deficient:" + std::to_string(deficient->k);
  }
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), std::get<double>(alpha)).ptr;
  return {text.data(), end};
}

}  // namespace magicmass
