// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "magicmass/arithmetic/bounded.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/product.hpp"
#include "magicmass/arithmetic/tracked.hpp"

namespace magicmass::arithmetic {

/// Elements that a batch kernel works on stage by stage: few enough for the first-level cache.
inline constexpr std::size_t block_size = 128;

inline namespace MAGICMASS_TARGET {

using BlockOfDoubles = std::array<double, block_size>;

/// A block of numbers between two stages.
template <class Number>
struct Block;

template <class T>
struct Block<Pair<T>> {
  alignas(64) BlockOfDoubles high;
  alignas(64) BlockOfDoubles low;

  Pair<T> get(std::size_t i) const { return {load<T>(&high[i]), load<T>(&low[i])}; }
  void put(std::size_t i, Pair<T> x) {
    store(x.high, &high[i]);
    store(x.low, &low[i]);
  }
  /// As many rows from i on as Row has lanes, rounded.
  template <class Row>
  Row rounded(std::size_t i) const {
    return load<Row>(&high[i]) + load<Row>(&low[i]);
  }
};

template <class T, bool fuses>
struct Block<Tracked<T, fuses>> {
  Block<Pair<T>> pairs;
  alignas(64) BlockOfDoubles sizes;

  Tracked<T, fuses> get(std::size_t i) const { return {pairs.get(i), load<T>(&sizes[i])}; }
  void put(std::size_t i, Tracked<T, fuses> x) {
    pairs.put(i, x.pair);
    store(x.size, &sizes[i]);
  }
  template <class Row>
  Row rounded(std::size_t i) const {
    return pairs.template rounded<Row>(i);
  }
};

/// Where results of that degree go: rounded, ... `store` does nothing where `to` is null, and `put` wants what it said of all results
/// of the elements from i on.
template <class Number>
struct Certainty;

template <class T>
struct Certainty<Pair<T>> {
  struct Known {
    void operator&=(Known) {}
  };

  template <int degree, class Result>
  Known store(Result x, double* to, std::size_t i) {
    if (to != nullptr) arithmetic::store(rounded(x), to + i);
    return {};
  }
  void put(std::size_t, Known) {}
  bool is_all(std::size_t, std::size_t) const { return true; }
};

/// ... and, of numbers that know, whether all of an element's are certainly the nearest doubles: all bits set where so.
template <class T, bool fuses>
struct Certainty<Tracked<T, fuses>> {
  using Known = typename T::Mask;

  alignas(64) std::array<std::int64_t, block_size> all;

  template <int degree>
  Known store(Product<Tracked<T, fuses>> x, double* to, std::size_t i) {
    if (to == nullptr) return Known{} - 1;
    // a power of two changes nothing but the exponent
    const Tracked<T, fuses> product = x.x * x.y;
    arithmetic::store(T(x.scale) * rounded(product), to + i);
    return certainly_rounded(product, degree);
  }
  template <int degree>
  Known store(Tracked<T, fuses> x, double* to, std::size_t i) {
    if (to == nullptr) return Known{} - 1;
    arithmetic::store(rounded(x), to + i);
    return certainly_rounded(x, degree);
  }
  void put(std::size_t i, Known known) { std::memcpy(&all[i], &known, sizeof known); }
  /// Of the elements from first on, before end.
  bool is_all(std::size_t first, std::size_t end) const {
    std::int64_t whole = -1;
    for (std::size_t i = first; i < end; ++i) whole &= all[i];
    return whole == -1;
  }
};

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
