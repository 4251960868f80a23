// SPDX-License-Identifier: GPL-2.0-or-later
// Multiword numbers as the rationals that they stand for.
#pragma once

#include <cstddef>
#include <cstdint>

#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/evaluators/near_integer.hpp"
#include "magicmass/reference/rational.hpp"
#include "random_numbers.hpp"

namespace magicmass::testing {

/// 2^exponent.
inline cln::cl_RA power_of_two(int exponent) {
  const cln::cl_RA power(cln::ash(cln::cl_I(1), exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? cln::recip(power) : power;
}

/// The weight of the last word.
template <std::size_t Words>
cln::cl_RA unit(const Multiword<Words>& x) {
  return power_of_two(64 * (x.exponent - static_cast<int>(Words)));
}

/// The stored number.
template <std::size_t Words>
cln::cl_RA stored(const Multiword<Words>& x) {
  cln::cl_I magnitude(0);
  for (std::size_t i = Words; i-- > 0;) {
    magnitude = cln::ash(magnitude, 64) + cln::cl_I(static_cast<unsigned long>(x.words[i]));
  }
  return (x.negative ? -magnitude : magnitude) * unit(x);
}

template <std::size_t Words>
cln::cl_RA stored(const NearInteger<Words>& x) {
  return cln::cl_I(static_cast<long>(x.whole)) + stored(x.rest);
}

/// How far a true number may be from the stored one.
template <std::size_t Words>
cln::cl_RA bound(const Multiword<Words>& x) {
  return reference::exact(x.error) * unit(x);
}

/// Is the number within the bound?
template <std::size_t Words>
bool holds(const Multiword<Words>& x, const cln::cl_RA& number) {
  return cln::abs(stored(x) - number) <= bound(x);
}
template <std::size_t Words>
bool holds(const NearInteger<Words>& x, const cln::cl_RA& number) {
  return cln::abs(stored(x) - number) <= bound(x.rest);
}

/// Words that are random, all zeros or all ones, with or without an error.
template <std::size_t Words>
Multiword<Words> random_multiword(Generator& generator, int largest_exponent) {
  Multiword<Words> x;
  for (std::uint64_t& word : x.words) {
    const std::int64_t kind = whole(generator, 0, 3);
    word = kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : generator();
  }
  x.words[Words - 1] >>= static_cast<unsigned>(whole(generator, 0, 63));
  x.words[Words - 1] |= 1U;
  x.exponent = static_cast<int>(whole(generator, -largest_exponent, largest_exponent));
  x.negative = whole(generator, 0, 1) == 1;
  if (whole(generator, 0, 2) > 0) {
    x.error = log_uniform(generator, 1e-3, 1e18);
  }
  return x;
}

/// A number that x may stand for: at an end of what its bound allows, or in it.
template <std::size_t Words>
cln::cl_RA possible(Generator& generator, const Multiword<Words>& x) {
  return stored(x) + bound(x) * cln::cl_I(static_cast<long>(whole(generator, -1, 1)));
}

}  // namespace magicmass::testing
