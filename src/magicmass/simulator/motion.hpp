// SPDX-License-Identifier: MIT
#pragma once

namespace magicmass {

/// Velocities of A, B and the ball C at one moment.
template <class Scalar>
struct BodyVelocities {
  Scalar a;  ///< of A
  Scalar b;  ///< of B
  Scalar c;  ///< of C

  /// All three are equal.
  friend bool operator==(const BodyVelocities&, const BodyVelocities&) = default;
};

/// Places of A, B and the ball C at one moment.
template <class Scalar>
struct BodyPositions {
  Scalar a;  ///< of A
  Scalar b;  ///< of B
  Scalar c;  ///< of C

  /// All three are equal.
  friend bool operator==(const BodyPositions&, const BodyPositions&) = default;
};

/// BodyVelocities or BodyPositions in another unit.
template <template <class> class Triple, class Scalar>
Triple<Scalar> scaled(const Triple<Scalar>& triple, const Scalar& unit) {
  return {triple.a * unit, triple.b * unit, triple.c * unit};
}

/// The block that met the ball.
enum class Body { A, B };

/// complete: no pair approaches any more. limited: the largest number of collisions allowed came first.
enum class RunStatus { complete, limited };

}  // namespace magicmass
