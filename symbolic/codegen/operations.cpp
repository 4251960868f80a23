// The table's entries, each with its source. x, y: how large the operands' low parts are against
// their high parts. u: half an ulp of 1. Nothing over- or underflows: ranges see to that.
// [JMP]   Joldes, Muller, Popescu, ACM TOMS 44 (2017); corrected: Muller, Rideau, TOMS 48 (2022).
// [LLMPR] Lefevre, Louvet, Muller, Picot, Rideau, ACM TOMS 49 (2023).
// [H]     Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 2.2, 3.1 and 5.1.
// [D]     Dekker, Numerische Mathematik 18 (1971), 224: Fast2Sum is exact where |x| >= |y|.
// [S]     Sterbenz, Floating-Point Computation (1974): x - y is, where y/2 <= x <= 2 y.
// [Z]     Ziv, ACM TOMS 17 (1991), 410.
// "After": ours is the cited algorithm in another order or without its last step; its roundings are
// counted one by one here, and each entry is measured against exact rationals in the tests.
#include "codegen/operations.hpp"

#include <algorithm>
#include <cmath>

namespace codegen {
/// [JMP] algorithm 2, 2Sum: exact.
Loss NumberType::exact_sum() const { return is_pair() ? Loss{0, u} : Loss{u, 0}; }

/// high = nearest(c), low = nearest(c - high): [H] theorem 2.2, twice; `lost` is exact, rounded up.
Loss NumberType::constant(double lost) const { return is_pair() ? Loss{lost, u} : Loss{u, 0}; }

/// Like signs. After [JMP] algorithm 5 (3 u^2): s = 2Sum(x.high, y.high) is exact;
/// x.low + y.low loses u l, then s.low + that loses u (u + l), l the larger of x and y.
Loss NumberType::sum(double x, double y) const {
  const double l = std::max(x, y);
  return is_pair() ? Loss{u * (2 * l + u) * and_more, (u + l) * and_more} : Loss{u, 0};
}

/// Any signs, and low parts of any size. [JMP] algorithm 5: those two roundings, the second of
/// s.low <= u |s.high| too, then s' = Fast2Sum(s.high, b), b the low sum. It is exact where
/// |s.high| >= |b| [D]; else b is x |x| + y |y| and a bit, and it loses u |b| at most. s' - s.high
/// goes to the nearest double, b is one, and the difference is as far from b as s' is from the
/// sum, u |s'|. So the low part, which is what b lacks [S], is at most twice that.
NumberType::Cancelling NumberType::cancelling_sum(double x, double y) const {
  if (!is_pair()) return {0, 0, u, 0};
  return {3 * u * x * and_more, 3 * u * y * and_more, u * u * and_more, 2 * u * and_more};
}

/// After [JMP] algorithm 12, DWTimesDW3 (4 u^2): x.low y.low is dropped; x.low y.high + p.low loses
/// u (x + u), x.high y.low + that u (x + y + u).
Loss NumberType::product(double x, double y) const {
  if (!is_pair()) return {u, 0};
  return {(x * y + u * (2 * x + y + 2 * u)) * and_more, (x + y + u) * and_more};
}

/// By an exact number. [JMP] algorithm 9, DWTimesFP3 (2 u^2), without its last step.
Loss NumberType::product(double x) const {
  return is_pair() ? Loss{u * (x + u) * and_more, (x + u) * and_more} : Loss{u, 0};
}

/// After [JMP] algorithm 17, DWDivDW2 (15 u^2): q = x.high (1/y.high) is within 2 u, so the rest
/// x - q y is at most d = 2 u + x + y. Its parts lose 2 u u, u (2 u + x), u y and u d; the product
/// by 1/y.high 2 u d, and y d for y.high in place of y.
Loss NumberType::quotient(double x, double y) const {
  if (!is_pair()) return {u, 0};
  const double d = 2 * u + x + y;
  return {(u * (10 * u + 4 * x + 4 * y) + y * d) * and_more, d * and_more};
}

/// After [LLMPR]'s square root (25/8 u^2): r = sqrt(y.high) (1/y.high) is within 3 u, so e = 1 - y
/// r^2 is at most 6 u + y, and Newton's step leaves 3/8 e^2. e loses 7 u u in less_product, u (2 y
/// + 2 u) by the low parts, u e in their difference, half of which counts; times r/2: u e/2.
Loss NumberType::reciprocal_root(double y) const {
  if (!is_pair()) return {u, 0};
  const double e = 6 * u + y;
  return {(0.375 * e * e + u * (10.5 * u + 2 * y)) * and_more, e / 2 * and_more};
}

namespace {
struct Plainly {
  double size, loss;
};
/// [H], rounding by rounding, in the order of the runtime's plain_polynomial: powers by squaring.
Plainly plainly(const double* c, int n, double z, double u) {
  if (n == 1) return {std::fabs(c[0]), 0};
  const int half = n == 2 ? 1 : n > 8 ? 8 : n > 4 ? 4 : 2;
  const Plainly above = plainly(c + half, n - half, z, u), below = plainly(c, half, z, u);
  const double power = std::pow(z, half), product = above.size * power;
  const double size = product + below.size;
  return {size, (above.loss * power + product * (half - 1) * u + below.loss + u * size) * and_more};
}
}  // namespace

/// After [H] 5.1, Horner's rule. The tail in plain numbers; then `plus_product` for each pair: S
/// bounds the sum's high part, L its low part, E its error. c - sum is exact, and rest loses u u s;
/// three sums of low parts follow.
NumberType::OfPolynomial NumberType::polynomial(const Polynomial& p, double size,
                                                double low) const {
  const int n = int(p.high.size()), m = int(p.low.size());
  const auto c = [&](int k) { return std::fabs(p.high[std::size_t(k)]); };
  double slope = 0;
  for (int k = 1; k < n; ++k) slope += k * c(k) * std::pow(size, k - 1);
  slope *= and_more / p.least;
  double tail = 0;
  double of_low = 0;  // the tail takes z.high for z, but for its first coefficient
  for (int k = m; k < n; ++k) {
    tail += c(k) * std::pow(size, k - m + 1);
    if (k > m) of_low += (k - m + 1) * c(k) * std::pow(size, k - m);
  }
  if (tail > c(m - 1)) throw Refused("fast_two_sum of the tail of " + p.name);
  double S = c(m - 1) + tail;
  double L = u * S + u * c(m - 1) + low * c(m);
  double E = plainly(p.high.data() + m, n - m, size, u).loss * size + u * tail * and_more +
             low * of_low + u * (2 * u * S + 2 * u * c(m - 1) + low * c(m));
  for (int k = m - 2; k >= 0; --k) {
    if (size * S > c(k) / 2) throw Refused("plus_product in " + p.name);
    const double s = c(k) + size * S;
    E = size * E + low * L + u * (3 * low * S + size * L + 3 * u * c(k) + 3 * u * s);
    L = u * s + low * S + size * L + u * c(k);
    S = s;
  }
  return {E * and_more / p.least + p.error, L * and_more / p.least, slope};
}

/// t p(z - centre): the difference of high parts is exact, by [D] up to the centre and [S] beyond;
/// that of the low ones is one rounding. Then `polynomial` and `product`: losses add up, [H] 3.1.
Loss NumberType::arc_tangent(double t, double z, double z_off) const {
  if (!is_pair()) return {u, 0};
  const Polynomial& p = (*tier)["arc_tangent"];
  const double low = (u * p.centre + z * p.top) * and_more;
  const OfPolynomial q = polynomial(p, p.centre, low);
  const Loss last = product(t, q.loose);
  return {(q.loss + q.slope * (u * low + z_off * p.top) + last.loss) * and_more, last.loose};
}

/// x p(x^2) and p(x^2), |low part of x| <= x |x|: `product`, `polynomial`, `product`, [H] 3.1.
NumberType::SineCosine NumberType::small_sine_cosine(double x) const {
  if (!is_pair()) return {{u, 0}, {u, 0}};
  const Polynomial& s = (*tier)["small_sine"];
  const Polynomial& c = (*tier)["small_cosine"];
  const Loss square = product(x, x);
  const OfPolynomial of_s = polynomial(s, s.top, square.loose * s.top);
  const OfPolynomial of_c = polynomial(c, c.top, square.loose * c.top);
  const Loss last = product(x, of_s.loose);
  return {{(of_s.loss + of_s.slope * square.loss * s.top + last.loss) * and_more, last.loose},
          {(of_c.loss + of_c.slope * square.loss * c.top) * and_more, of_c.loose}};
}

/// Above pi/4 less a quarter turn: the high parts' difference is exact [S], the low parts' one
/// rounding, of at most x |x| and pi/2's low part; pi/2 itself is right to 2^-107. The low part of
/// what is left, y, is at most `spill`; `product` then bounds y^2 and y p(y^2) in absolute terms. A
/// quarter turn makes sine and cosine of each other, so the cosine may be -y p(y^2), the sine not.
NumberType::SineCosine NumberType::sine_cosine(double x) const {
  if (!is_pair()) return {{u, 0}, {u, 0}};
  const Polynomial& s = (*tier)["sine"];
  const Polynomial& c = (*tier)["cosine"];
  const double spill = (x * 2.3562 + 0x1.1bp-54) * and_more;
  const double angle = (u * x + (u * 0x1.1bp-54 + 0x1p-107) / 0.785) * and_more;
  const double y = std::sqrt(s.top);
  const double low = (2 * y * spill + u * s.top) * and_more;
  const double off = (spill * spill + 3 * u * spill * y + 2 * u * u * s.top) * and_more;
  const OfPolynomial of_s = polynomial(s, s.top, low), of_c = polynomial(c, c.top, low);
  const Loss last = product(x, of_s.loose);
  const Loss sine{(of_s.loss + of_s.slope * off + last.loss) * and_more, last.loose};
  const Loss cosine{(of_c.loss + of_c.slope * off) * and_more, of_c.loose};
  const Loss either{std::max(sine.loss, cosine.loss), std::max(sine.loose, cosine.loose)};
  return {either, either, angle, spill * (of_s.loose + 2 * u) * and_more, spill};
}

/// By squaring, each product of normalised pairs, [JMP] algorithm 12 and Fast2Sum, is within 6 u^2.
/// Where x^i is off by i d + (i - 1) m, relative, so is the product of two, with m for its loss;
/// k (d + m) <= 2^-22 sees to what is of second order. Factors that are cut off to 2^-200 leave a
/// result of at most that, as the exact one is.
Loss NumberType::power(double of_x, double most) const {
  const double off = most * (of_x + (is_pair() ? 6 * u * u : u));
  if (!(off <= 0x1p-22)) throw Refused("a power of too high an exponent");
  return {off * (1 + off), is_pair() ? u : 0};
}

/// [Z]'s test rounds p.low + error and p.low - error: u |p.low|. MPFR rounds p +- error.
double NumberType::rounding_test(double x) const { return (is_pair() ? u * x : u) * and_more; }
}  // namespace codegen
