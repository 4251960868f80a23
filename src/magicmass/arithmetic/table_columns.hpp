// SPDX-License-Identifier: MIT
// Rows of tables with 256 a unit, in every lane another. Processors gather no faster than they load row by row, and some far
// slower.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include <immintrin.h>

#include "magicmass/arithmetic/lanes.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// The multiple of 2^-8 nearest to x, |x| < 2^40, and its place in a table from 0 on: the last 32 bits of a double.
template <class T>
struct NearestNode {
  T place;
  T at;
};
template <class T>
[[gnu::always_inline]] inline NearestNode<T> nearest_node(T x) {
  const T shift(0x1.8p44);  // its last bit is 2^-8
  const T place = x + shift;
  return {place, place - shift};
}

/// The columns of a table that has as many, in the rows at places from 0 on.
template <class T>
struct TwoColumns {
  T first;
  T second;
};
template <class T>
struct FourColumns {
  T first;
  T second;
  T third;
  T fourth;
};

/// Where the rows begin.
template <int columns>
[[gnu::always_inline]] inline const double* row_at(const double* table, std::uint64_t place) {
  return table + columns * static_cast<std::uint32_t>(place);
}
template <int columns, int N>
struct RowsAt {
  const double* table;
  alignas(64) std::uint64_t places[N];

  [[gnu::always_inline]] RowsAt(const double* of_table, Lanes<N> place) : table(of_table) {
    std::memcpy(places, &place, sizeof place);
    // by way of memory: out of a register each would take two operations
    asm("" : "+m"(places));
  }
  [[gnu::always_inline]] const double* operator[](int lane) const {
    return row_at<columns>(table, places[lane]);
  }
};

[[gnu::always_inline]] inline TwoColumns<double> two_columns(const double* table, double place) {
  const double* row = row_at<2>(table, std::bit_cast<std::uint64_t>(place));
  return {row[0], row[1]};
}
[[gnu::always_inline]] inline FourColumns<double> four_columns(const double* table, double place) {
  const double* row = row_at<4>(table, std::bit_cast<std::uint64_t>(place));
  return {row[0], row[1], row[2], row[3]};
}

[[gnu::always_inline]] inline TwoColumns<Lanes<2>> transposed(__m128d even, __m128d odd) {
  return {_mm_unpacklo_pd(even, odd), _mm_unpackhi_pd(even, odd)};
}
[[gnu::always_inline]] inline TwoColumns<Lanes<2>> two_columns(const double* table,
                                                               Lanes<2> place) {
  const RowsAt<2, 2> rows(table, place);
  return transposed(_mm_loadu_pd(rows[0]), _mm_loadu_pd(rows[1]));
}
[[gnu::always_inline]] inline FourColumns<Lanes<2>> four_columns(const double* table,
                                                                 Lanes<2> place) {
  const RowsAt<4, 2> rows(table, place);
  const TwoColumns<Lanes<2>> left = transposed(_mm_loadu_pd(rows[0]), _mm_loadu_pd(rows[1]));
  const TwoColumns<Lanes<2>> right =
      transposed(_mm_loadu_pd(rows[0] + 2), _mm_loadu_pd(rows[1] + 2));
  return {left.first, left.second, right.first, right.second};
}

#ifdef __AVX2__
/// Two rows of two doubles, one above the other.
[[gnu::always_inline]] inline __m256d stacked(const double* below, const double* above) {
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(below)), _mm_loadu_pd(above), 1);
}
[[gnu::always_inline]] inline TwoColumns<Lanes<4>> two_columns(const double* table,
                                                               Lanes<4> place) {
  const RowsAt<2, 4> rows(table, place);
  const __m256d even = stacked(rows[0], rows[2]), odd = stacked(rows[1], rows[3]);
  return {_mm256_unpacklo_pd(even, odd), _mm256_unpackhi_pd(even, odd)};
}
[[gnu::always_inline]] inline FourColumns<Lanes<4>> four_columns(const double* table,
                                                                 Lanes<4> place) {
  const RowsAt<4, 4> rows(table, place);
  const __m256d left_even = stacked(rows[0], rows[2]), left_odd = stacked(rows[1], rows[3]);
  const __m256d right_even = stacked(rows[0] + 2, rows[2] + 2);
  const __m256d right_odd = stacked(rows[1] + 2, rows[3] + 2);
  return {_mm256_unpacklo_pd(left_even, left_odd), _mm256_unpackhi_pd(left_even, left_odd),
          _mm256_unpacklo_pd(right_even, right_odd), _mm256_unpackhi_pd(right_even, right_odd)};
}
#endif

#ifdef __AVX512F__
[[gnu::always_inline]] inline TwoColumns<Lanes<8>> two_columns(const double* table,
                                                               Lanes<8> place) {
  const RowsAt<2, 8> rows(table, place);
  const auto four_pairs = [&](int first) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(stacked(rows[first], rows[first + 2])),
                              stacked(rows[first + 4], rows[first + 6]), 1);
  };
  const __m512d even = four_pairs(0), odd = four_pairs(1);
  return {_mm512_unpacklo_pd(even, odd), _mm512_unpackhi_pd(even, odd)};
}
[[gnu::always_inline]] inline FourColumns<Lanes<8>> four_columns(const double* table,
                                                                 Lanes<8> place) {
  const RowsAt<4, 8> rows(table, place);
  const auto two_rows = [&](int first) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(rows[first])),
                              _mm256_loadu_pd(rows[first + 2]), 1);
  };
  const __m512d of_0_2 = two_rows(0), of_1_3 = two_rows(1), of_4_6 = two_rows(4),
                of_5_7 = two_rows(5);
  // columns 1 and 3, and 2 and 4, of rows 0 to 3 and of rows 4 to 7
  const __m512d odd_low = _mm512_unpacklo_pd(of_0_2, of_1_3);
  const __m512d odd_high = _mm512_unpacklo_pd(of_4_6, of_5_7);
  const __m512d even_low = _mm512_unpackhi_pd(of_0_2, of_1_3);
  const __m512d even_high = _mm512_unpackhi_pd(of_4_6, of_5_7);
  return {_mm512_shuffle_f64x2(odd_low, odd_high, 0x88),
          _mm512_shuffle_f64x2(even_low, even_high, 0x88),
          _mm512_shuffle_f64x2(odd_low, odd_high, 0xdd),
          _mm512_shuffle_f64x2(even_low, even_high, 0xdd)};
}
#endif

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
