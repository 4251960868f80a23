// SPDX-License-Identifier: MIT
// Square root, sine, cosine and arctangent of multiword numbers, each with a bound that holds whatever the quality of
// the guesses on the way; a bound that is too large makes the caller take more words.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "magicmass/evaluators/multiword.hpp"
#include "magicmass/evaluators/multiword_division.hpp"
#include "magicmass/evaluators/near_integer.hpp"

namespace magicmass {

/// An upper bound of the true magnitude in units of 2^(64 exponent).
template <std::size_t Words>
typename Multiword<Words>::Bound true_size_above(const Multiword<Words>& x) {
  return grown(size_above(x) + x.error * words_down<typename Multiword<Words>::Bound>(Words));
}

template <std::size_t Words>
Multiword<Words> unknown() {
  Multiword<Words> result;
  result.error = std::numeric_limits<typename Multiword<Words>::Bound>::infinity();
  return result;
}

template <std::size_t Words>
bool is_certainly_below(int limit, const Multiword<Words>& x) {
  return std::ldexp(true_size_above(x), 64 * x.exponent) < limit;
}

/// Adds the terms of an alternating series, of which `next` makes the next one each time, to the first: what is left out
/// is less than the last term, which is less than the last place. The true terms must fall.
template <std::size_t Words, class Next>
Multiword<Words> alternating_series(Multiword<Words> sum, const Next& next) {
  for (bool subtract = true;; subtract = !subtract) {
    const Multiword<Words> term = next();
    sum = subtract ? sum - term : sum + term;
    if (term.exponent <= sum.exponent - static_cast<int>(Words)) {
      sum.error = grown(sum.error + true_size_above(term));
      return sum;
    }
  }
}

/// sin x = x - x^3/3! + ... for |x| < 2, where the terms fall.
template <std::size_t Words>
Multiword<Words> sine(const Multiword<Words>& x) {
  if (x.is_exact_zero() || !is_certainly_below(2, x)) {
    return x.is_exact_zero() ? x : unknown<Words>();
  }
  const Multiword<Words> square = x * x;
  Multiword<Words> term = x;
  std::uint32_t n = 1;
  return alternating_series(x, [&] {
    n += 2;
    return term = over(term * square, (n - 1) * n);
  });
}

/// cos x - 1 = -(x^2/2! - x^4/4! + ...) for |x| < 2.
template <std::size_t Words>
Multiword<Words> cosine_less_one(const Multiword<Words>& x) {
  if (x.is_exact_zero() || !is_certainly_below(2, x)) {
    return x.is_exact_zero() ? x : unknown<Words>();
  }
  const Multiword<Words> square = x * x;
  Multiword<Words> term = over(square, 2);
  std::uint32_t n = 2;
  return times(alternating_series(term,
                                  [&] {
                                    n += 2;
                                    return term = over(term * square, (n - 1) * n);
                                  }),
               -1);
}

/// sqrt x for x certainly positive: Newton's iteration from a double gives some r, and |r - sqrt x| <= |r^2 - x|/r.
template <std::size_t Words>
Multiword<Words> square_root(const Multiword<Words>& x) {
  using Bound = typename Multiword<Words>::Bound;
  if (x.negative || !(x.error * words_down<Bound>(Words) < size_below(x))) {
    return x.is_exact_zero() ? x : unknown<Words>();
  }
  const bool odd = x.exponent % 2 != 0;
  const int half = (x.exponent + (odd ? 1 : 0)) / 2;
  const double leading = size_below(x) * (odd ? 0x1p-64 : 1.0);
  Multiword<Words> root = from_double<Words>(std::sqrt(leading));
  root.exponent += half;
  Multiword<Words> stored = x;
  stored.error = 0;
  for (std::size_t bits = 50; bits < 64 * Words; bits *= 2) {
    root = over(root + stored / root, 2);
    root.error = 0;
  }
  const Multiword<Words> rest = root * root - x;
  if (!rest.is_exact_zero()) {
    const Bound in_units = std::ldexp(
        true_size_above(rest), 64 * (rest.exponent - 2 * root.exponent + static_cast<int>(Words)));
    root.error = grown(in_units / size_below(root));
  }
  return root;
}

/// atan x for 0 <= x < 2: with y the double near it, atan x = y + atan u, u = (x cos y - sin y)/(cos y + x sin y), and u is
/// small. Nothing but the number of terms depends on how near y is.
template <std::size_t Words>
Multiword<Words> arctangent(const Multiword<Words>& x) {
  if (x.is_exact_zero()) {
    return x;
  }
  const Multiword<Words> near = from_double<Words>(std::atan(hint(x)));
  const Multiword<Words> of_sine = sine(near);
  const Multiword<Words> of_cosine = square_root(multiword<Words>(1) - of_sine * of_sine);
  const Multiword<Words> u = (x * of_cosine - of_sine) / (of_cosine + x * of_sine);
  if (u.is_exact_zero()) {
    return near;
  }
  if (!is_certainly_below(1, u)) {
    return unknown<Words>();
  }
  const Multiword<Words> square = u * u;
  Multiword<Words> power = u;
  std::uint32_t n = 1;
  return near + alternating_series(u, [&] {
           n += 2;
           power = power * square;
           return over(power, n);
         });
}

// What the generated forms call, found by the type of their argument.

template <std::size_t Words>
NearInteger<Words> sqrt(const NearInteger<Words>& x) {
  return {0, square_root(x.together())};
}
template <std::size_t Words>
NearInteger<Words> sin(const NearInteger<Words>& x) {
  return {0, sine(x.together())};
}
template <std::size_t Words>
NearInteger<Words> cos(const NearInteger<Words>& x) {
  return {1, cosine_less_one(x.together())};
}
template <std::size_t Words>
NearInteger<Words> atan(const NearInteger<Words>& x) {
  return {0, arctangent(x.together())};
}

}  // namespace magicmass
