// SPDX-License-Identifier: MIT
// The mass ratio alpha = m/M as a user writes it. Unit 1; always positive and finite.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace magicmass {

/// The exact rational numerator/denominator: decimal digits, no sign, no leading zero, both positive, not reduced.
struct Fraction {
  std::string numerator;    ///< above the line
  std::string denominator;  ///< below it

  /// The same digits.
  friend bool operator==(const Fraction&, const Fraction&) = default;
};

/// The k-th magic mass ratio of the paper, k >= 1 (irrational but for k = 1).
struct Magic {
  std::int64_t k = 1;  ///< its number

  /// The same k.
  friend bool operator==(const Magic&, const Magic&) = default;
};

/// The k-th deficient mass ratio of the paper, k >= 1 (irrational for every k).
struct Deficient {
  std::int64_t k = 1;  ///< its number

  /// The same k.
  friend bool operator==(const Deficient&, const Deficient&) = default;
};

/// A double stands for itself, exactly.
using MassRatio = std::variant<double, Fraction, Magic, Deficient>;

/// Longest text parse_mass_ratio reads, in characters.
inline constexpr std::size_t longest_mass_ratio_text = 4096;

/// Reads a decimal ("0.1", "1e-9") or C hex float ("0x1.8p-3") as the nearest double whatever the locale,
/// "p/q" as the exact fraction, "magic:k" and "deficient:k" as those ratios. No sign, no blanks.
/// Throws InvalidInput, with one line that says what was wrong and what is allowed.
MassRatio parse_mass_ratio(std::string_view text);

/// Text that parse_mass_ratio reads back as the same value; doubles are the shortest such decimal.
std::string to_text(const MassRatio& alpha);

}  // namespace magicmass
