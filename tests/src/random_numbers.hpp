// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace magicmass::testing {

/// Every [check] case makes its own with a fixed seed, so a failure comes back on every run.
using Generator = std::mt19937_64;

/// Whole number from low to high, both included.
inline std::int64_t whole(Generator& generator, std::int64_t low, std::int64_t high) {
  return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
}

/// A double from low to high whose logarithm is uniform.
inline double log_uniform(Generator& generator, double low, double high) {
  return std::exp2(
      std::uniform_real_distribution<double>(std::log2(low), std::log2(high))(generator));
}

/// `size` such doubles of a generator with this seed.
inline std::vector<double> log_uniform(std::uint64_t seed, std::size_t size, double low,
                                       double high) {
  Generator generator(seed);
  std::vector<double> numbers(size);
  for (double& x : numbers) x = log_uniform(generator, low, high);
  return numbers;
}

/// x and the `reach` doubles on either side, in increasing order.
inline std::vector<double> neighbourhood(double x, int reach) {
  std::vector<double> numbers;
  for (int step = 0; step < reach; ++step) {
    x = std::nextafter(x, 0.0);
  }
  for (int step = -reach; step <= reach; ++step) {
    numbers.push_back(x);
    x = std::nextafter(x, HUGE_VAL);
  }
  return numbers;
}

}  // namespace magicmass::testing
