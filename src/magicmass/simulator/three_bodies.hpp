// SPDX-License-Identifier: MIT
// Block A, ball C and block B from left to right: the paper's line, stepped by the engine.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "magicmass/simulator/engine.hpp"

namespace magicmass::simulator {

/// The motion of three bodies. In floating point errors add up from collision to collision, so a
/// count near a threshold may be off by one: near_ties() then is not 0.
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
