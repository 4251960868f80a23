// SPDX-License-Identifier: GPL-2.0-or-later
// The law of one elastic collision as a linear map of the velocities (a, b, c), and its powers:
// all that the oracle knows of the physics.
#pragma once

#include <cstddef>

#include <Eigen/Core>
#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/oracle/interval.hpp"

namespace magicmass::oracle {

// Eigen's general NumTraits serves rationals and intervals: products only add and multiply.
template <class Scalar>
using Map = Eigen::Matrix<Scalar, 3, 3>;
template <class Scalar>
using Velocity = Eigen::Matrix<Scalar, 3, 1>;  ///< (a, b, c) in units of V

/// Bodies i and j of masses m_i and m_j collide: each velocity is reflected in that of their centre
/// of mass, (m_i u_i + m_j u_j)/(m_i + m_j), which keeps momentum and kinetic energy.
template <class Scalar>
Map<Scalar> collision(int i, const Scalar& m_i, int j, const Scalar& m_j) {
  const Scalar two(2);
  Map<Scalar> map = Map<Scalar>::Identity();
  map(i, i) = (m_i - m_j) / (m_i + m_j);
  map(i, j) = two * m_j / (m_i + m_j);
  map(j, i) = two * m_i / (m_i + m_j);
  map(j, j) = (m_j - m_i) / (m_i + m_j);
  return map;
}

/// The two collisions of one cycle, blocks of mass 1 and a ball of mass alpha.
template <class Scalar>
struct Cycle {
  Map<Scalar> with_A;  ///< the ball and A
  Map<Scalar> with_B;  ///< then the ball and B
};

template <class Scalar>
Cycle<Scalar> cycle_of(const Scalar& alpha) {
  constexpr int a = 0;
  constexpr int b = 1;
  constexpr int c = 2;
  const Scalar block(1);
  return {collision(a, block, c, alpha), collision(b, block, c, alpha)};
}

/// The velocities after j >= 0 collisions, A's first, by squaring: the map goes on past the last
/// collision, physics does not.
template <class Scalar>
Velocity<Scalar> after_collisions(const Cycle<Scalar>& cycle, const cln::cl_I& j,
                                  Velocity<Scalar> v = Velocity<Scalar>::UnitX()) {
  Map<Scalar> cycles = cycle.with_B * cycle.with_A;
  const cln::cl_I n = cln::floor1(j, 2);
  for (std::size_t bit = 0; bit < cln::integer_length(n); ++bit) {
    if (bit > 0) cycles = Map<Scalar>(cycles * cycles);
    if (cln::logbitp(bit, n)) v = Velocity<Scalar>(cycles * v);
  }
  return cln::oddp(j) ? Velocity<Scalar>(cycle.with_A * v) : v;
}

}  // namespace magicmass::oracle
