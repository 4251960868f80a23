// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/relative_motion.hpp"

#include <cstddef>

#include "magicmass/reference/cycle_map.hpp"
#include "magicmass/reference/interval.hpp"

namespace magicmass::report {
namespace {

using cln::cl_I;
using cln::cl_RA;
using reference::CycleVelocities;
using reference::Interval;

/// a - b, and 2c - a - b over a power of two, `unit`, of about 1/sqrt(alpha).
struct Relative {
  Interval blocks;
  Interval ball;
};

struct Unit {
  Interval size;
  Interval reciprocal;
};

Unit unit_for(const cl_RA& alpha) {
  const long length = static_cast<long>(cln::integer_length(cln::denominator(alpha))) -
                      static_cast<long>(cln::integer_length(cln::numerator(alpha)));
  const long power = length > 0 ? length / 2 : 0;
  const cl_I size = cln::ash(cl_I(1), power);
  return {Interval(cl_RA(size), 0), Interval(cln::recip(cl_RA(size)), power)};
}

Relative relative(const BodyVelocities<Interval>& v, const Unit& unit) {
  return {v.a - v.b, (v.c + v.c - v.a - v.b) * unit.reciprocal};
}

/// All three velocities in the frame in which A, B and C began: momentum a + b + alpha c = 1.
BodyVelocities<Interval> absolute(const Relative& v, const Interval& alpha, const Unit& unit,
                                  const Interval& half) {
  const Interval ball = v.ball * unit.size;
  const Interval c = (Interval(1) + ball) / (Interval(2) + alpha);
  const Interval mean = c - ball * half;  // (a + b)/2
  return {mean + v.blocks * half, mean - v.blocks * half, c};
}

/// The linear map [[p, q], [r, s]] on (blocks, ball).
struct Map {
  Interval p, q, r, s;
};

Relative apply(const Map& m, const Relative& v) {
  return {m.p * v.blocks + m.q * v.ball, m.r * v.blocks + m.s * v.ball};
}

Map squared(const Map& m) {
  const Interval trace = m.p + m.s;
  const Interval mixed = m.q * m.r;
  return {m.p * m.p + mixed, m.q * trace, m.r * trace, m.s * m.s + mixed};
}

/// One cycle, from the collision law: relative velocities are the same in every frame, so each unit vector stands for
/// some a, b, c with the mean of the blocks at rest.
Map cycle(const Interval& alpha, const Unit& unit, const Interval& half) {
  const auto image = [&](const BodyVelocities<Interval>& v) {
    return relative(reference::meet_B(alpha, reference::meet_A(alpha, v)), unit);
  };
  const Relative of_blocks = image({half, Interval(0) - half, Interval(0)});
  const Relative of_ball = image({Interval(0), Interval(0), unit.size * half});
  return {of_blocks.blocks, of_ball.blocks, of_blocks.ball, of_ball.ball};
}

}  // namespace

CycleVelocities<Interval> enclosed_velocities(const cl_RA& alpha, const cl_I& n, long precision) {
  const Interval ratio(alpha, precision);
  const Interval half(cl_RA(1) / 2, 1);
  const Unit unit = unit_for(alpha);
  Relative v = relative(reference::initial_velocities<Interval>(), unit);
  const cl_I cycles = n - 1;
  const std::size_t bits = cln::integer_length(cycles);
  if (bits > 0) {
    Map map = cycle(ratio, unit, half);
    for (std::size_t bit = 0; bit < bits; ++bit) {
      if (cln::logbitp(bit, cycles)) v = apply(map, v);
      if (bit + 1 < bits) map = squared(map);
    }
  }
  const BodyVelocities<Interval> at_P = reference::meet_A(ratio, absolute(v, ratio, unit, half));
  const BodyVelocities<Interval> at_Q = reference::meet_B(ratio, at_P);
  return {at_P.a, at_Q.b, at_P.c, at_Q.c};
}

}  // namespace magicmass::report
