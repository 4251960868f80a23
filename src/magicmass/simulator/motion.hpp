// SPDX-License-Identifier: MIT
#pragma once

namespace magicmass {

/// Velocities of A, B and the ball C at one moment.
template <class Scalar>
struct Velocities {
  Scalar a;  ///< of A
  Scalar b;  ///< of B
  Scalar c;  ///< of C

  /// All three are equal.
  friend bool operator==(const Velocities&, const Velocities&) = default;
};

/// Places of A, B and the ball C at one moment.
template <class Scalar>
struct Positions {
  Scalar a;  ///< of A
  Scalar b;  ///< of B
  Scalar c;  ///< of C

  /// All three are equal.
  friend bool operator==(const Positions&, const Positions&) = default;
};

/// Velocities or Positions in another unit.
template <template <class> class Triple, class Scalar>
Triple<Scalar> scaled(const Triple<Scalar>& triple, const Scalar& unit) {
  return {triple.a * unit, triple.b * unit, triple.c * unit};
}

/// The block that met the ball.
enum class Body { A, B };

/// complete: no pair approaches any more. limited: the largest number of collisions allowed came first.
enum class RunStatus { complete, limited };

}  // namespace magicmass
