// SPDX-License-Identifier: GPL-2.0-or-later
// Newton's cradle of the paper: equal blocks with balls of magic ratios between them. One trio
// after the other, to a wall and back.
#pragma once

#include <map>

#include "magicmass/scenes/trio.hpp"

namespace magicmass::scenes {

/// By theorems cradle.*, a block that comes with V leaves itself and the ball at rest and hands V
/// on to the next block, whose way is then the straight line on which the first one came. From a
/// wall it comes back: then the motion runs backwards in time, until all is as it was.
class Cradle {
public:
  /// Nothing unless all but the first body are at rest, nothing is lost, blocks have mass 1, and no
  /// block reaches what is behind it before the ball before it rests.
  static std::optional<Cradle> of(const Places& places);

  /// How many collisions; nothing between two walls, where they never end.
  std::optional<std::int64_t> count() const;

  /// What is the same for each ball of one magic ratio, by its number.
  using Shape = std::map<std::int64_t, Trio::Shape>;
  Shape shape() const;
  Trio::Collision collision(const Shape& s, std::int64_t j) const;
  /// When it takes place, where that is known to be in the field of V and places.
  std::optional<Quadratic> exact_time(std::int64_t j) const;
  struct Stepping {
    std::int64_t collisions;
  };
  Stepping stepped(const Shape& /*s*/, std::int64_t collisions) const { return {collisions}; }
  Trio::Collision step(const Shape& s, Stepping& now) const {
    return collision(s, now.collisions++);
  }
  std::size_t bodies() const { return 2 * pairs_.size() + 1; }
  std::size_t gap(std::int64_t j) const;
  std::vector<Ball> velocities(const Shape& s, std::int64_t collisions) const;
  /// Where all bodies are at a time, after so many collisions.
  std::vector<Ball> places(const Shape& s, const Ball& time, std::int64_t collisions) const;
  std::vector<Ball> masses(const Shape& s) const;
  std::vector<std::int64_t> counts(std::int64_t collisions) const;

private:
  struct Pair {
    Trio trio;
    std::int64_t k;       ///< its ball has the ratio alpha_k
    std::int64_t before;  ///< collisions of one way before its own
  };
  std::vector<Pair> pairs_;                  // in the order in which they are met on the way out
  std::int64_t way_ = 0;                     // collisions of one way
  Quadratic x_, V_;                          // the straight line: where it begins at time 0
  std::optional<Quadratic> ahead_, behind_;  // walls

  /// After so many collisions all comes again, only later.
  std::int64_t period() const { return 2 * way_ + 2; }
  struct Moment;
  Moment moment(std::int64_t j) const;
  /// Which body its block is.
  std::size_t first_of(const Pair& pair) const {
    return 2 * static_cast<std::size_t>(&pair - pairs_.data());
  }
  Quadratic time_of(const Moment& m, const Quadratic& on_first_way) const;
  Quadratic time_at(const Quadratic& place) const { return (place - x_) / V_; }
};

}  // namespace magicmass::scenes
