// The two families are typed here by their definition, sec x - 1 (Ee & Lee, Table II), so that the
// oracle shares nothing with what is derived and generated.
#include "magicmass/oracle/certain.hpp"

#include <cln/real.h>

namespace magicmass::oracle {
namespace {

/// sec(pi/divisor) - 1 for divisor >= 4. CLN works with 64 bits more than asked; its manual
/// promises pi and cos to about the last place, and 2^32 times that is allowed here. The cosine is
/// at least 1/2, so the secant is off by at most 4 times that.
Interval secant_less_one(const cl_I& divisor, long precision) {
  const auto digits = static_cast<unsigned long>(static_cast<double>(precision + 64) * 0.30103) + 2;
  const cln::cl_F angle = cln::pi(cln::float_format(digits)) / divisor;
  const cl_RA cosine = cln::rational(cln::cos(angle));
  const cl_RA slack = cln::recip(cl_RA(cln::ash(cl_I(1), precision + 32)));
  return {cln::recip(cosine + slack) - 1, cln::recip(cosine - slack) - 1, precision};
}

MassRatio secant_ratio(const cl_I& divisor) {
  const auto bits = static_cast<long>(cln::integer_length(divisor));
  const auto enclosed = [divisor](long precision) { return secant_less_one(divisor, precision); };
  return {std::nullopt, enclosed, 2 * bits};
}

// Large counts are found by bisection on the signs of closing speeds.

/// Nothing where the interval leaves it open.
std::optional<bool> closes(const Interval& speed) {
  const Sign sign = speed.sign();
  return sign == Sign::open ? std::nullopt : std::optional(sign == Sign::positive);
}

/// The search at one precision; nothing if some sign stayed open.
/// A collision is a reflection of (a, b, sqrt(alpha) c), so a cycle is a rotation by a fixed angle
/// 2 h about the direction of common motion, which closing speeds do not see. Before collisions 0,
/// 1, 2, ... these run as sin h, sin 2h, sin 3h, ..., positive up to the last collision, not so for
/// as many after it; A's after n cycles run as sin((2n+1) h). So n = 2^i up to the first failure
/// stays below the second zero, 2 pi, and the largest n with a positive one has its bits found from
/// the top; powers of one map commute, so in any order. Where a speed is exactly zero its sign
/// stays open unless all intervals are points: alpha = 1 is the one rational threshold.
std::optional<Counts> search(const Interval& alpha) {
  const Cycle<Interval> cycle = cycle_of(alpha);
  const auto A_closes = [](const Velocity<Interval>& v) { return closes(v(0) - v(2)); };
  Velocity<Interval> last(1, 0, 0);
  std::vector<Map<Interval>> powers{cycle.with_B * cycle.with_A};  // to the 2^i
  for (;;) {
    const std::optional<bool> meet = A_closes(powers.back() * last);
    if (!meet) return std::nullopt;
    if (!*meet) break;
    powers.push_back(powers.back() * powers.back());
  }
  cl_I cycles(0);
  for (auto i = static_cast<long>(powers.size()) - 2; i >= 0; --i) {
    const Velocity<Interval> v = powers[static_cast<std::size_t>(i)] * last;
    const std::optional<bool> meet = A_closes(v);
    if (!meet) return std::nullopt;
    if (*meet) {
      last = v;
      cycles = cycles + cln::ash(cl_I(1), i);
    }
  }
  // `last` is just before A's last collision; B may or may not be met once more after it.
  const Velocity<Interval> after = cycle.with_A * last;
  const std::optional<bool> meet_again = closes(after(2) - after(1));
  if (!meet_again) return std::nullopt;
  const cl_I N_A = cycles + 1;
  return Counts{N_A, *meet_again ? N_A : cycles};
}

}  // namespace

MassRatio ratio(const cl_RA& alpha) {
  if (!cln::plusp(alpha))
    throw std::invalid_argument("alpha must be positive, got " + to_text(alpha));
  const auto enclosed = [alpha](long precision) { return Interval(alpha, precision); };
  return {alpha, enclosed, length(alpha)};
}

MassRatio operator*(const MassRatio& alpha, const cl_RA& factor) {
  if (alpha.rational) return ratio(*alpha.rational * factor);
  const auto enclosed = [alpha, factor](long precision) {
    return alpha.enclosed(precision) * Interval(factor, precision);
  };
  return {std::nullopt, enclosed, alpha.length + length(factor)};
}

// sec(pi/3) - 1 = 1; as a number it lets exact zeros be seen.
MassRatio magic(const cl_I& k) { return k == 1 ? ratio(1) : secant_ratio(2 * k + 1); }

MassRatio deficient(const cl_I& k) { return secant_ratio(2 * (k + 1)); }

// Where both ends round alike, so does all that lies between them.
Rounding<double> to_double() {
  const auto common = [](const cl_RA& low, const cl_RA& high) {
    const double value = nearest(low);
    return value == nearest(high) ? std::optional(value) : std::nullopt;
  };
  return {common, 64};
}

Rounding<cl_RA> to_within(long bits) {
  const auto common = [bits](const cl_RA& low, const cl_RA& high) {
    const cl_RA smallest = cln::min(cln::abs(low), cln::abs(high));
    const bool close = (high - low) * cln::ash(cl_I(1), bits) < smallest;
    return low == high || close ? std::optional(low) : std::nullopt;
  };
  return {common, bits};
}

cl_I exact_length(const cl_RA& alpha, const cl_I& j) {
  // Both collisions have entries of the same size, so either one's common denominator will do.
  const Map<cl_RA> map = cycle_of(alpha).with_A;
  cl_I common(1);
  for (const cl_RA& entry : map.reshaped()) common = cln::lcm(common, cln::denominator(entry));
  return j * cl_I(static_cast<unsigned long>(cln::integer_length(common - 1)));
}

Counts count_collisions(const cl_RA& alpha) {
  const MassRatio source = ratio(alpha);
  // A squaring costs a few bits, up to n = alpha^(-1/2), and telling alpha from a threshold takes
  // what alpha's own digits take: the first precision mostly does.
  const long first = 16 + source.length;
  for (long precision = first; precision <= 64 * first; precision *= 2)
    if (const std::optional<Counts> counts = search(source.enclosed(precision))) return *counts;
  throw Undecided("alpha is closer to a threshold than " + std::to_string(64 * first) +
                  " bits can tell");
}

}  // namespace magicmass::oracle
