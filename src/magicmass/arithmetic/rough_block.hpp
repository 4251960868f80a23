// SPDX-License-Identifier: MIT
// Blocks of rough numbers between two stages, and where their results go.
#pragma once

#include <cstddef>

#include "magicmass/arithmetic/block.hpp"
#include "magicmass/arithmetic/rough.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

template <class T>
struct Block<Rough<T>> {
  alignas(64) BlockOfDoubles high;
  alignas(64) BlockOfDoubles low;

  Rough<T> get(std::size_t i) const { return {load<T>(&high[i]), load<T>(&low[i])}; }
  void put(std::size_t i, Rough<T> x) {
    store(x.high, &high[i]);
    store(x.low, &low[i]);
  }
};

template <class T>
struct Block<Angle<T>> {
  alignas(64) BlockOfDoubles high;
  alignas(64) BlockOfDoubles low;

  Angle<T> get(std::size_t i) const { return {load<T>(&high[i]), load<T>(&low[i])}; }
  void put(std::size_t i, Angle<T> x) {
    store(x.high, &high[i]);
    store(x.low, &low[i]);
  }
  template <class Row>
  Row rounded(std::size_t i) const {
    return load<Row>(&high[i]) + load<Row>(&low[i]);
  }
};

template <class T>
struct Block<Cut<T>> {
  alignas(64) BlockOfDoubles lead;
  alignas(64) BlockOfDoubles rest;

  Cut<T> get(std::size_t i) const { return {load<T>(&lead[i]), load<T>(&rest[i])}; }
  void put(std::size_t i, Cut<T> x) {
    store(x.lead, &lead[i]);
    store(x.rest, &rest[i]);
  }
};

template <class T>
struct Block<NearOne<T>> {
  alignas(64) BlockOfDoubles below;

  NearOne<T> get(std::size_t i) const {
    NearOne<T> x;
    x.below = load<T>(&below[i]);
    return x;
  }
  void put(std::size_t i, NearOne<T> x) { store(x.below, &below[i]); }
};

template <class T>
struct Certainty<Rough<T>> : Certainty<Pair<T>> {};

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
