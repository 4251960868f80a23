// The motions that theorems tell, counted, not stepped: of a ball between two blocks, or a block
// and a wall, with any masses, restitution and start; and of the paper's cradle of Newton, where
// equal blocks with balls of magic ratios between them are trios in a row, to a wall and back.
#pragma once

#include <map>

#include "magicmass/scenes/scene.hpp"
#include "magicmass/simulator/three_bodies.hpp"

namespace magicmass::scenes {

class Trio {
public:
  /// By default the ball touches A and rests before B, and V = L = 1.
  struct Start {
    std::vector<Value> masses;  ///< of A, C and B; no B: a wall
    Value e = value_of(1);
    Value V = value_of(1);                           ///< A approaches the ball
    Surd W_per_V = 0;                                ///< and the ball approaches B
    Value d_A = value_of(0), d_B = value_of(1);      ///< how wide the gaps are
    Value place = value_of(1), drift = value_of(0);  ///< of B or the wall, and its velocity
  };
  /// Nothing, and no reason, where A is not first to meet the ball; of three at once the faster is.
  static Found<Trio> of(const Start& start);
  /// Nothing, too, for other bodies, and where differences or ratios of its numbers are not known.
  static Found<Trio> of(const Scene& scene);
  /// Blocks of mass 1, a ball of mass alpha.
  static Trio equal_blocks(const Value& alpha, const Value& e);

  /// Whether ball and B do not move, seen from each other, before A comes.
  bool is_at_rest() const { return from_.W_per_V == 0; }
  /// How many collisions; nothing where they never end. Throws Undecided where more bits than are
  /// allowed would be needed, or 2^62 collisions are not enough.
  std::optional<std::int64_t> count() const;

  /// How many they are where the paper's theorems say so: at its ratios, with blocks of mass 1 and
  /// nothing lost, from rest or with the ball alone in motion.
  std::optional<std::int64_t> at_threshold() const { return at_threshold_; }

  /// What all of the motion depends on, with the bits that are set now; in units of the mass of C.
  struct Shape {
    Ball C;  ///< its mass, in other units
    Ball A, per_B, e, q_e;
    Ball h_e = 0, step_sine = 1;  ///< where q_e is above 0
    Ball y_e = 1;                 ///< where it is below
  };
  Shape shape() const;

  /// A approaches C, and C approaches B, which is at 0; how wide the gaps are at time 0.
  struct FromB {
    Ball V = 1, W = 0, d_A = 0, d_B = 1;
  };
  FromB start() const;
  const Start& from() const { return from_; }
  using Collision = simulator::Collision<Ball>;
  /// Collision j, from 0 on.
  Collision collision(const Shape& s, std::int64_t j) const;
  /// Whether collisions go on for ever, and time with them.
  bool is_endless() const { return end_sign_ == 0; }
  /// When it takes place, where that is known exactly; `is_hard`: after as many steps as it takes.
  std::optional<Surd> exact_time(std::int64_t j, bool is_hard) const;
  std::size_t bodies() const { return from_.masses.size(); }
  /// Velocities of all bodies after so many collisions.
  std::vector<Ball> velocities(const Shape& s, std::int64_t collisions) const;

  /// Where all bodies are at a time, after so many collisions.
  std::vector<Ball> places(const Shape& s, const Ball& time, std::int64_t collisions) const;

  /// Where and when a collapse ends, without a number or gap; from then on all have one velocity.
  Collision collapse(const Shape& s) const;
  /// Whether they have come to it by this time.
  bool has_collapsed(const Value& time) const;

  using Speeds = std::array<Surd, 5>;
  static constexpr std::size_t longest_tie = 1U << 15U;  ///< in bits

private:
  /// For larger m no angle pi/m has a cosine whose square is a surd: the Galois group of
  /// cos(2 pi/m) is that of units modulo m but for signs, and has an element of higher order.
  static constexpr std::int64_t largest_tie = 24;
  Start from_;
  bool is_at_once_ = false;  ///< all collisions take place with the first
  int end_sign_ = 1;         ///< where q_e is 0 or less
  /// In units of the mass of C; nothing where a ratio is no surd.
  struct Exact {
    Surd A, per_B, e, q_e;
  };
  std::optional<Exact> exact_;
  std::optional<std::int64_t> at_threshold_;

  /// The first approach speeds, over e for each two. Nothing likewise.
  std::optional<Speeds> first_speeds(const Surd& V, const Surd& W) const;
  /// The one before collision j, that goes with these; nothing where it is too long.
  std::optional<Surd> speed(Speeds first, const Surd& factor, std::int64_t j) const;
  /// The sign of bodies.end_speed for any V and W, where q_e is 0 or less. Nothing likewise.
  std::optional<int> end_sign(const Surd& V, const Surd& W) const;
  /// At most so many; nothing, too, for more, and where numbers become too long.
  std::optional<std::int64_t> exact_count(std::int64_t most) const;
  using Velocities = std::array<Ball, 3>;
  /// Velocities after so many collisions, of A, C and B, as seen from B before it is met.
  Velocities seen(const Shape& s, std::int64_t collisions) const;
  Ball place_of(const Ball& time, const Ball& place) const;
  Ball velocity_of(const Ball& u) const;
  /// Only the first two are surds.
  std::optional<std::int64_t> count_at_threshold() const;
};

/// By theorems cradle.*, a block that comes with V leaves itself and the ball at rest and hands V
/// on to the next block, whose way is then the straight line on which the first one came. From a
/// wall it comes back: then the motion runs backwards in time, until all is as it was.
class Trios {
public:
  /// Nothing where the scene is neither of them, as it is and in a mirror. Of a cradle all but the
  /// first body are at rest, nothing is lost, blocks have mass 1, and no block reaches what is
  /// behind it before the ball before it rests.
  static Found<Trios> of(const Scene& scene);

  const Trio* alone() const { return is_cradle_ ? nullptr : &pairs_[0].trio; }
  /// Whether they may go on for ever, and time with them: between two walls, or after B.
  bool is_endless() const { return !alone() || alone()->is_endless(); }
  /// How many collisions; nothing where they never end, in a collapse, too.
  std::optional<std::int64_t> count() const;

  /// With the bits that are set now, as all that follows.
  Trio::Collision collision(std::int64_t j) const;
  /// When it takes place, where that is known to be a surd; as of a Trio.
  std::optional<Surd> exact_time(std::int64_t j, bool is_hard) const;
  std::size_t bodies() const { return is_cradle_ ? 2 * pairs_.size() + 1 : alone()->bodies(); }
  /// How many collisions come before those of a trio.
  std::int64_t thrown() const { return thrown_ ? 1 : 0; }
  /// The body at the end that V is handed on to.
  std::size_t last() const { return is_mirrored_ ? 0 : bodies() - 1; }
  std::vector<Ball> velocities(std::int64_t collisions) const;
  /// Where all bodies are at a time, after so many collisions.
  std::vector<Ball> places(const Ball& time, std::int64_t collisions) const;
  /// Where and when infinitely many collisions of a trio come to an end.
  Trio::Collision collapse() const { return seen(alone()->collapse(alone()->shape())); }
  /// Of so many collisions, those at each gap.
  std::vector<std::int64_t> counts(std::int64_t collisions) const;
  /// A collision that was made out without a mirror, as the scene has it.
  Trio::Collision seen(const Trio::Collision& c) const;

private:
  struct Pair {
    Trio trio;
    std::int64_t k;       ///< its ball has the ratio alpha_k
    std::int64_t before;  ///< collisions of one way before its own
    std::int64_t first;   ///< which body its block is
  };
  std::vector<Pair> pairs_;  // in the order in which they are met on the way out
  bool is_cradle_ = true, is_mirrored_ = false;
  std::int64_t way_ = 0;                // collisions of one way
  Surd x_, V_;                          // the straight line: where it begins at time 0
  std::optional<Surd> ahead_, behind_;  // walls
  /// Where the ball hits the wall before it meets the block: then the trio is that of a ball that
  /// has always come from beyond the wall, as slowly as it leaves it.
  std::optional<simulator::Line<Surd>> thrown_;
  /// What is the same for each ball of one magic ratio, by bits and its number.
  mutable std::map<std::pair<int, std::int64_t>, Trio::Shape> shapes_;

  /// Likewise, but not in a mirror.
  static Found<Trios> as_it_is(const Scene& scene);
  static Found<Trios> cradle(const std::vector<Value>& masses, const simulator::Line<Surd>& line);
  static Found<Trios> off_wall(const std::vector<Value>& masses, const simulator::Line<Surd>& line);
  static Trios of_one(const Trio& trio);
  const Trio::Shape& shape_of(const Pair& pair) const;
  /// After so many collisions all comes again, only later.
  std::int64_t period() const { return 2 * way_ + 2; }
  struct Moment;
  Moment moment(std::int64_t j) const;
  /// Places or velocities of all bodies, likewise.
  std::vector<Ball> seen(std::vector<Ball> all) const;
  Surd time_at(const Surd& place) const { return (place - x_) / V_; }
};

}  // namespace magicmass::scenes
