// SPDX-License-Identifier: GPL-2.0-or-later
// What is asked of the oracle: numbers in units of V after j collisions at the most, as functions
// of alpha over rationals or intervals.
#pragma once

#include <vector>

#include <cln/integer.h>

#include "magicmass/oracle/collision_map.hpp"
#include "magicmass/oracle/count.hpp"
#include "magicmass/oracle/rational.hpp"

namespace magicmass::oracle {

/// a_n, b_n, c_n, c'_n, in this order, n >= 0; for n = 0 they are 1, 0, 0, 0. Also beyond the last
/// collision: the map goes on, physics does not.
struct OfCycle {
  cln::cl_I n;
  cln::cl_I j = 2 * n;

  explicit OfCycle(const cln::cl_I& index) : n(index) {}

  template <class Scalar>
  std::vector<Scalar> operator()(const Scalar& alpha) const {
    if (cln::zerop(n)) return {Scalar(1), Scalar(0), Scalar(0), Scalar(0)};
    const Cycle<Scalar> cycle = cycle_of(alpha);
    const Velocity<Scalar> at_P = after_collisions(cycle, j - 1);
    const Velocity<Scalar> at_Q = cycle.with_B * at_P;
    return {at_P(0), at_Q(1), at_P(2), at_Q(2)};
  }
};

/// When collision j takes place, from 0 on, and how far the blocks are apart then: velocities and
/// the places that bodies would have had at time 0 obey one map, so before collision j they are
/// those of its j-th power.
struct AtCollision {
  cln::cl_I j;

  explicit AtCollision(const cln::cl_I& index) : j(index) {}

  template <class Scalar>
  std::vector<Scalar> operator()(const Scalar& alpha) const {
    const Cycle<Scalar> cycle = cycle_of(alpha);
    const Velocity<Scalar> B_alone = Velocity<Scalar>::UnitY();
    const Velocity<Scalar> v = after_collisions(cycle, j), x = after_collisions(cycle, j, B_alone);
    const int other = cln::oddp(j) ? 1 : 0;
    const Scalar t = (x(other) - x(2)) / (v(2) - v(other));
    return {t, x(1) - x(0) + (v(1) - v(0)) * t};
  }
};

/// a_t, b_t, c_t, rho, in this order, after as many collisions as the counts say: of rational alpha
/// ask count_collisions(), of magic:k and deficient:k they are known by theorem.
struct AtEnd {
  cln::cl_I j;

  explicit AtEnd(const Counts& counts) : j(counts.N_A + counts.N_B) {}

  template <class Scalar>
  std::vector<Scalar> operator()(const Scalar& alpha) const {
    const Velocity<Scalar> v = after_collisions(cycle_of(alpha), j);
    return {v(0), v(1), v(2), v(1) * v(1)};
  }
};

/// alpha alone.
struct Itself {
  cln::cl_I j = 0;

  template <class Scalar>
  std::vector<Scalar> operator()(const Scalar& alpha) const {
    return {alpha};
  }
};

}  // namespace magicmass::oracle
