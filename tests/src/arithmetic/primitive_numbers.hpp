// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of each type from doubles or lanes, and back.
#pragma once

#include "magicmass/arithmetic/bounded.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/rough.hpp"
#include "magicmass/arithmetic/tabled.hpp"
#include "magicmass/arithmetic/tracked.hpp"

namespace magicmass::testing {
inline namespace MAGICMASS_TARGET {

using arithmetic::Bounded;
using arithmetic::Cut;
using arithmetic::NearOne;
using arithmetic::Pair;
using arithmetic::Rough;
using arithmetic::Sum;
using arithmetic::Tabled;
using arithmetic::Tracked;
using arithmetic::Wide;

template <class T>
Pair<T> pair(const T* x) {
  return {x[0], x[1]};
}
template <class T>
Rough<T> rough(const T* x) {
  return {x[0], x[1]};
}
template <class T>
NearOne<T> near_one(T below) {
  NearOne<T> x;
  x.below = below;
  return x;
}
template <class T>
Tracked<T> tracked(const T* x) {
  return {{x[0], x[1]}, x[2]};
}
template <class T>
Tracked<T, true> fused(const T* x) {
  return {{x[0], x[1]}, x[2]};
}
template <class T>
Bounded<T> bounded(const T* x) {
  return {{x[0], x[1]}, x[2]};
}

template <class T>
void put(T x, T* y) {
  y[0] = x;
}
template <class T>
void put(Sum<T> x, T* y) {
  y[0] = x.high;
  y[1] = x.low;
}
template <class T>
void put(Pair<T> x, T* y) {
  y[0] = x.high;
  y[1] = x.low;
}
template <class T>
void put(Rough<T> x, T* y) {
  y[0] = x.high;
  y[1] = x.low;
}
template <class T>
void put(Wide<T> x, T* y) {
  y[0] = x.high;
  y[1] = x.low;
}
template <class T>
void put(Cut<T> x, T* y) {
  y[0] = x.lead;
  y[1] = x.rest;
}
template <class T, bool fuses>
void put(Tracked<T, fuses> x, T* y) {
  put(x.pair, y);
  y[2] = x.size;
}
template <class T>
void put(Bounded<T> x, T* y) {
  put(x.pair, y);
  y[2] = x.error;
}

inline Tabled<double> tabled(const double* x) { return Tabled<double>(pair(x)); }
inline void put(Tabled<double> x, double* y) { put(x.pair, y); }

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::testing
