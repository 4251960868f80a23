// SPDX-License-Identifier: MIT
// Three bodies: the paper's line, stepped by the engine; and any whose collisions come in turn.
#pragma once

#include <array>

#include "magicmass/simulator/engine.hpp"

namespace magicmass::simulator {

/// Velocities of A, C and B, or a wall, as seen from B at the start: A approaches C at V, and C
/// approaches B at W. A and C collide first, then C and B, and so on, as long as they collide.
template <Numbers Scalar>
struct InTurn {
  std::array<Scalar, 3> velocities;
  std::int64_t collisions = 0;

  /// Masses of A and C, 1 / that of B, which is 0 for a wall, and restitution.
  InTurn(const Scalar& A, const Scalar& C, const Scalar& per_B, const Scalar& e,
         const Scalar& V = 1, const Scalar& W = 0)
      : velocities{V + W, W, 0}, masses_{{{A, C}, {C * per_B, 1}}}, e_(e) {}

  /// Of the two that are next: they collide where it is above 0.
  Scalar approach() const { return velocities[left()] - velocities[left() + 1]; }
  /// On to just after the next collision, which must exist.
  void step() {
    const std::size_t i = left();
    Body<Scalar> one{masses_[i][0], 0, velocities[i]};
    Body<Scalar> other{masses_[i][1], 0, velocities[i + 1]};
    collide(one, other, e_);
    velocities[i] = one.velocity;
    velocities[i + 1] = other.velocity;
    ++collisions;
  }

private:
  std::size_t left() const { return collisions % 2 == 0 ? 0 : 1; }
  std::array<std::array<Scalar, 2>, 2> masses_;  // of both that collide, in any unit
  Scalar e_;
};

/// The motion of block A, ball C and block B from left to right. In floating point errors add up,
/// so that a count near a threshold may be off by one: near_ties() then is not 0.
template <Field Scalar>
class ThreeBodies {
public:
  /// The paper's: at time 0, A moves with V = 1 and touches C; C rests at 0, B rests at L = 1; the
  /// blocks have mass 1 and the ball alpha. Throws std::invalid_argument unless 0 < alpha, finite.
  explicit ThreeBodies(const Scalar& alpha)
      : engine_({{1, alpha, 1}, {0, 0, 1}, {1, 0, 0}, {}, {}}) {}

  /// On to just after the next collision, of A and C (gap 1) or C and B (gap 2), where one comes.
  std::optional<Collision<Scalar>> step() {
    return engine_.next() ? std::optional(engine_.step()) : std::nullopt;
  }

  /// A, C, B at the time of the last collision, just after it.
  std::array<Body<Scalar>, 3> bodies() const {
    std::array<Body<Scalar>, 3> all{engine_.bodies()[0], engine_.bodies()[1], engine_.bodies()[2]};
    for (std::size_t i = 0; i < 3; ++i) all[i].position = engine_.position(i, engine_.now());
    return all;
  }

  /// How often rounding may have decided whether two bodies approach; always 0 for exact fields.
  std::int64_t near_ties() const { return engine_.ties().near; }

private:
  Engine<Scalar> engine_;
};

}  // namespace magicmass::simulator
