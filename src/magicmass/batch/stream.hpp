// SPDX-License-Identifier: MIT
// The whole sequence of velocities at one alpha. Each is k_0 + k_1 cos(n psi) + k_2 sin(n psi). With n = m + 8 j, where m is one of eight
// neighbours (the anchors), that is k_0 + A cos(8 j psi) + B sin(8 j psi): A and B belong to the anchor, the cosines and sines
// are a table, and j and -j share their products. From block to block the anchors turn as pairs.
//
// Error, with u = 2^-53 and r^2 = k_1^2 + k_2^2 = A^2 + B^2: A, B, the table and the products are good for 3 u r in all (|A cos| + |B sin| <= r),
// k_0 for u |k_0|, and the two sums for u (|k_0| + r) each: 5 u r + 3 u |k_0|. The largest velocity of a body is about r + |k_0|, and never so small
// (worst where C has the most of it to go, at alpha = 0.236) that this is above 5.4 u = 2.7 eps of it. The anchors' angle
// is within 2^-68 of itself, that is of pi, and M blocks later within M 2^-97 more, so that n does not show.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "magicmass/arithmetic/lanes.hpp"
#include "magicmass/arithmetic/tracked.hpp"
#include "magicmass/batch/counts.hpp"
#include "magicmass/batch/turn.hpp"
#include "magicmass/kernels/velocities.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

/// Rows that share an anchor, before and after it, in steps of 8.
inline constexpr std::size_t stream_steps = 16;
inline constexpr std::size_t stream_rows = 16 * stream_steps;

/// cos(8 j psi) and sin(8 j psi).
struct StepTable {
  double cosine[stream_steps + 1];
  double sine[stream_steps + 1];
};

/// k_0, k_1 and k_2 of one velocity.
struct Affine {
  arithmetic::Pair<double> constant, of_cosine, of_sine;
};

/// The rows m - 8 stream_steps to m + 8 stream_steps - 8 of one velocity, for the anchors m of `turn`.
[[gnu::always_inline]] inline void write_around(const Affine& k, const Turn<Doubles>& turn,
                                                const StepTable& table, double* middle) {
  using T = Doubles;
  const auto lanes = [](arithmetic::Pair<double> x) {
    return arithmetic::Pair<T>(T(x.high), T(x.low));
  };
  const auto k_1 = lanes(k.of_cosine), k_2 = lanes(k.of_sine);
  const T A = rounded(k_1 * turn.cosine + k_2 * turn.sine);
  const T B = rounded(k_2 * turn.cosine - k_1 * turn.sine);
  const T constant(rounded(k.constant));
  const auto even = [&](std::size_t j) { return constant + A * T(table.cosine[j]); };
  const auto odd = [&](std::size_t j) { return B * T(table.sine[j]); };
  store(even(0), middle);
  for (std::size_t j = 1; j < stream_steps; ++j) {
    const T x = even(j), y = odd(j);
    store(x + y, middle + 8 * j);
    store(x - y, middle - 8 * j);
  }
  store(even(stream_steps) - odd(stream_steps), middle - 8 * stream_steps);
}

inline Turn<Doubles> in_lanes(const Turn<double>& x) {
  return {{Doubles(x.cosine.high), Doubles(x.cosine.low)},
          {Doubles(x.sine.high), Doubles(x.sine.low)}};
}

/// The eight turns by n psi in the middle of a block.
struct Anchors {
  alignas(64) double cosine_high[8];
  alignas(64) double cosine_low[8];
  alignas(64) double sine_high[8];
  alignas(64) double sine_low[8];

  Anchors(const Turn<double>& first, const Turn<double>& once) {
    Turn<double> turn = first;
    for (std::size_t i = 0; i < 8; ++i, turn = turn * once) {
      cosine_high[i] = turn.cosine.high;
      cosine_low[i] = turn.cosine.low;
      sine_high[i] = turn.sine.high;
      sine_low[i] = turn.sine.low;
    }
  }
  Turn<Doubles> get(std::size_t i) const {
    using arithmetic::load;
    return {{load<Doubles>(cosine_high + i), load<Doubles>(cosine_low + i)},
            {load<Doubles>(sine_high + i), load<Doubles>(sine_low + i)}};
  }
  void put(std::size_t i, const Turn<Doubles>& turn) {
    store(turn.cosine.high, cosine_high + i);
    store(turn.cosine.low, cosine_low + i);
    store(turn.sine.high, sine_high + i);
    store(turn.sine.low, sine_low + i);
  }
};

/// What a stream needs of alpha < 1.
struct Stream {
  using Kernel = generated::VelocitiesKernel<arithmetic::Tracked<double>>;
  static constexpr std::size_t velocities = 4;

  arithmetic::Tracked<double> quarter;  ///< psi/4
  Turn<double> once;                    ///< by psi
  Turn<double> by_half_block;
  Turn<double> by_block;
  StepTable table;
  Affine affine[velocities];

  explicit Stream(double alpha) {
    Kernel kernel;
    kernel.alpha = alpha;
    kernel.n = 0.0;
    kernel.stage_1();
    kernel.stage_2();
    quarter = kernel.angle;
    once = twice_from_half_tangent(kernel.tan_quarter.pair);
    Turn<double> powers[stream_steps + 1] = {Turn<double>::none(), once * once};
    powers[1] = powers[1] * powers[1];
    powers[1] = powers[1] * powers[1];
    for (std::size_t j = 2; j <= stream_steps; ++j) powers[j] = powers[j / 2] * powers[j - j / 2];
    by_half_block = powers[stream_steps];
    by_block = by_half_block * by_half_block;
    for (std::size_t j = 0; j <= stream_steps; ++j) {
      table.cosine[j] = rounded(powers[j].cosine);
      table.sine[j] = rounded(powers[j].sine);
    }
    find_coefficients(kernel);
  }

  /// The generated velocities are quadratic forms p C^2 + q C S + r S^2 in the cosine and sine of n psi/2, that is (p + r)/2 +
  /// (p - r)/2 cos(n psi) + q/2 sin(n psi): three values of each give it.
  void find_coefficients(Kernel& kernel) {
    const auto at = [&kernel](double cosine, double sine) {
      kernel.cosine = arithmetic::Tracked<double>(cosine);
      kernel.sine = arithmetic::Tracked<double>(sine);
      return kernel.result();
    };
    const auto p = at(1.0, 0.0), r = at(0.0, 1.0), sum = at(1.0, 1.0);
    const auto fit = [](const auto& of_p, const auto& of_r, const auto& of_sum) -> Affine {
      const auto at_p = evaluated(of_p).pair, at_r = evaluated(of_r).pair;
      return {scaled(at_p + at_r, 0.5), scaled(at_p - at_r, 0.5),
              scaled(evaluated(of_sum).pair - (at_p + at_r), 0.5)};
    };
    affine[0] = fit(p.a, r.a, sum.a);
    affine[1] = fit(p.b, r.b, sum.b);
    affine[2] = fit(p.c, r.c, sum.c);
    affine[3] = fit(p.c_prime, r.c_prime, sum.c_prime);
  }

  /// By n psi, n from 0 to the last collision; n may have more bits than a double.
  Turn<double> turn(std::int64_t n) const {
    if (n == 0) return Turn<double>::none();
    const double high = static_cast<double>(n >> 32U) * 0x1p32;
    const double low = static_cast<double>(n & 0xffffffff);
    const auto half = sine_cosine(scaled(quarter * high + quarter * low, 2.0));
    const Turn<double> by_half{half.cosine.pair, half.sine.pair};
    return by_half * by_half;
  }

  /// n = first_n, first_n + 1, ..., none past the last collision.
  void write(std::int64_t first_n, double* const (&columns)[velocities], std::size_t size) const {
    Anchors anchors(turn(first_n) * by_half_block, once);
    const Turn<Doubles> step = in_lanes(by_block);
    std::size_t done = 0;
    for (; size - done >= stream_rows; done += stream_rows) {
      for (std::size_t i = 0; i < 8; i += arithmetic::widest) {
        const Turn<Doubles> anchor = anchors.get(i);
        for (std::size_t v = 0; v < velocities; ++v) {
          write_around(affine[v], anchor, table, columns[v] + done + stream_rows / 2 + i);
        }
        anchors.put(i, anchor * step);
      }
    }
    if (done == size) return;
    for (std::size_t v = 0; v < velocities; ++v) {
      alignas(64) double rows[stream_rows];
      for (std::size_t i = 0; i < 8; i += arithmetic::widest) {
        write_around(affine[v], anchors.get(i), table, rows + stream_rows / 2 + i);
      }
      std::memcpy(columns[v] + done, rows, (size - done) * sizeof(double));
    }
  }
};

/// alpha >= 1: one cycle, and it has no A-C collision after it.
inline void write_one_cycle(double alpha, std::int64_t first_n, double* const (&columns)[4],
                            std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    const auto row = generated::VelocitiesKernel<arithmetic::Pair<double>>::evaluate(
        alpha, static_cast<double>(first_n) + static_cast<double>(i));
    columns[0][i] = rounded(row.a);
    columns[1][i] = rounded(row.b);
    columns[2][i] = rounded(row.c);
    columns[3][i] = rounded(row.c_prime);
  }
}

inline void stream_velocities(double alpha, std::int64_t first_n, double* a, double* b, double* c,
                              double* c_prime, std::size_t size) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  double* columns[4] = {a, b, c, c_prime};
  const auto skip = [&](std::size_t rows) {
    for (double*& column : columns) {
      for (std::size_t i = 0; i < rows; ++i) *column++ = nan;
    }
    size -= rows;
  };
  const bool is_ratio = alpha > 0.0 && alpha <= std::numeric_limits<double>::max();
  if (!is_ratio) return skip(size);
  if (first_n < 0) {
    const auto before = -static_cast<std::uint64_t>(first_n);
    skip(before < size ? static_cast<std::size_t>(before) : size);
    first_n = 0;
  }
  std::int64_t last_n, N_B;
  count_block_by_block(&alpha, &last_n, &N_B, 1);
  if (last_n < 0) last_n = std::numeric_limits<std::int64_t>::max();  // too many to count
  if (first_n > last_n) return skip(size);
  const auto rows_left = static_cast<std::uint64_t>(last_n - first_n);
  const std::size_t rows = rows_left < size ? static_cast<std::size_t>(rows_left) + 1 : size;
  if (rows == 0) return;
  if (alpha >= 1.0) {
    write_one_cycle(alpha, first_n, columns, rows);
  } else {
    // below 2^-400 even psi 2^63 is below 2^-136, and a double cannot tell how much
    const Stream stream(alpha < 0x1p-400 ? 0x1p-400 : alpha);
    stream.write(first_n, columns, rows);
    if (first_n == 0) {  // the initial values, exactly
      columns[0][0] = 1.0;
      for (std::size_t v = 1; v < 4; ++v) columns[v][0] = 0.0;
    }
  }
  for (double*& column : columns) column += rows;
  size -= rows;
  skip(size);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
