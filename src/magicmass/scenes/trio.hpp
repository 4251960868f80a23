// SPDX-License-Identifier: GPL-2.0-or-later
// A ball between two blocks, or a block and a wall, with any masses, restitution and start: the
// motion that the theorems are about.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <cln/integer.h>

#include "magicmass/scenes/ball.hpp"
#include "magicmass/scenes/scene.hpp"
#include "magicmass/simulator/in_turn.hpp"

namespace magicmass::scenes {

/// Throws Undecided for a ratio of the paper whose number is above 2^50.
Ball ball_of(const Value& value);

class Trio {
public:
  /// By default the ball touches A and rests before B, and V = L = 1.
  struct Start {
    std::vector<Value> masses;  ///< of A, C and B; no B: a wall
    Quadratic e = 1;
    Value V = value_of(1);                           ///< A approaches the ball
    Quadratic W_per_V = 0;                           ///< and the ball approaches B
    Value d_A = value_of(0), d_B = value_of(1);      ///< how wide the gaps are
    Value place = value_of(1), drift = value_of(0);  ///< of B or the wall, and its velocity
    int sign = 1;                                    ///< of these two, as in a mirror
  };
  /// Nothing where A does not meet the ball first, and where B runs away from collisions that would
  /// else never end.
  static std::optional<Trio> of(const Start& start);
  /// Nothing for other bodies, too, and where differences of places or ratios of velocities are not
  /// known to be values.
  static std::optional<Trio> of(const Scene& scene, bool is_mirrored = false);
  /// Blocks of mass 1, a ball of mass alpha.
  static Trio equal_blocks(const Value& alpha, const Quadratic& e);

  /// Exactly, in units of V, at most one more than `largest_tie` of them; places mean nothing.
  /// Masses must be exact. Throws std::domain_error for numbers of two fields.
  simulator::InTurn<Quadratic> first_collisions() const;
  /// Whether ball and B do not move, seen from each other, before A comes.
  bool is_at_rest() const { return from_.W_per_V == 0; }
  /// How many collisions; nothing where they never end. Throws Undecided where more bits than are
  /// allowed would be needed, or 2^62 collisions are not enough.
  std::optional<std::int64_t> count() const;

  /// How many they are where the paper's theorems say so: at its ratios, with blocks of mass 1 and
  /// nothing lost.
  std::optional<std::int64_t> at_threshold() const { return at_threshold_; }

  /// What all of the motion depends on, with the bits that are set now; in units of the mass of C.
  struct Shape {
    Ball C;  ///< its mass, in other units
    Ball A, per_B, e, q_e;
    Ball h_e = 0;  ///< where q_e is above 0
  };
  Shape shape() const;

  /// Or a collapse, from which all go on at one velocity.
  struct Collision {
    Ball time, position, v_left, v_right;
  };
  /// Collision j, from 0 on; where they never end, stepped.
  Collision collision(const Shape& s, std::int64_t j) const;
  /// When it takes place, where that is known exactly.
  std::optional<Quadratic> exact_time(std::int64_t j) const;
  /// The motion collision by collision, quicker than collision(), with a few bits lost.
  using Stepping = simulator::InTurn<Ball>;
  Stepping stepped(const Shape& s, std::int64_t collisions) const;
  /// The last one that was stepped.
  Collision collision(const Stepping& now) const;
  std::size_t bodies() const { return from_.masses.size(); }
  /// The gap that closes there.
  std::size_t gap(std::int64_t j) const { return j % 2 == 0 ? 1 : 2; }
  /// Velocities of all bodies after so many collisions.
  std::vector<Ball> velocities(const Shape& s, std::int64_t collisions) const;

  /// Where all bodies are at a time, after so many collisions.
  std::vector<Ball> places(const Shape& s, const Ball& time, std::int64_t collisions) const;

  /// Where and when infinitely many collisions come to an end.
  Collision collapse(const Shape& s) const;
  std::vector<Ball> masses(const Shape& s) const;

private:
  /// By Niven's theorem no angle pi/m has a cosine that is a root of a number of a quadratic field
  /// for larger m.
  static constexpr std::int64_t largest_tie = 12;
  Start from_;
  std::optional<std::int64_t> at_threshold_;

  using Velocities = std::array<Ball, 3>;
  Stepping::Start start() const;
  /// Places at a time after so many collisions, of A, C and B, as seen from B before it is met.
  Velocities places_seen(const Shape& s, const Stepping::Start& from, const Ball& moment,
                         std::int64_t collisions) const;
  /// Velocities, likewise.
  Velocities seen(const Shape& s, std::int64_t collisions) const;
  /// Whether theorems tell the end: by an angle, or by a collapse from which B does not run away.
  /// False, too, where that is too close to tell.
  bool has_told_end() const;
  Collision in_scene(std::int64_t j, const Ball& moment, const Ball& place,
                     const Velocities& u) const;
  Ball place_of(const Ball& time, const Ball& place) const;
  Ball velocity_of(const Ball& u) const;
  /// Of A and C, and 1 / that of B.
  std::optional<std::array<Quadratic, 3>> exact_masses() const;
  std::optional<Quadratic> exact_q_e() const;
  /// What is in a quadratic field is stepped: by Niven's theorem it is no large alpha_k.
  std::optional<std::int64_t> count_at_threshold() const;
};

}  // namespace magicmass::scenes
