// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/count.hpp"

#include <cstddef>
#include <optional>
#include <vector>

#include "magicmass/counts.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/cycle_map.hpp"
#include "magicmass/reference/interval.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// Contact by contact in exact rationals, so that bodies at rest relative to each other are seen not to meet.
LargeCounts step_exactly(const cl_RA& alpha) {
  LargeCounts counts{0, 0};
  BodyVelocities<cl_RA> v = initial_velocities<cl_RA>();
  for (;;) {
    if (!(v.c < v.a)) {
      return counts;
    }
    v = meet_A(alpha, v);
    counts.N_A = counts.N_A + 1;
    if (!(v.b < v.c)) {
      return counts;
    }
    v = meet_B(alpha, v);
    counts.N_B = counts.N_B + 1;
  }
}

/// nullopt where the interval leaves it open.
std::optional<bool> is_positive(const Interval& closing_speed) {
  const Sign sign = closing_speed.sign();
  return sign == Sign::open ? std::nullopt : std::optional(sign == Sign::positive);
}

/// The closing speeds f(n) of A and C, and g(n) of C and B after A's next contact, once n cycles are over, physics or not.
struct ClosingSpeeds {
  cl_RA f0, f1, g0, g1;
  cl_RA trace;  ///< of what a cycle makes of closing speeds: f(n+1) = trace f(n) - f(n-1), and so g
};

/// A cycle is a linear map of the two closing speeds, and of determinant 1, being two reflections: Cayley and Hamilton.
ClosingSpeeds first_closing_speeds(const cl_RA& alpha) {
  std::vector<cl_RA> f;
  std::vector<cl_RA> g;
  BodyVelocities<cl_RA> v = initial_velocities<cl_RA>();
  for (int cycle = 0; cycle < 3; ++cycle) {
    f.push_back(v.a - v.c);
    v = meet_A(alpha, v);
    g.push_back(v.c - v.b);
    v = meet_B(alpha, v);
  }
  return {f[0], f[1], g[0], g[1], (f[0] + f[2]) / f[1]};
}

/// Lucas's sequences of the trace t at one n: U(0) = 0, U(1) = 1, V(0) = 2, V(1) = t, each with x(n+1) = t x(n) - x(n-1).
struct Lucas {
  Interval U;
  Interval V;
};

/// What two closing speeds run as: x(n) = along_U U(n) + along_V V(n).
struct Speed {
  Interval along_U;
  Interval along_V;

  Speed(const cl_RA& x0, const cl_RA& x1, const cl_RA& trace, long precision)
      : along_U(x1 - trace * x0 / 2, precision), along_V(x0 / 2, precision) {}
  Interval at(const Lucas& n) const { return along_U * n.U + along_V * n.V; }
};

/// The search at one precision; nullopt if some sign stayed open.
///
/// Each contact is a reflection of (a, b, sqrt(alpha) c), so a cycle is a rotation by a fixed angle psi = 2 h, h the
/// acute angle between the two mirrors, about the direction of common motion, of which f is free: f is a pure
/// sinusoid in n. The approach speeds before contacts 1, 2, 3, ... are the heights of one vector above mirrors that
/// turn by h each time and begin at height sin h: they run as sin h, sin 2h, sin 3h, ..., positive up to the last
/// collision, not positive for as many after it. So f(n) = sin((2n+1) h), n = 2^i up to the first failure stays
/// below the second zero, 2 pi, and the largest n with f(n) > 0 has its bits found from the top.
std::optional<LargeCounts> search(const ClosingSpeeds& speeds, long precision) {
  const Speed f(speeds.f0, speeds.f1, speeds.trace, precision);
  const Speed g(speeds.g0, speeds.g1, speeds.trace, precision);
  const Interval trace(speeds.trace, precision);
  const Interval half(cl_RA(1) / 2, 1);
  const Interval half_discriminant((speeds.trace * speeds.trace - 4) / 2, precision);
  std::vector<Lucas> doublings{{Interval(1), trace}};  // at 2^i
  for (;;) {
    const Lucas& n = doublings.back();
    const std::optional<bool> meet = is_positive(f.at(n));
    if (!meet) return std::nullopt;
    if (!*meet) break;
    doublings.push_back({n.U * n.V, n.V * n.V - Interval(2)});
  }
  cl_I cycles(0);
  Lucas last{Interval(0), Interval(2)};
  for (std::size_t i = doublings.size() - 1; i-- > 0;) {
    const Lucas& step = doublings[i];
    const Lucas n{half * (last.U * step.V + last.V * step.U),
                  half * last.V * step.V + half_discriminant * last.U * step.U};
    const std::optional<bool> meet = is_positive(f.at(n));
    if (!meet) return std::nullopt;
    if (*meet) {
      last = n;
      cycles = cycles + cln::ash(cl_I(1), static_cast<long>(i));
    }
  }
  // `last` is just before A's last contact; B may or may not be met once more after it.
  const std::optional<bool> meet_again = is_positive(g.at(last));
  if (!meet_again) return std::nullopt;
  const cl_I N_A = cycles + 1;
  return LargeCounts{N_A, *meet_again ? N_A : cycles};
}

}  // namespace

LargeCounts count_collisions(const cl_RA& alpha) {
  if (!cln::plusp(alpha)) {
    throw InvalidInput("alpha must be a positive finite number, got " + to_text(alpha));
  }
  const cl_RA few_collisions_from = cl_RA(1) / 100;
  if (alpha >= few_collisions_from) {
    return step_exactly(alpha);
  }
  // U reaches alpha^(-1/2) and doubling n costs 2 bits, up to n = alpha^(-1/2): 3/2 log2(1/alpha) in all; telling
  // alpha from a threshold takes what alpha's own digits take.
  const long length = static_cast<long>(cln::integer_length(cln::numerator(alpha)) +
                                        cln::integer_length(cln::denominator(alpha)));
  const long start = 64 + 2 * length;
  const ClosingSpeeds speeds = first_closing_speeds(alpha);
  for (long precision = start; precision <= 64 * start; precision *= 2)
    if (const std::optional<LargeCounts> counts = search(speeds, precision)) return *counts;
  throw Undecided("alpha is closer to a threshold than " + std::to_string(64 * start) +
                  " bits can tell");
}

LargeCounts count_collisions(const MassRatio& alpha) {
  if (const auto* magic = std::get_if<Magic>(&alpha)) return {magic->k, magic->k};
  if (const auto* deficient = std::get_if<Deficient>(&alpha))
    return {cln::cl_I(deficient->k) + 1, deficient->k};
  if (const auto* value = std::get_if<double>(&alpha))
    if (const std::optional<Counts> counts = magicmass::count_collisions(*value))
      return {counts->N_A, counts->N_B};
  return count_collisions(*exact(alpha));
}

}  // namespace magicmass::reference
