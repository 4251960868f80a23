// SPDX-License-Identifier: MIT
// The one law of motion the simulator and the reference know.
#pragma once

#include "magicmass/simulator/field.hpp"

namespace magicmass {

/// Velocities of the two bodies of a contact, just after it.
template <class Scalar>
struct AfterContact {
  Scalar first;   ///< of the body given first
  Scalar second;  ///< of the other
};

/// Elastic contact of bodies (m1, u1) and (m2, u2): each velocity is reflected in the velocity U of their centre of
/// mass, which keeps momentum and kinetic energy (Ee & Lee eqs. eq:ac to eq:Euc-Qn, two at a time). Masses positive, in
/// one unit; velocities in another. Exact for exact scalars. In floating point the weights m/(m1+m2) come first, so
/// that nothing overflows while m1 + m2 and 2 max(|u1|, |u2|) are finite; each result is then within 6 eps max(|u1|,
/// |u2|): U carries 2 eps, doubled, and the subtraction's own rounding of at most 3 max(|u1|, |u2|) 1.5 eps.
template <Arithmetic Scalar>
AfterContact<Scalar> collide(const Scalar& m1, const Scalar& u1, const Scalar& m2,
                             const Scalar& u2) {
  const Scalar mass = m1 + m2;
  const Scalar centre = (m1 / mass) * u1 + (m2 / mass) * u2;
  const Scalar twice = centre + centre;
  return {twice - u1, twice - u2};
}

/// The same with restitution e, 0 < e <= 1: what is left of each velocity relative to the centre is turned round (Ee &
/// Lee "Inelastic collisions"). Within 8 eps max(|u1|, |u2|): U twice, 4 eps, the difference and its product 1 eps
/// each, and the sum 1.5 eps.
template <Arithmetic Scalar>
AfterContact<Scalar> collide(const Scalar& m1, const Scalar& u1, const Scalar& m2, const Scalar& u2,
                             const Scalar& e) {
  const Scalar mass = m1 + m2;
  const Scalar centre = (m1 / mass) * u1 + (m2 / mass) * u2;
  return {centre + e * (centre - u1), centre + e * (centre - u2)};
}

/// Velocity after meeting a wall, which does not move, with restitution e, 0 < e <= 1. Exact for exact scalars, else
/// within half an ulp.
template <Arithmetic Scalar>
Scalar rebound(const Scalar& u, const Scalar& e) {
  return Scalar(0) - e * u;
}

}  // namespace magicmass
