// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace magicmass {

/// A real number known to within a bound: sign and magnitude of `Words` 64-bit words, the top one before the binary
/// point, and an upper bound on |stored - true| in units of the last place, ulp = 2^-(64 (Words - 1)).
/// The bound is a double that only ever grows by more than its own rounding; on overflow of the top word it
/// is infinite or NaN from then on, so that nothing false is ever certified.
template <std::size_t Words>
class FixedPoint {
  static_assert(Words >= 2);

public:
  using Magnitude = std::array<std::uint64_t, Words>;  // least significant word first

  static constexpr int fraction_bits = static_cast<int>(64 * (Words - 1));

  /// Zero, exactly.
  FixedPoint() = default;

  /// The number 1, exactly.
  static FixedPoint one() {
    FixedPoint result;
    result.words_.back() = 1;
    return result;
  }

  /// A double 0 <= value < 2^63, within 1 ulp; exactly if it is a multiple of the ulp.
  static FixedPoint from(double value) {
    FixedPoint result;
    for (std::size_t i = Words; i-- > 0;) {
      const double whole = std::floor(value);
      result.words_[i] = static_cast<std::uint64_t>(whole);
      // both exact: a double less its leading bits, times a power of two
      value = std::ldexp(value - whole, 64);
    }
    result.error_ = value > 0.0 ? 1.0 : 0.0;
    return result;
  }

  /// 1/y for an exactly stored y >= 1: long division in base 2, rounded down, so within 1 ulp.
  static FixedPoint reciprocal(const FixedPoint& y) {
    FixedPoint result;
    Magnitude remainder = one().words_;
    for (int bit = 0; bit <= fraction_bits; ++bit) {
      shift_left(result.words_);
      if (!less(remainder, y.words_)) {
        subtract(remainder, y.words_);
        result.words_[0] |= 1U;
      }
      shift_left(remainder);
    }
    result.error_ = y.error_ == 0.0 ? 1.0 : std::numeric_limits<double>::infinity();
    return result;
  }

  friend FixedPoint operator+(const FixedPoint& x, const FixedPoint& y) {
    return sum(x, y, y.negative_);
  }
  friend FixedPoint operator-(const FixedPoint& x, const FixedPoint& y) {
    return sum(x, y, !y.negative_);
  }

  /// |x y - stored| <= |x'| ey + |y'| ex + ex ey ulp for the operands' errors, and 1 ulp for the bits cut off.
  friend FixedPoint operator*(const FixedPoint& x, const FixedPoint& y) {
    std::array<std::uint64_t, 2 * Words> product{};
    for (std::size_t i = 0; i < Words; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < Words; ++j) {
        // at most (2^64-1)^2 + 2 (2^64-1) = 2^128 - 1
        const Wide wide = Wide{x.words_[i]} * y.words_[j] + product[i + j] + carry;
        product[i + j] = static_cast<std::uint64_t>(wide);
        carry = static_cast<std::uint64_t>(wide >> 64U);
      }
      product[i + Words] = carry;
    }
    FixedPoint result;
    for (std::size_t i = 0; i < Words; ++i) {
      result.words_[i] = product[i + Words - 1];
    }
    result.negative_ = x.negative_ != y.negative_;
    // the smallest normal double stands in, from above, for an ulp below it
    const double ulp = std::ldexp(1.0, fraction_bits < 1022 ? -fraction_bits : -1022);
    result.error_ =
        rounded_up(x.size() * y.error_ + y.size() * x.error_ + x.error_ * (y.error_ * ulp) + 1.0);
    if (product[2 * Words - 1] != 0) {
      result.error_ = std::numeric_limits<double>::infinity();
    }
    return result;
  }

  /// +1 or -1 where the true number certainly has that sign, 0 where the error bound reaches across zero.
  int certain_sign() const {
    std::size_t top = Words;
    while (top > 0 && words_[top - 1] == 0) {
      --top;
    }
    if (top == 0 || !std::isfinite(error_)) {
      return 0;
    }
    // A lower bound of the magnitude in ulps; from word 16 on it is past every finite double.
    constexpr double below_one = 1.0 - 0x1p-50;
    const double magnitude = static_cast<double>(words_[top - 1]) * below_one;
    const bool certain =
        top > 16 || std::ldexp(magnitude, static_cast<int>(64 * (top - 1))) > error_;
    return certain ? (negative_ ? -1 : 1) : 0;
  }

  /// Upper bound on |stored - true| in units of the last place; not finite once something overflowed.
  double error_bound() const { return error_; }

private:
  __extension__ using Wide = unsigned __int128;

  Magnitude words_{};
  bool negative_ = false;
  double error_ = 0.0;

  /// A sum or product of a few nonnegative doubles is off by less than 2^-50 relative.
  static double rounded_up(double bound) { return bound * (1.0 + 0x1p-50); }

  /// Upper bound of the stored magnitude, in units of 1.
  double size() const {
    return rounded_up(static_cast<double>(words_[Words - 1]) +
                      (static_cast<double>(words_[Words - 2]) + 1.0) * 0x1p-64);
  }

  static bool less(const Magnitude& x, const Magnitude& y) {
    for (std::size_t i = Words; i-- > 0;) {
      if (x[i] != y[i]) {
        return x[i] < y[i];
      }
    }
    return false;
  }

  /// x -= y for x >= y.
  static void subtract(Magnitude& x, const Magnitude& y) {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < Words; ++i) {
      const std::uint64_t difference = x[i] - y[i];
      const bool wraps = x[i] < y[i] || difference < borrow;
      x[i] = difference - borrow;
      borrow = wraps ? 1 : 0;
    }
  }

  /// x += y; true if a carry left the top word.
  static bool add(Magnitude& x, const Magnitude& y) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < Words; ++i) {
      const Wide wide = Wide{x[i]} + y[i] + carry;
      x[i] = static_cast<std::uint64_t>(wide);
      carry = static_cast<std::uint64_t>(wide >> 64U);
    }
    return carry != 0;
  }

  static void shift_left(Magnitude& x) {
    for (std::size_t i = Words; i-- > 1;) {
      x[i] = (x[i] << 1U) | (x[i - 1] >> 63U);
    }
    x[0] <<= 1U;
  }

  static FixedPoint sum(const FixedPoint& x, const FixedPoint& y, bool y_negative) {
    FixedPoint result = x;
    bool overflow = false;
    if (x.negative_ == y_negative) {
      overflow = add(result.words_, y.words_);
    } else if (!less(x.words_, y.words_)) {
      subtract(result.words_, y.words_);
    } else {
      result.words_ = y.words_;
      subtract(result.words_, x.words_);
      result.negative_ = y_negative;
    }
    result.error_ =
        overflow ? std::numeric_limits<double>::infinity() : rounded_up(x.error_ + y.error_);
    return result;
  }
};

}  // namespace magicmass
