// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>

#include "magicmass/arithmetic/ieee.hpp"

namespace magicmass {

/// Numbers that add, subtract, multiply and divide: float, double, long double, exact rationals, intervals.
template <class T>
concept Arithmetic = std::copyable<T> && std::constructible_from<T, int> &&
    requires(const T& x, const T& y) {
  { x + y } -> std::convertible_to<T>;
  { x - y } -> std::convertible_to<T>;
  { x* y } -> std::convertible_to<T>;
  { x / y } -> std::convertible_to<T>;
};

/// Arithmetic with an order, which is what deciding "do they approach?" takes.
template <class T>
concept Field = Arithmetic<T> && requires(const T& x, const T& y) {
  { x < y } -> std::convertible_to<bool>;
  { x == y } -> std::convertible_to<bool>;
};

}  // namespace magicmass
