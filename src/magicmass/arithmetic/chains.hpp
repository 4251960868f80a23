// SPDX-License-Identifier: MIT
// Polynomials for loops over many arguments: few operations, none of which waits too long for the one before.
#pragma once

#include <cstddef>

#include "magicmass/arithmetic/target.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A polynomial of degree 2 or more in z by Horner's scheme in z^2, even and odd powers each by themselves: two operations more than
/// in z, and half the wait.
template <class T, std::size_t size>
[[gnu::always_inline]] inline T two_chains(const double (&coefficients)[size], T z) {
  static_assert(size >= 3);
  const T square = z * z;
  T chains[2] = {T(coefficients[size - 2]), T(coefficients[size - 1])};
  for (std::size_t k = size - 2; k-- > 0;) {
    T& chain = chains[(size - k) % 2];
    chain = chain * square + T(coefficients[k]);
  }
  constexpr std::size_t even = size % 2;  // the chain that ends with the constant coefficient
  return chains[even] + chains[1 - even] * z;
}

/// A polynomial in z by Horner's scheme.
template <class T, std::size_t size>
[[gnu::always_inline]] inline T one_chain(const double (&coefficients)[size], T z) {
  T value(coefficients[size - 1]);
  for (std::size_t k = size - 1; k-- > 0;) value = value * z + T(coefficients[k]);
  return value;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
