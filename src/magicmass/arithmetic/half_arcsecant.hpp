// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/root_arcsecant_table.hpp"
#include "magicmass/arithmetic/table_node.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// asec(1 + x)/2 = sqrt(x) F(x) for 0 < x <= 1: F is analytic, and of x itself nothing has been rounded.
struct HalfArcsecant {
  double root;     ///< sqrt(x), rounded
  double at_node;  ///< F(c), rounded, for c = j/256 next to x
  double rest;     ///< F(x) less that
  double early;    ///< F(x) within 2^-19 of itself, known before
};
/// `usual` is an x from 2^-120 on.
template <bool usual>
[[gnu::always_inline]] inline HalfArcsecant half_arcsecant_parts(double x) {
  if constexpr (!usual) {
    // F is F(0), and below this the powers of x would leave the normal doubles, which takes processors long. So does a root of what
    // has left them: that of a whole number of 2^-1074 in its place.
    if (x < 0x1p-120) [[unlikely]]
      return {x < 0x1p-1022
                  ? square_root(static_cast<double>(std::bit_cast<std::int64_t>(x))) * 0x1p-537
                  : square_root(x),
              root_arcsecant_table[0], root_arcsecant_table[1], root_arcsecant_table[0]};
  }
  const double root = square_root(x);
  // F(x) - F(c) is at most 2^-9 0.3; what is rounded there, at 2^-53 of itself each, is four operations: 2^-60.9 of F(x), which
  // is 0.52 to 0.71, and 2^-51.8 x of it where j = 0, as F(0) is exact to 2^-107. The polynomial adds 2^-66.
  const TableNode node = table_node_inside<8>(root_arcsecant_table, x);
  const double d = node.rest;
  const double* row = node.row;
  const double square = d * d;
  const double line = row[1] + row[2] * d;
  const double rest = (line + square * (row[3] + row[4] * d)) +
                      (square * square) * ((row[5] + row[6] * d) + square * row[7]);
  return {root, row[0], rest, row[0] + line};
}

/// asec(1 + x)/2 for 0 < x <= 1, within 2.01 2^-53 of itself: the root's rounding and the last one.
[[gnu::always_inline]] inline double rounded_half_arcsecant_of(double x) {
  const HalfArcsecant made = half_arcsecant_parts<false>(x);
  const Sum<double> product = two_product(made.root, made.at_node);
  return product.high + (product.low + made.root * made.rest);
}

/// asec(1 + x)/2 for 2^-900 <= x <= 1, within the lesser of 2^-60 and 2^-51 x + 2^-100 of itself; its low part is at most 2^-52 of
/// it.
[[gnu::always_inline]] inline Pair<double> half_arcsecant_in_range(HalfArcsecant made, double x) {
  // sqrt(x) = s + (x - s^2)/(2 s) within 2^-108: the difference is exact, 1/s = s (1/x) does not wait for the root. The high part does
  // not wait for what that adds, at most 2^-53 of it.
  const double s = made.root;
  const double s_low = (0.5 * less_product(x, s, s)) * (s * (1.0 / x));
  const Sum<double> product = two_product(s, made.at_node);
  const Pair<double> of_s = normalised(Pair<double>(product.high, product.low + s * made.rest));
  return {of_s.high, of_s.low + s_low * (made.at_node + made.rest)};
}

/// The same for every x up to 1.
[[gnu::always_inline]] inline Pair<double> half_arcsecant_of(double x) {
  // down there F is F(0), and a power of 4 moves x, exactly
  if (x < 0x1p-900) [[unlikely]] {
    const double moved = x * 0x1p200;
    return scaled(half_arcsecant_in_range(half_arcsecant_parts<false>(moved), moved), 0x1p-100);
  }
  return half_arcsecant_in_range(half_arcsecant_parts<false>(x), x);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
