// SPDX-License-Identifier: MIT
// Polynomials for loops over many arguments, bound by the number of operations where each does not wait too long for the one before.
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

/// One of degree 4 or more by Horner's scheme in z^4: three operations more than in z, for long ones.
template <class T, std::size_t size>
[[gnu::always_inline]] inline T four_chains(const double (&coefficients)[size], T z) {
  static_assert(size >= 5);
  const T square = z * z;
  const T fourth = square * square;
  T chains[4];  // by the power's remainder
  for (std::size_t k = size; k-- > 0;) {
    T& chain = chains[k % 4];
    chain = k + 4 >= size ? T(coefficients[k]) : chain * fourth + T(coefficients[k]);
  }
  return (chains[0] + chains[1] * z) + (chains[2] + chains[3] * z) * square;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
