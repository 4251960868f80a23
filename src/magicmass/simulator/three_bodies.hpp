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
      : velocities{V + W, W, 0}, law_{columns(A, C, e), columns(C * per_B, Scalar(1), e)} {}

  /// On to just after the next collision, which must exist.
  void step() {
    const std::size_t left = collisions++ % 2 == 0 ? 0 : 1;
    const auto& [of_left, of_right] = law_[left];
    const Scalar u = velocities[left], w = velocities[left + 1];
    velocities[left] = of_left[0] * u + of_right[0] * w;
    velocities[left + 1] = of_left[1] * u + of_right[1] * w;
  }

private:
  /// Velocities after a collision where only the left or the right one moved, at 1: the law is
  /// linear.
  using Columns = std::array<std::array<Scalar, 2>, 2>;
  std::array<Columns, 2> law_;

  static Columns columns(const Scalar& m1, const Scalar& m2, const Scalar& e) {
    Columns all;
    for (const int i : {0, 1}) {
      Body<Scalar> left{m1, 0, 1 - i}, right{m2, 0, i};
      collide(left, right, e);
      all[static_cast<std::size_t>(i)] = {left.velocity, right.velocity};
    }
    return all;
  }
};

/// The motion of block A, ball C and block B from left to right. In floating point errors add up
/// from collision to collision, so a count near a threshold may be off by one: near_ties() then is
/// not 0.
template <Field Scalar>
class ThreeBodies {
public:
  /// The paper's: at time 0, A moves with V = 1 and touches C; C rests at 0, B rests at L = 1; the
  /// blocks have mass 1 and the ball alpha. Throws std::invalid_argument unless alpha > 0 (and, in
  /// floating point, finite).
  explicit ThreeBodies(const Scalar& alpha)
      : engine_({{1, alpha, 1}, {0, 0, 1}, {1, 0, 0}, {}, {}}) {}

  /// Goes on to just after the next collision, of A and C (gap 1) or of C and B (gap 2); returns
  /// nothing where none comes.
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
