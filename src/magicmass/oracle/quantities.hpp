// The law of one elastic collision as a linear map of the velocities (a, b, c), and its powers:
// all that the oracle knows of the physics. What is asked of it: counts, and numbers in units of V
// after j collisions at the most, as functions of alpha over rationals or intervals.
#pragma once

#include <vector>

#include <Eigen/Core>

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
  const Scalar block(1);
  return {collision(0, block, 2, alpha), collision(1, block, 2, alpha)};  // rows: a, b, c
}

/// The velocities after j >= 0 collisions, A's first, by squaring: of each column of v.
template <class Scalar, class Columns = Velocity<Scalar>>
Columns after_collisions(const Cycle<Scalar>& cycle, const cl_I& j,
                         Columns v = Columns::Identity()) {
  Map<Scalar> cycles = cycle.with_B * cycle.with_A;
  const cl_I n = cln::floor1(j, 2);
  for (std::size_t bit = 0; bit < cln::integer_length(n); ++bit) {
    if (bit > 0) cycles = Map<Scalar>(cycles * cycles);
    if (cln::logbitp(bit, n)) v = Columns(cycles * v);
  }
  return cln::oddp(j) ? Columns(cycle.with_A * v) : v;
}

/// N_A and N_B, of any size.
struct Counts {
  cl_I N_A;  ///< of A and C
  cl_I N_B;  ///< of C and B

  friend bool operator==(const Counts&, const Counts&) = default;
};

/// Exact for rational alpha > 0 of any size, else throws std::invalid_argument; the cost grows with
/// log(1/alpha). Throws Undecided if a sign is open at 64 times alpha's own bits (never seen).
Counts count_collisions(const cl_RA& alpha);

/// a_n, b_n, c_n, c'_n, in this order, n >= 0; for n = 0 they are 1, 0, 0, 0. Also beyond the last
/// collision: the map goes on, physics does not.
struct OfCycle {
  cl_I n;
  cl_I j = 2 * n;

  explicit OfCycle(const cl_I& index) : n(index) {}

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
/// the places that bodies would have had at time 0 obey one map: its j-th power gives both then.
struct AtCollision {
  cl_I j;

  explicit AtCollision(const cl_I& index) : j(index) {}

  template <class Scalar>
  std::vector<Scalar> operator()(const Scalar& alpha) const {
    const Cycle<Scalar> cycle = cycle_of(alpha);
    const auto both = after_collisions<Scalar, Eigen::Matrix<Scalar, 3, 2>>(cycle, j);
    const Velocity<Scalar> v = both.col(0), x = both.col(1);  // A alone moves, B alone
    const int other = cln::oddp(j) ? 1 : 0;
    const Scalar t = (x(other) - x(2)) / (v(2) - v(other));
    return {t, x(1) - x(0) + (v(1) - v(0)) * t};
  }
};

/// a_t, b_t, c_t, rho, in this order, after as many collisions as the counts say: of rational alpha
/// ask count_collisions(), of magic:k and deficient:k they are known by theorem.
struct AtEnd {
  cl_I j;

  explicit AtEnd(const Counts& counts) : j(counts.N_A + counts.N_B) {}

  template <class Scalar>
  std::vector<Scalar> operator()(const Scalar& alpha) const {
    const Velocity<Scalar> v = after_collisions(cycle_of(alpha), j);
    return {v(0), v(1), v(2), v(1) * v(1)};
  }
};

/// alpha alone.
struct Itself {
  cl_I j = 0;

  template <class Scalar>
  std::vector<Scalar> operator()(const Scalar& alpha) const {
    return {alpha};
  }
};

}  // namespace magicmass::oracle
