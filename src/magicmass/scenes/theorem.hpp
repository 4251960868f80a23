// SPDX-License-Identifier: GPL-2.0-or-later
// The motions that theorems tell, counted, not stepped: of one trio, and of Newton's cradle of the
// paper, where equal blocks with balls of magic ratios between them are one trio after the other,
// to a wall and back.
#pragma once

#include <map>
#include <utility>

#include "magicmass/scenes/run.hpp"
#include "magicmass/scenes/trio.hpp"

namespace magicmass::scenes {

/// By theorems cradle.*, a block that comes with V leaves itself and the ball at rest and hands V
/// on to the next block, whose way is then the straight line on which the first one came. From a
/// wall it comes back: then the motion runs backwards in time, until all is as it was.
class Trios {
public:
  /// Nothing where the scene is neither of them, as it is and in a mirror. Of a cradle all but the
  /// first body are at rest, nothing is lost, blocks have mass 1, and no block reaches what is
  /// behind it before the ball before it rests.
  static std::optional<Trios> of(const Scene& scene);

  /// The only one.
  const Trio* alone() const { return is_cradle_ ? nullptr : &pairs_[0].trio; }
  /// How many collisions; nothing where they never end: of a cradle between two walls, or in a
  /// collapse.
  std::optional<std::int64_t> count() const;

  /// With the bits that are set now, as all that follows.
  Trio::Collision collision(std::int64_t j) const;
  /// When it takes place, where that is known to be in the field of V and places.
  std::optional<Quadratic> exact_time(std::int64_t j) const;
  /// The gap that closes there.
  std::size_t gap(std::int64_t j) const;
  std::size_t bodies() const { return is_cradle_ ? 2 * pairs_.size() + 1 : alone()->bodies(); }
  /// The body at the end that V is handed on to.
  std::size_t last() const { return is_mirrored_ ? 0 : bodies() - 1; }
  std::vector<Ball> velocities(std::int64_t collisions) const;
  /// Where all bodies are at a time, after so many collisions.
  std::vector<Ball> places(const Ball& time, std::int64_t collisions) const;
  std::vector<Ball> masses() const;
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
  std::int64_t way_ = 0;                     // collisions of one way
  Quadratic x_, V_;                          // the straight line: where it begins at time 0
  std::optional<Quadratic> ahead_, behind_;  // walls
  /// What is the same for each ball of one magic ratio, by bits and its number.
  mutable std::map<std::pair<int, std::int64_t>, Trio::Shape> shapes_;

  /// Likewise, but not in a mirror.
  static std::optional<Trios> of(const std::vector<Value>& masses,
                                 const simulator::Line<Quadratic>& line);
  const Trio::Shape& shape_of(const Pair& pair) const;
  /// After so many collisions all comes again, only later.
  std::int64_t period() const { return 2 * way_ + 2; }
  struct Moment;
  Moment moment(std::int64_t j) const;
  /// Places or velocities of all bodies, likewise.
  std::vector<Ball> seen(std::vector<Ball> all) const;
  Quadratic time_at(const Quadratic& place) const { return (place - x_) / V_; }
};

inline constexpr const char* at_until = "the scene ends at the time `until`";
std::string at_limit(std::int64_t limit);

/// The run of a trio or a cradle, each number the nearest double; of what is few and exact only its
/// plan, since there numbers may be just between doubles. Nothing for other scenes, and
/// where a collision may be as late as `until`. Throws Undecided where
/// a trio that nothing cuts off has more collisions than can be counted.
std::optional<Result> by_theorem(const Scene& scene);
/// Every so many of its collisions; of a collapse at least the first three, and more while doubles
/// can tell their times apart.
void stream_by_theorem(const Scene& scene, std::int64_t every, const Sink& sink);
/// Where its bodies are at a time, which is after so many collisions at most.
std::vector<double> places_by_theorem(const Scene& scene, std::int64_t most, const Value& time);

}  // namespace magicmass::scenes
