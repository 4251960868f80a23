// The public functions by tier, the kernels under them, and tables of their inputs and results.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/fast.hpp"
#include "magicmass/numbers/ladder.hpp"

namespace magicmass::testing {
/// The public functions of a tier.
struct Calls {
  std::string name;
  Velocities (*velocities)(double, std::int64_t);
  std::optional<Terminal> (*terminal)(double);
  Collision (*collision)(double, std::int64_t);
  double (*angle)(double);
  Ratios (*ratios)(std::int64_t);
  void (*velocity_rows)(std::span<const double>, std::span<const std::int64_t>,
                        const VelocityColumns&);
  void (*terminal_rows)(std::span<const double>, const TerminalColumns&);
};
/// In the order of numbers::Tier.
inline const Calls tiers[]{
    {"fast", fast::velocities, fast::terminal, fast::collision, fast::angle, fast::ratios,
     fast::velocities, fast::terminal},
    {"accurate", accurate::velocities, accurate::terminal, accurate::collision, accurate::angle,
     accurate::ratios, accurate::velocities, accurate::terminal}};

/// Those that this processor can run.
inline std::vector<const numbers::Kernels*> all_kernels() {
  std::vector<const numbers::Kernels*> all;
  for (const char* name : {"baseline", "avx2", "avx512"})
    if (const auto* kernels = numbers::kernels_named(name)) all.push_back(kernels);
  return all;
}

/// Inputs and columns of a, b, c, c', a_t, b_t, c_t, rho; of N_A, N_B.
struct Table {
  explicit Table(std::size_t rows) : alpha(rows), n(rows) {
    values.fill(alpha);
    counts.fill(n);
  }
  VelocityColumns velocities() { return {values[0], values[1], values[2], values[3]}; }
  TerminalColumns terminal() {
    return {counts[0], counts[1], values[4], values[5], values[6], values[7]};
  }
  void fill(const Calls& tier) {
    tier.velocity_rows(alpha, n, velocities());
    tier.terminal_rows(alpha, terminal());
  }
  Velocities velocities(std::size_t i) const {
    return {values[0][i], values[1][i], values[2][i], values[3][i]};
  }
  Terminal terminal(std::size_t i) const {
    return {{counts[0][i], counts[1][i]}, values[4][i], values[5][i], values[6][i], values[7][i]};
  }
  /// For a kernel, from row i on.
  numbers::VelocityRows velocities_from(std::size_t i) {
    return {&alpha[i], &n[i], &values[0][i], &values[1][i], &values[2][i], &values[3][i]};
  }
  numbers::TerminalRows terminal_from(std::size_t i) {
    return {&alpha[i],     &counts[0][i], &counts[1][i], &values[4][i],
            &values[5][i], &values[6][i], &values[7][i]};
  }
  std::vector<double> alpha;  // first: the others are made of them
  std::vector<std::int64_t> n;
  std::array<std::vector<double>, 8> values;
  std::array<std::vector<std::int64_t>, 2> counts;
};

/// All bits of 4000 rows of both tiers' arrays: g++ 12 and clang 14 agree, x86-64 and aarch64.
constexpr std::uint64_t pinned_fingerprint = 0x5715f31315d49271;

inline std::uint64_t fingerprint() {
  constexpr std::size_t rows = 4000;
  std::mt19937_64 random(43);
  Table in(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const int exponent = int(random() % 20);
    in.alpha[row] = std::ldexp(double(1 + (random() >> 11)), -53 - exponent);
    const std::int64_t some = 1 + std::int64_t(random() % 2);
    in.n[row] = in.alpha[row] < 0.4 ? some : 1;
  }
  std::array<Table, 2> both{in, in};
  both[0].fill(tiers[numbers::accurate]);
  both[1].fill(tiers[numbers::fast]);
  std::uint64_t bits = 0;
  for (std::size_t row = 0; row < rows; ++row)
    for (const Table& tier : both) {
      for (const auto& column : tier.values)
        bits = bits * 6364136223846793005U + std::bit_cast<std::uint64_t>(column[row]);
      bits += std::uint64_t(tier.counts[0][row] + 3 * tier.counts[1][row]);
    }
  return bits;
}
}  // namespace magicmass::testing
