// SPDX-License-Identifier: GPL-2.0-or-later
// The linear maps that one contact, and one cycle of two contacts, make of the velocities (a, b, c).
#pragma once

#include <array>
#include <cstddef>

#include <cln/integer.h>

#include "magicmass/simulator/contact.hpp"
#include "magicmass/simulator/motion.hpp"

namespace magicmass::reference {

/// Velocities after A and the ball met: the collision law, blocks of mass 1.
template <Arithmetic Scalar>
BodyVelocities<Scalar> meet_A(const Scalar& alpha, const BodyVelocities<Scalar>& v) {
  const AfterContact<Scalar> after = collide(Scalar(1), v.a, alpha, v.c);
  return {after.first, v.b, after.second};
}

/// Velocities after B and the ball met.
template <Arithmetic Scalar>
BodyVelocities<Scalar> meet_B(const Scalar& alpha, const BodyVelocities<Scalar>& v) {
  const AfterContact<Scalar> after = collide(Scalar(1), v.b, alpha, v.c);
  return {v.a, after.first, after.second};
}

/// A linear map by the images of the three unit vectors.
template <class Scalar>
struct LinearMap {
  BodyVelocities<Scalar> from_a;  ///< image of (1, 0, 0)
  BodyVelocities<Scalar> from_b;  ///< image of (0, 1, 0)
  BodyVelocities<Scalar> from_c;  ///< image of (0, 0, 1)
};

/// The linear map that `change` is.
template <class Scalar, class Change>
LinearMap<Scalar> map_of(const Change& change) {
  const Scalar zero(0);
  const Scalar one(1);
  return {change(BodyVelocities<Scalar>{one, zero, zero}),
          change(BodyVelocities<Scalar>{zero, one, zero}),
          change(BodyVelocities<Scalar>{zero, zero, one})};
}

/// Image of v.
template <class Scalar>
BodyVelocities<Scalar> apply(const LinearMap<Scalar>& map, const BodyVelocities<Scalar>& v) {
  return {map.from_a.a * v.a + map.from_b.a * v.b + map.from_c.a * v.c,
          map.from_a.b * v.a + map.from_b.b * v.b + map.from_c.b * v.c,
          map.from_a.c * v.a + map.from_b.c * v.b + map.from_c.c * v.c};
}

/// First `inner`, then `outer`.
template <class Scalar>
LinearMap<Scalar> compose(const LinearMap<Scalar>& outer, const LinearMap<Scalar>& inner) {
  return {apply(outer, inner.from_a), apply(outer, inner.from_b), apply(outer, inner.from_c)};
}

/// Calls visit(map^(2^i)) for each bit i of n >= 0 that is set; their product is map^n.
template <class Scalar, class Visit>
void for_each_factor(LinearMap<Scalar> map, const cln::cl_I& n, const Visit& visit) {
  const std::size_t bits = cln::integer_length(n);
  for (std::size_t bit = 0; bit < bits; ++bit) {
    if (cln::logbitp(bit, n)) visit(map);
    if (bit + 1 < bits) map = compose(map, map);
  }
}

/// map^n v, n >= 0.
template <class Scalar>
BodyVelocities<Scalar> apply_power(const LinearMap<Scalar>& map, const cln::cl_I& n,
                                   BodyVelocities<Scalar> v) {
  for_each_factor(map, n, [&](const LinearMap<Scalar>& factor) { v = apply(factor, v); });
  return v;
}

/// One cycle: P, then Q.
template <Arithmetic Scalar>
LinearMap<Scalar> cycle_map(const Scalar& alpha) {
  return map_of<Scalar>(
      [&](const BodyVelocities<Scalar>& v) { return meet_B(alpha, meet_A(alpha, v)); });
}

/// A moves with unit speed, the others rest.
template <class Scalar>
BodyVelocities<Scalar> initial_velocities() {
  return {Scalar(1), Scalar(0), Scalar(0)};
}

}  // namespace magicmass::reference
