// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace magicmass::report {

/// A stream of numbers that depends on its seed alone: integer arithmetic and correctly rounded sums and products, so
/// every machine and compiler draws the same doubles, which the distributions of <random> do not promise.
/// SplitMix64 (Steele, Lea, Flood 2014): more than good enough to scatter inputs.
class PortableRandom {
public:
  explicit PortableRandom(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  /// Whole number from low to high, both included; 0 <= low <= high < 2^63. The modulo favours some by 2^-63 of their
  /// number at most.
  std::int64_t whole(std::int64_t low, std::int64_t high) {
    const auto span = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<std::int64_t>(next() % span);
  }

  /// Whole number from 1 to high >= 1 with a uniform number of bits.
  std::int64_t log_whole(std::int64_t high) {
    const int longest = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(high)));
    for (;;) {
      const auto bits = static_cast<unsigned>(whole(1, longest));
      const std::uint64_t top = std::uint64_t{1} << (bits - 1);
      const auto drawn = static_cast<std::int64_t>(top | (next() & (top - 1)));
      if (drawn <= high) return drawn;
    }
  }

  /// Any double from low to high, both included and positive, each as likely as the next.
  double ordinal(double low, double high) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(
        whole(std::bit_cast<std::int64_t>(low), std::bit_cast<std::int64_t>(high))));
  }

  /// A normal double from low to high, both positive and normal, with its logarithm uniform but for 0.3 %: a uniform
  /// exponent and 1 + u (0.6565 + 0.3435 u) for 2^u.
  double log_uniform(double low, double high) {
    int first = 0;
    int last = 0;
    std::frexp(low, &first);
    std::frexp(high, &last);
    for (;;) {
      const int exponent = first + static_cast<int>(whole(0, last - first));
      const double u = static_cast<double>(next() >> 11U) * 0x1p-53;
      const double mantissa = 1.0 + u * (0.6565 + 0.3435 * u);
      const double drawn = std::ldexp(mantissa / 2, exponent);
      if (drawn >= low && drawn <= high) return drawn;
    }
  }

private:
  std::uint64_t state_;
};

}  // namespace magicmass::report
