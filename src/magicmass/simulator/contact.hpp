// SPDX-License-Identifier: MIT
// The one law of motion that the simulator knows.
#pragma once

#include <concepts>

namespace magicmass::simulator {

/// Numbers with the four operations and an order: float, double, exact rationals.
template <class T>
concept Field = std::copyable<T> && std::constructible_from<T, int> &&
    requires(const T& x, const T& y) {
  { x + y } -> std::convertible_to<T>;
  { x - y } -> std::convertible_to<T>;
  { x* y } -> std::convertible_to<T>;
  { x / y } -> std::convertible_to<T>;
  { x < y } -> std::convertible_to<bool>;
  { x == y } -> std::convertible_to<bool>;
};

/// One of the balls and blocks: positive mass; one unit each for mass, length and speed.
template <Field Scalar>
struct Body {
  Scalar mass;
  Scalar position;
  Scalar velocity;
};

/// Elastic collision of two bodies: each velocity is reflected in that of their centre of mass,
/// which keeps momentum and kinetic energy. Exact for exact fields. In floating point the weights
/// m/(m1+m2) come first, so that nothing overflows while m1 + m2 and 2 max(|u1|, |u2|) are finite;
/// each result is then within 6 eps max(|u1|, |u2|). Equal masses swap velocities, unrounded.
template <Field Scalar>
void collide(Body<Scalar>& first, Body<Scalar>& second) {
  const Scalar u1 = first.velocity;
  const Scalar u2 = second.velocity;
  if (first.mass == second.mass) {
    first.velocity = u2;
    second.velocity = u1;
    return;
  }
  const Scalar mass = first.mass + second.mass;
  const Scalar centre = (first.mass / mass) * u1 + (second.mass / mass) * u2;
  first.velocity = centre + centre - u1;
  second.velocity = centre + centre - u2;
}

}  // namespace magicmass::simulator
