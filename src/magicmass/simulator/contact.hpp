// SPDX-License-Identifier: MIT
// The one law of motion that the simulator knows.
#pragma once

#include <concepts>
#include <utility>

namespace magicmass::simulator {

/// Numbers with the four operations.
template <class T>
concept Numbers = std::copyable<T> && std::constructible_from<T, int> &&
    requires(const T& x, const T& y) {
  { x + y } -> std::convertible_to<T>;
  { x - y } -> std::convertible_to<T>;
  { x* y } -> std::convertible_to<T>;
  { x / y } -> std::convertible_to<T>;
};
/// Those with an order, too: float, double, exact rationals.
template <class T>
concept Field = Numbers<T> && requires(const T& x, const T& y) {
  { x < y } -> std::convertible_to<bool>;
  { x == y } -> std::convertible_to<bool>;
};

/// One of the balls and blocks: positive mass; one unit each for mass, length and speed.
template <Numbers Scalar>
struct Body {
  Scalar mass;
  Scalar position;
  Scalar velocity;
};

/// Collision of two bodies with restitution e, 0 < e <= 1: of each velocity relative to the centre
/// of mass, e times is turned round. Momentum is kept and, with e = 1, kinetic energy. Exact for
/// exact fields. In floating point the weights m/(m1+m2) come first, so that nothing overflows
/// while m1 + m2 and 2 max(|u1|, |u2|) are finite; each result is within 8 eps max(|u1|, |u2|).
/// Equal masses with e = 1 swap velocities, unrounded, where numbers can be told to be equal.
template <Numbers Scalar>
void collide(Body<Scalar>& first, Body<Scalar>& second, const Scalar& e = Scalar(1)) {
  bool is_elastic = false;
  if constexpr (Field<Scalar>) {
    is_elastic = e == Scalar(1);
    if (is_elastic && first.mass == second.mass) return std::swap(first.velocity, second.velocity);
  }
  const Scalar mass = first.mass + second.mass;
  const Scalar centre =
      (first.mass / mass) * first.velocity + (second.mass / mass) * second.velocity;
  for (Body<Scalar>* body : {&first, &second}) {
    const Scalar u = body->velocity;
    body->velocity = is_elastic ? centre + centre - u : centre + e * (centre - u);
  }
}

}  // namespace magicmass::simulator
