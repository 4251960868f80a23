// The mass ratios that the oracle answers for: rationals, and the paper's two families. Its
// answers: "raise the precision until the rounding is certain", once for all quantities. CLN keeps
// its own books: one thread at a time.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "magicmass/oracle/quantities.hpp"

namespace magicmass::oracle {

/// alpha as a source of enclosures: called with a precision p it returns one of width <= 2^(3-p).
struct MassRatio {
  std::optional<cl_RA> rational;           ///< the number itself, where it is one
  std::function<Interval(long)> enclosed;  ///< at a precision >= 1
  long length;                             ///< bits that it takes to tell alpha from 0 and infinity
};

/// A rational alpha > 0, else throws std::invalid_argument.
MassRatio ratio(const cl_RA& alpha);
/// So many times as large; factor > 0.
MassRatio operator*(const MassRatio& alpha, const cl_RA& factor);
/// The k-th of each family, k >= 1; the first magic mass ratio is the number 1.
MassRatio magic(const cl_I& k);
MassRatio deficient(const cl_I& k);

/// A monotone rounding.
template <class Value>
struct Rounding {
  /// What all numbers from low to high round to, if it is the same; it is where low == high.
  std::function<std::optional<Value>(const cl_RA& low, const cl_RA& high)> common;
  long bits;  ///< that the value holds
};

/// To the nearest double.
Rounding<double> to_double();
/// To a rational with a relative error below 2^-bits.
Rounding<cl_RA> to_within(long bits);

/// Bits of the denominator of the velocities after j collisions, before reduction to lowest terms:
/// about the length of alpha a collision.
cl_I exact_length(const cl_RA& alpha, const cl_I& j);

/// Rounds each number of the quantity: where alpha is rational and its exact numbers short, these
/// themselves, which settles zeros and ties; else intervals of ever more bits. They widen by a few
/// bits a squaring and the matrix is up to alpha^(+-1/2) in size: the first precision mostly does,
/// the last far beyond what an alpha of that length can ask for. Throws Undecided there: digits of
/// an exact zero at irrational alpha (such as a_k at magic:k), whose cause no precision shows.
template <class Value, class Quantity>
std::vector<Value> certain(const MassRatio& alpha, const Quantity& quantity,
                           const Rounding<Value>& rounding) {
  constexpr long short_length = 1L << 12;
  std::vector<Value> values;
  if (alpha.rational && exact_length(*alpha.rational, quantity.j) <= short_length) {
    for (const cl_RA& x : quantity(*alpha.rational)) values.push_back(*rounding.common(x, x));
    return values;
  }
  const auto squarings = static_cast<long>(cln::integer_length(quantity.j));
  const long first = rounding.bits + 64 + 3 * squarings + alpha.length;
  for (long precision = first; precision <= 64 * first; precision *= 2) {
    values.clear();
    try {
      const std::vector<Interval> enclosures = quantity(alpha.enclosed(precision));
      for (const Interval& x : enclosures)
        if (const std::optional<Value> value = rounding.common(x.low(), x.high()))
          values.push_back(*value);
      if (values.size() == enclosures.size()) return values;
    } catch (const Undecided&) {  // a divisor is not certainly different from 0
    }
  }
  throw Undecided("after " + to_text(quantity.j) + " collisions a number is still open at " +
                  std::to_string(64 * first) + " bits");
}

/// What rounding alpha alone would cost each number y of the quantity, max(1/2, cond/2) ulp with
/// cond = |alpha y'(alpha)/y|, infinity where y = 0, up to the last collision: there y is a smooth
/// function of n h <= pi/2 and h: a step of 2^-60 gives cond to about as much. Throws as certain().
/// here: its numbers to within 120 bits, where they are known.
std::vector<double> envelopes(const MassRatio& alpha, const auto& quantity,
                              std::vector<cl_RA> here = {}) {
  constexpr long bits = 60;
  const cl_RA step = cln::recip(cl_RA(cln::ash(cl_I(1), bits)));
  if (here.empty()) here = certain(alpha, quantity, to_within(2 * bits));
  const auto beside = certain(alpha * (1 + step), quantity, to_within(2 * bits));
  std::vector<double> values;
  for (std::size_t i = 0; i < here.size(); ++i) {
    const bool is_zero = cln::zerop(here[i]);
    const cl_RA cond = is_zero ? 0 : cln::abs((beside[i] / here[i] - 1) / step);
    values.push_back(is_zero ? std::numeric_limits<double>::infinity()
                             : std::max(0.5, nearest(cond / 2)));
  }
  return values;
}

}  // namespace magicmass::oracle
