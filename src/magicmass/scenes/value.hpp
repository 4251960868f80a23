// SPDX-License-Identifier: GPL-2.0-or-later
// A number as a scene writes it, kept as what it is; and balls, with as many bits as it takes.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "balls/quadratic.hpp"
#include "magicmass/numbers/errors.hpp"
#include "notation/alpha.hpp"

namespace magicmass::scenes {

using balls::Ball;
using balls::decimal;
using balls::exact;
using balls::nearest_double;
using balls::NotCertain;
using balls::Quadratic;

struct Value {
  std::string text;  ///< as it was written
  /// alpha_k or beta_k where it is in no quadratic field.
  std::variant<Quadratic, notation::Threshold> number;

  const Quadratic* exact() const { return std::get_if<Quadratic>(&number); }
  bool is(const Quadratic& x) const { return exact() != nullptr && *exact() == x; }
  const notation::Threshold* ratio() const { return std::get_if<notation::Threshold>(&number); }
  /// The nearest double. Throws Undecided where none is near.
  double to_double() const;
};

/// It as a double, or as what it is, which must be exact.
template <class Scalar>
Scalar number_of(const Value& value) {
  if constexpr (std::same_as<Scalar, double>)
    return value.to_double();
  else
    return *value.exact();
}

/// x - y, where it is known to be a value.
std::optional<Value> difference(const Value& x, const Value& y);
/// x / y, where it is known exactly.
std::optional<Quadratic> quotient(const Value& x, const Value& y);

/// What read_value takes, for messages.
inline constexpr std::string_view allowed_values =
    "a number, or in quotes a fraction 1/7, whole numbers with + - * / ^ and one square root like "
    "sqrt(5)-2, a hex float like 0x1.8p-3, magic:k, deficient:k";

/// A decimal point, an exponent or 0x: the nearest double. Else whole numbers, exactly.
/// Throws InvalidInput, one line that says what was wrong.
Value read_value(std::string_view text);
/// A number that TOML has read.
Value value_of(double number);
Value value_of(const notation::Alpha& ratio);

/// Throws Undecided for a ratio of the paper whose number is above 2^50.
Ball ball_of(const Value& value);

/// What is computed, with more and more bits until it is something. Throws Undecided, so many "bits
/// would be needed" and `otherwise`, where many times the bits of `digits` decimal digits are too
/// few.
template <class Compute>
auto with_bits(int digits, const Compute& compute, const std::string& otherwise = "") {
  const int wanted = 4 * digits;
  const int most = 8192 + 4 * wanted;  // a double near 2^-1074 with its count takes some 3,000
  for (int bits = 128 + wanted; bits <= most; bits *= 2) {
    Ball::set_bits(bits);
    try {
      if (const auto result = std::optional(compute())) return *result;
    } catch (const NotCertain&) {
    }
  }
  throw Undecided("more than " + std::to_string(most) + " bits would be needed" + otherwise);
}

}  // namespace magicmass::scenes
