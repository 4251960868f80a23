// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/interval.hpp"

#include <algorithm>
#include <cmath>

#include <cln/float.h>
#include <cln/real.h>

#include "algebraic/budget.hpp"

namespace magicmass::algebraic {
namespace {

using cln::cl_I;
using cln::cl_RA;

constexpr long largest_exponent = 1L << 50U;

long length(const cl_I& x) { return static_cast<long>(cln::integer_length(x)); }

Dyadic checked(const cl_I& mantissa, long exponent) {
  if (exponent > largest_exponent || exponent < -largest_exponent)
    throw BeyondBudget("a number beyond 2^(2^50)");
  return {mantissa, cln::zerop(mantissa) ? 0 : exponent};
}

/// ash rounds down; with negations it rounds up.
cl_I shifted(const cl_I& x, long shift, bool up) {
  return up ? -cln::ash(-x, shift) : cln::ash(x, shift);
}

Dyadic rounded(const cl_I& mantissa, long exponent, long precision, bool up) {
  const long excess = length(mantissa) - precision;
  if (excess <= 0) return checked(mantissa, exponent);
  return checked(shifted(mantissa, -excess, up), exponent + excess);
}

Dyadic rounded(const Dyadic& x, long precision, bool up) {
  return rounded(x.mantissa, x.exponent, precision, up);
}

Dyadic rounded(const cl_RA& x, long precision, bool up) {
  const cl_I above = cln::numerator(x);
  const cl_I below = cln::denominator(x);
  if (below == 1) return rounded(above, 0, precision, up);
  const long shift = precision + 2 - (length(above) - length(below));
  const cl_I scaled_above = shift > 0 ? cln::ash(above, shift) : above;
  const cl_I scaled_below = shift > 0 ? below : cln::ash(below, -shift);
  return rounded(
      up ? cln::ceiling1(scaled_above, scaled_below) : cln::floor1(scaled_above, scaled_below),
      -shift, precision, up);
}

Dyadic negated(const Dyadic& x) { return {-x.mantissa, x.exponent}; }

/// Where one operand is far below the other it is first rounded, in the same direction, to a multiple of 2^floor.
Dyadic sum(const Dyadic& x, const Dyadic& y, long precision, bool up) {
  if (x.sign() == 0) return rounded(y, precision, up);
  if (y.sign() == 0) return rounded(x, precision, up);
  const long floor = std::max(x.top(), y.top()) - 3 * precision - 16;
  const auto above_floor = [&](const Dyadic& z) -> Dyadic {
    if (z.exponent >= floor) return z;
    return {shifted(z.mantissa, z.exponent - floor, up), floor};
  };
  const Dyadic u = above_floor(x);
  const Dyadic v = above_floor(y);
  const long exponent = std::min(u.exponent, v.exponent);
  return rounded(
      cln::ash(u.mantissa, u.exponent - exponent) + cln::ash(v.mantissa, v.exponent - exponent),
      exponent, precision, up);
}

Dyadic product(const Dyadic& x, const Dyadic& y, long precision, bool up) {
  return rounded(x.mantissa * y.mantissa, x.exponent + y.exponent, precision, up);
}

/// y > 0
Dyadic quotient(const Dyadic& x, const Dyadic& y, long precision, bool up) {
  if (x.sign() == 0) return {};
  const long shift = std::max(0L, precision + 2 - (length(x.mantissa) - length(y.mantissa)));
  const cl_I above = cln::ash(x.mantissa, shift);
  return rounded(up ? cln::ceiling1(above, y.mantissa) : cln::floor1(above, y.mantissa),
                 x.exponent - y.exponent - shift, precision, up);
}

/// x >= 0, n >= 1
Dyadic power(Dyadic x, cl_I n, long precision, bool up) {
  Dyadic result{1, 0};
  while (true) {
    if (cln::oddp(n)) result = product(result, x, precision, up);
    n = cln::ash(n, -1);
    if (cln::zerop(n)) return result;
    x = product(x, x, precision, up);
  }
}

bool less(const Dyadic& x, const Dyadic& y) {
  if (x.sign() != y.sign()) return x.sign() < y.sign();
  if (x.sign() == 0) return false;
  if (x.top() != y.top()) return (x.top() < y.top()) == (x.sign() > 0);
  const long exponent = std::min(x.exponent, y.exponent);
  return cln::ash(x.mantissa, x.exponent - exponent) < cln::ash(y.mantissa, y.exponent - exponent);
}

/// The integer part of the square root of x 4^k decides: exact rounding in either direction.
Dyadic square_root(const Dyadic& x, long precision, bool up) {
  if (x.sign() == 0) return {};
  long shift = std::max(0L, 2 * precision + 2 - length(x.mantissa));
  if ((x.exponent - shift) % 2 != 0) ++shift;
  const cl_I scaled = cln::ash(x.mantissa, shift);
  const cl_I root = cln::isqrt(scaled);
  const bool exact = root * root == scaled;
  return rounded(up && !exact ? root + 1 : root, (x.exponent - shift) / 2, precision, up);
}

/// Newton's iteration for the n-th root, precision doubling; only a candidate, which powering then certifies.
Dyadic near_root(const Dyadic& x, long n, long precision) {
  // x = f 2^(n s) with 1/2 <= f < 2^n; the root is f^(1/n) 2^s.
  const long top = x.top();
  const long s = top >= 0 ? top / n : -((-top + n - 1) / n);
  const long lead = length(x.mantissa);
  const double mantissa = cln::double_approx(
      cln::ash(x.mantissa, 60 - lead));  // in [2^59, 2^60); the exponent below stands for the rest
  double start = std::exp2((std::log2(mantissa) - 60 + static_cast<double>(top - n * s)) /
                           static_cast<double>(n));
  const auto format = [](long bits) {
    return cln::float_format(static_cast<unsigned long>(static_cast<double>(bits) * 0.30103) + 3);
  };
  cln::cl_F root = cln::cl_float(start, format(64));
  for (long bits = 40; bits < precision + 40;) {
    bits = std::min(2 * bits, precision + 40);
    const cln::float_format_t now = format(bits + 32);
    const long cut = std::max(0L, lead - bits - 64);
    const cln::cl_F target =
        cln::scale_float(cln::cl_float(cln::ash(x.mantissa, -cut), now), x.exponent + cut - n * s);
    root = cln::cl_float(root, now);
    root = root + (target / cln::expt(root, cl_I(n - 1)) - root) / n;
  }
  const cln::cl_idecoded_float parts = cln::integer_decode_float(root);
  return {parts.mantissa, cln::cl_I_to_long(parts.exponent) + s};
}

}  // namespace

long Dyadic::top() const { return length(cln::abs(mantissa)) + exponent; }

cl_RA Dyadic::rational() const {
  return exponent >= 0 ? cl_RA(cln::ash(mantissa, exponent))
                       : cl_RA(mantissa) / cln::ash(cl_I(1), -exponent);
}

Interval::Interval(Dyadic low, Dyadic high) : low_(std::move(low)), high_(std::move(high)) {}

Interval::Interval(const cl_RA& x, long precision) : Interval(x, x, precision) {}

Interval::Interval(const cl_RA& low, const cl_RA& high, long precision)
    : Interval(rounded(low, precision, false), rounded(high, precision, true)) {}

Interval::Interval(const Dyadic& low, const Dyadic& high, long precision)
    : Interval(rounded(low, precision, false), rounded(high, precision, true)) {}

int Interval::sign() const {
  if (low_.sign() > 0) return 1;
  if (high_.sign() < 0) return -1;
  return low_.sign() == 0 && high_.sign() == 0 ? 0 : 2;
}

long Interval::top() const {
  if (low_.sign() == 0) return high_.top();
  if (high_.sign() == 0) return low_.top();
  return std::max(low_.top(), high_.top());
}

Interval Interval::operator-() const { return {negated(high_), negated(low_)}; }

Interval Interval::magnitude() const {
  if (low_.sign() >= 0) return *this;
  if (high_.sign() <= 0) return -*this;
  return {Dyadic{}, less(high_, negated(low_)) ? negated(low_) : high_};
}

Interval sum(const Interval& x, const Interval& y, long precision) {
  return {sum(x.low_, y.low_, precision, false), sum(x.high_, y.high_, precision, true)};
}

Interval product(const Interval& x, const Interval& y, long precision) {
  if (x.low_.sign() < 0 && x.high_.sign() <= 0) return -product(-x, y, precision);
  if (y.low_.sign() < 0 && y.high_.sign() <= 0) return -product(x, -y, precision);
  if (x.low_.sign() >= 0) {
    // y's low end against x's far or near end, according to its sign
    return {product(y.low_.sign() < 0 ? x.high_ : x.low_, y.low_, precision, false),
            product(x.high_, y.high_, precision, true)};
  }
  if (y.low_.sign() >= 0) return product(y, x, precision);
  const Dyadic lows[] = {product(x.low_, y.high_, precision, false),
                         product(x.high_, y.low_, precision, false)};
  const Dyadic highs[] = {product(x.low_, y.low_, precision, true),
                          product(x.high_, y.high_, precision, true)};
  return {less(lows[0], lows[1]) ? lows[0] : lows[1],
          less(highs[0], highs[1]) ? highs[1] : highs[0]};
}

Interval quotient(const Interval& x, const Interval& y, long precision) {
  if (y.sign() == 0 || y.sign() == 2) throw Unbounded{};
  if (y.sign() < 0) return quotient(-x, -y, precision);
  return {quotient(x.low_, x.low_.sign() < 0 ? y.low_ : y.high_, precision, false),
          quotient(x.high_, x.high_.sign() < 0 ? y.high_ : y.low_, precision, true)};
}

Interval integer_power(const Interval& x, const cl_I& n, long precision) {
  if (x.low_.sign() >= 0)
    return {power(x.low_, n, precision, false), power(x.high_, n, precision, true)};
  if (cln::evenp(n)) return integer_power(x.magnitude(), n, precision);
  if (x.high_.sign() <= 0) return -integer_power(-x, n, precision);
  return {negated(power(negated(x.low_), n, precision, true)), power(x.high_, n, precision, true)};
}

Interval real_root(const Interval& x, long n, long precision) {
  if (x.high().sign() < 0) throw Unbounded{};
  const Dyadic low = x.low().sign() < 0 ? Dyadic{} : x.low();
  if (n == 2)
    return {square_root(low, precision, false), square_root(x.high(), precision, true), precision};
  const auto end = [&](const Dyadic& target, bool up) -> Dyadic {
    if (target.sign() == 0) return {};
    const Dyadic candidate = near_root(target, n, precision);
    for (long slack = precision + 8;; slack -= 8) {
      const Dyadic step = {up ? 1 : -1, candidate.top() - slack};
      Dyadic moved = sum(candidate, step, precision + 16, up);
      // power() errs to the safe side: below the target rounded up, or above it rounded down.
      const Dyadic powered = power(moved, n, precision + 32, !up);
      if (up ? !less(powered, target) : !less(target, powered)) return moved;
      if (slack < 8) throw Unbounded{};
    }
  };
  return {end(low, false), end(x.high(), true), precision};
}

}  // namespace magicmass::algebraic
