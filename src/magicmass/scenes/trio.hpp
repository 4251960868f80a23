// SPDX-License-Identifier: GPL-2.0-or-later
// A body that moves to the right towards a ball at rest before a block at rest, or before a wall:
// the motion that the theorems are about, with any masses and restitution.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <cln/integer.h>

#include "magicmass/scenes/ball.hpp"
#include "magicmass/scenes/scene.hpp"
#include "magicmass/simulator/contact.hpp"

namespace magicmass::scenes {

Ball ball_of(const Quadratic& x);

class Trio {
public:
  /// Nothing for what moves otherwise.
  static std::optional<Trio> of(const Places& places);
  /// Blocks of mass 1, a ball of mass alpha, V = L = 1.
  static Trio equal_blocks(const Value& alpha, const Quadratic& e);

  /// By Niven's theorem no angle pi/m has a cosine that is a root of a number of a quadratic field
  /// for larger m.
  static constexpr std::int64_t largest_tie = 12;

  /// How many collisions; nothing where they never end. Throws Undecided where more bits than are
  /// allowed would be needed, or 2^62 collisions are not enough.
  std::optional<std::int64_t> count() const;

  /// What all of the motion depends on, with the bits that are set now; in units of V, L and the
  /// mass of C. Throws std::domain_error where the masses are too far apart.
  struct Shape {
    Ball A, per_B, C, e, q_e;
    Ball h_e = 0;  ///< where q_e is above 0
  };
  Shape shape() const;

  struct Collision {
    Ball time, position, v_left, v_right;
  };
  /// Collision j, from 0 on; where they never end, stepped.
  Collision collision(const Shape& s, std::int64_t j) const;
  /// When it takes place, where that is known to be in the field of V, L and places.
  std::optional<Quadratic> exact_time(std::int64_t j) const;
  /// The motion collision by collision, in the units of a Shape; a wall is the last body.
  struct Stepping {
    std::array<Ball, 3> velocities{1, 0, 0};
    /// At each gap, velocities after a collision where only the left or the right one moved, at 1.
    /// The law is linear, and balls grow least where it is applied as a matrix.
    std::array<std::array<std::array<Ball, 2>, 2>, 2> law;
    Ball time = 0, place = 0;  ///< of the last collision
    Ball open = 1;             ///< how wide the other gap was then
    std::int64_t j = 0;        ///< the next one
  };
  Stepping begin(const Shape& s) const;
  /// The next collision, which must exist: quicker than collision(), with a few bits lost.
  Collision step(const Shape& s, Stepping& now) const;
  std::size_t bodies() const { return B_ ? 3 : 2; }
  /// The gap that closes there.
  std::size_t gap(std::int64_t j) const { return j % 2 == 0 ? 1 : 2; }
  /// Velocities of all bodies after so many collisions.
  std::vector<Ball> velocities(const Shape& s, std::int64_t collisions) const;

  struct Collapse {
    Ball time, position, velocity;
  };
  /// Where and when infinitely many collisions come to an end.
  Collapse collapse(const Shape& s) const;
  std::vector<Ball> masses(const Shape& s) const;
  /// Of so many collisions, those at each gap.
  std::vector<std::int64_t> counts(std::int64_t collisions) const;

private:
  Value A_, C_;
  std::optional<Value> B_;  ///< nothing: a wall
  Quadratic e_, V_, L_;
  Quadratic start_;        ///< when A meets C
  Quadratic place_;        ///< where C is at time 0
  Quadratic drift_;        ///< velocity of C and B before that
  bool is_paper_ = false;  ///< equal blocks of mass 1, nothing lost

  Ball place_of(const Ball& time, const Ball& from_C) const;
  std::optional<Quadratic> exact_q_e() const;
  std::optional<std::int64_t> by_theorem() const;
};

}  // namespace magicmass::scenes
