// SPDX-License-Identifier: MIT
// Three bodies: the paper's line, stepped by the engine; and any whose collisions come in turn, in
// numbers that need no order, such as balls.
#pragma once

#include <array>

#include "magicmass/simulator/engine.hpp"

namespace magicmass::simulator {

/// A approaches C at V and C approaches B, or a wall, at W, as seen from B, which is at place 0. A
/// and C collide first, then C and B, and so on, as long as there are collisions.
template <Numbers Scalar>
struct InTurn {
  std::array<Scalar, 3> velocities;  ///< of A, C and B
  Scalar time, place;                ///< of the last collision; at first of the next one
  std::int64_t collisions = 0;

  /// Speeds, and how wide the gaps are at time 0.
  struct Start {
    Scalar V{1}, W{0}, d_A{0}, d_B{1};
  };
  /// Masses of A and C, 1 / that of B, which is 0 for a wall, and restitution.
  InTurn(const Scalar& A, const Scalar& C, const Scalar& per_B, const Scalar& e,
         const Start& start = {})
      : velocities{start.V + start.W, start.W, 0},
        time(start.d_A / start.V),
        place(start.W * time - start.d_B),
        law_{columns(A, C, e), columns(C * per_B, Scalar(1), e)},
        open_(Scalar(0) - place) {}

  /// On to just after the next collision, which must exist.
  void step() {
    const std::size_t left = collisions % 2 == 0 ? 0 : 1, right = left + 1, other = 2 * (1 - left);
    auto& v = velocities;
    if (collisions++ > 0) {
      const Scalar wait = open_ / (v[left] - v[right]);
      open_ = (other == 0 ? v[1] - v[0] : v[2] - v[1]) * wait;
      place = place + v[1] * wait;
      time = time + wait;
    }
    const auto& [of_left, of_right] = law_[left];
    const Scalar u = v[left], w = v[right];
    v[left] = of_left[0] * u + of_right[0] * w;
    v[right] = of_left[1] * u + of_right[1] * w;
  }

private:
  /// Velocities after a collision where only the left or the right one moved, at 1: the law is
  /// linear, and errors that are only bounded grow least where it is applied as a matrix.
  using Columns = std::array<std::array<Scalar, 2>, 2>;
  std::array<Columns, 2> law_;
  Scalar open_;  ///< at the last collision, how wide the other gap was

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
