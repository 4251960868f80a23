// SPDX-License-Identifier: GPL-2.0-or-later
// Random numbers that are the same on every machine: whole numbers and exactly rounded operations.
#pragma once

#include <bit>
#include <cstdint>
#include <random>

namespace report {

/// The standard fixes what its engines give, not what its distributions do.
class PortableRandom {
public:
  explicit PortableRandom(std::uint64_t seed) : engine_(seed) {}

  /// From low to high, both included; 0 <= low <= high < 2^63.
  std::int64_t whole(std::int64_t low, std::int64_t high) {
    return low + std::int64_t(engine_() % (std::uint64_t(high - low) + 1));
  }
  /// From 1 to high >= 1, with a uniform number of bits.
  std::int64_t log_whole(std::int64_t high) {
    const int longest = int(std::bit_width(std::uint64_t(high)));
    for (;;) {
      const std::uint64_t top = std::uint64_t{1} << (whole(1, longest) - 1);
      const auto drawn = std::int64_t(top | (engine_() & (top - 1)));
      if (drawn <= high) return drawn;
    }
  }
  /// A double from low to high, both included and positive, each as likely as the next: in the
  /// normal range its logarithm is uniform but for some percent of a factor of 2.
  double among(double low, double high) {
    return std::bit_cast<double>(
        whole(std::bit_cast<std::int64_t>(low), std::bit_cast<std::int64_t>(high)));
  }

private:
  std::mt19937_64 engine_;
};

}  // namespace report
