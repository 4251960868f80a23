// SPDX-License-Identifier: MIT
// The event engine: a collision costs O(log bodies), and a body is moved only when it is met.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "magicmass/simulator/due_times.hpp"
#include "magicmass/simulator/line.hpp"
#include "magicmass/simulator/rounding_margin.hpp"

namespace magicmass::simulator {

/// Gap g closed: bodies g - 1 and g met, or body 0 (g = 0) or the last one a wall.
template <Field Scalar>
struct Collision {
  std::int64_t number;  ///< 1 for the first
  std::size_t gap;
  Scalar time;
  Scalar position;
  Scalar v_left;   ///< just after it; 0 for a wall
  Scalar v_right;  ///< likewise
};

struct Ties {
  std::int64_t near = 0;          ///< decisions closer than rounding can tell
  std::int64_t first_near = 0;    ///< so many collisions were before the first of them
  std::int64_t simultaneous = 0;  ///< pairs of gaps that closed at once and share a body
};

/// A body where it was at the time `since`, its velocity from then on.
template <Field Scalar>
struct MovingBody : Body<Scalar> {
  Scalar since{0};
  bool was_met = false;
};

/// The motion of a line, earliest collisions first. Of those at one time that share a body the
/// faster goes first, then the pair of larger mass. What is alike even then is a row of gaps that
/// is its own mirror image, and so is what is done: its middle gap goes first, or its middle two
/// both at once, against the body between them. So a mirrored line has the mirrored motion.
template <Field Scalar>
class Engine {
public:
  /// Throws std::invalid_argument for a line with a fault.
  explicit Engine(const Line<Scalar>& line)
      : e_(line.restitution),
        walls_{line.left_wall, line.right_wall},
        is_rounded_(line.is_rounded),
        due_(line.masses.size() + 1),
        margin_(line) {
    if (const auto found = fault(line))
      throw std::invalid_argument(found->key + ": " + found->what + "; allowed: " + found->allowed);
    bodies_.reserve(line.masses.size());
    for (std::size_t i = 0; i < line.masses.size(); ++i)
      bodies_.push_back({{line.masses[i], line.positions[i], line.velocities[i]}});
    for (std::size_t gap = 0; gap <= bodies_.size(); ++gap) schedule(gap);
  }

  /// The time of the next collision, or nothing where none comes.
  std::optional<Scalar> next() const {
    if (told_ < collisions_.size()) return now_;
    const auto& due = due_[due_.first()];
    return due ? std::optional<Scalar>(due->time) : std::nullopt;
  }
  /// Whether the next one, which must exist, comes by this time; counts a near tie where rounding
  /// cannot tell.
  bool is_due_by(const Scalar& time) {
    const Scalar due = *next();
    if constexpr (rounds) {
      const Sides<Scalar> beside = sides(due_.first());
      const bool is_open = told_ == collisions_.size();
      if (is_open &&
          margin_.reaches_time(std::abs(due - time), std::min(due, time), beside, beside))
        note_near();
    }
    return !(time < due);
  }
  /// Goes on to the next collision, which must exist. Collisions at one time that go together are
  /// told one after the other; the bodies are as after all of them.
  Collision<Scalar> step() {
    if (told_ == collisions_.size()) meet_next();
    return collisions_[told_++];
  }

  const std::vector<MovingBody<Scalar>>& bodies() const { return bodies_; }
  /// Where a body is at a time, if it meets nothing until then.
  Scalar position(std::size_t body, const Scalar& time) const {
    const MovingBody<Scalar>& it = bodies_[body];
    return it.position + it.velocity * (time - it.since);
  }
  /// Of the last collision; 0 before the first.
  const Scalar& now() const { return now_; }
  const Ties& ties() const { return ties_; }
  /// Whether floating point lost a rebound (two met and, as rounded, did not separate), or holds no
  /// time at which two meet that approach. No next collision then says nothing about the motion.
  bool has_lost() const {
    for (std::size_t gap = 0; gap <= bodies_.size(); ++gap)
      if (closes(gap) && Scalar(0) < closing(gap) && !due_[gap]) return true;
    return lost_rebound_;
  }

private:
  static constexpr bool rounds = std::floating_point<Scalar>;
  struct NoMargin {
    explicit NoMargin(const Line<Scalar>& /*line*/) {}
  };
  template <class S>
  struct Margin : std::type_identity<NoMargin> {};
  template <std::floating_point S>
  struct Margin<S> : std::type_identity<RoundingMargin<S>> {};

  std::vector<MovingBody<Scalar>> bodies_;
  Scalar e_;
  std::array<std::optional<Scalar>, 2> walls_;  // left, right
  bool is_rounded_;
  DueTimes<Scalar> due_;
  typename Margin<Scalar>::type margin_;
  Scalar now_{0};
  std::int64_t number_ = 0;
  Ties ties_;
  bool lost_rebound_ = false;
  std::vector<std::size_t> together_;          // gaps that close now
  std::vector<Collision<Scalar>> collisions_;  // of now, of which told_ were told
  std::size_t told_ = 0;

  bool is_left_end(std::size_t gap) const { return gap == 0; }
  bool is_right_end(std::size_t gap) const { return gap == bodies_.size(); }
  bool is_end(std::size_t gap) const { return is_left_end(gap) || is_right_end(gap); }
  const std::optional<Scalar>& wall(std::size_t gap) const { return walls_[gap == 0 ? 0 : 1]; }
  /// Are there two to meet?
  bool closes(std::size_t gap) const { return !is_end(gap) || wall(gap); }

  Scalar v_left(std::size_t gap) const {
    return is_left_end(gap) ? Scalar(0) : bodies_[gap - 1].velocity;
  }
  Scalar v_right(std::size_t gap) const {
    return is_right_end(gap) ? Scalar(0) : bodies_[gap].velocity;
  }
  Scalar closing(std::size_t gap) const { return v_left(gap) - v_right(gap); }
  Scalar width(std::size_t gap) const {
    const Scalar right = is_right_end(gap) ? *wall(gap) : position(gap, now_);
    return right - (is_left_end(gap) ? *wall(gap) : position(gap - 1, now_));
  }
  Scalar mass(std::size_t gap) const {
    const Scalar left = is_left_end(gap) ? Scalar(0) : bodies_[gap - 1].mass;
    return is_right_end(gap) ? left : left + bodies_[gap].mass;
  }
  Sides<Scalar> sides(std::size_t gap) const requires rounds {
    const Scalar wall_mass = std::numeric_limits<Scalar>::infinity();
    return {is_left_end(gap) ? wall_mass : bodies_[gap - 1].mass, v_left(gap),
            is_right_end(gap) ? wall_mass : bodies_[gap].mass, v_right(gap)};
  }

  void schedule(std::size_t gap) {
    if (!closes(gap)) return;
    if constexpr (rounds) note_near_rest(gap);
    const Scalar speed = closing(gap);
    typename DueTimes<Scalar>::Entry due;
    if (Scalar(0) < speed) {
      const Scalar rest = width(gap);
      const Scalar time = Scalar(0) < rest ? Scalar(now_ + rest / speed) : now_;
      if constexpr (rounds) {
        if (time <= std::numeric_limits<Scalar>::max()) due = {time, speed, mass(gap)};
      } else {
        due = {time, speed, mass(gap)};
      }
    }
    due_.set(gap, due);
  }

  /// All gaps that are due first and alike, row by row of neighbours.
  void meet_next() {
    together_.clear();
    collisions_.clear();
    told_ = 0;
    const Due<Scalar> due = *due_[due_.first()];
    now_ = due.time;
    for (std::size_t gap = due_.first(); due_[gap] && *due_[gap] == due; gap = due_.first()) {
      note_ties(gap);
      together_.push_back(gap);
      due_.set(gap, std::nullopt);
    }
    for (std::size_t i = 0; i < together_.size();) {
      const std::size_t first = i++;
      while (i < together_.size() && together_[i] == together_[i - 1] + 1) ++i;
      const std::size_t middle = together_[first + (i - first - 1) / 2];
      if ((i - first) % 2 == 0)
        meet_both(middle);
      else
        meet(middle);
    }
    for (const std::size_t gap : together_) schedule(gap);
    for (const Collision<Scalar>& met : collisions_) {
      if (!is_left_end(met.gap)) schedule(met.gap - 1);
      if (!is_right_end(met.gap)) schedule(met.gap + 1);
    }
  }

  void meet(std::size_t gap) {
    note_error(gap);
    if (is_end(gap)) {
      MovingBody<Scalar>& body = is_left_end(gap) ? bodies_.front() : bodies_.back();
      put(body, *wall(gap));
      body.velocity = Scalar(0) - e_ * body.velocity;
    } else {
      MovingBody<Scalar>& left = bodies_[gap - 1];
      MovingBody<Scalar>& right = bodies_[gap];
      const Scalar place = meeting_place(gap);
      put(left, place);
      put(right, place);
      collide(left, right, e_);
    }
    tell(gap);
  }
  /// Gaps `gap` and gap + 1, mirror images of each other.
  void meet_both(std::size_t gap) {
    note_error(gap);
    note_error(gap + 1);
    const Scalar place = position(gap, now_);
    const Scalar centre = bodies_[gap].velocity;
    for (std::size_t i = gap - 1; i <= gap + 1; ++i) {
      put(bodies_[i], place);
      if (i != gap) bodies_[i].velocity = centre - e_ * (bodies_[i].velocity - centre);
    }
    tell(gap);
    tell(gap + 1);
  }
  /// The heavier body is where it is: the clock's rounding moves the lighter one.
  Scalar meeting_place(std::size_t gap) const {
    const Scalar left = position(gap - 1, now_);
    const Scalar right = position(gap, now_);
    const Scalar& m1 = bodies_[gap - 1].mass;
    const Scalar& m2 = bodies_[gap].mass;
    return m1 < m2 ? right : m2 < m1 ? left : Scalar((left + right) / Scalar(2));
  }
  void put(MovingBody<Scalar>& body, const Scalar& place) {
    body.position = place;
    body.since = now_;
    body.was_met = true;
    if constexpr (rounds) margin_.look_at(place);
  }
  void tell(std::size_t gap) {
    if constexpr (rounds)
      lost_rebound_ = lost_rebound_ || !(closing(gap) <= -std::numeric_limits<Scalar>::min());
    const Scalar& place = bodies_[is_left_end(gap) ? 0 : gap - 1].position;
    collisions_.push_back({++number_, gap, now_, place, v_left(gap), v_right(gap)});
  }

  void note_error([[maybe_unused]] std::size_t gap) {
    if constexpr (rounds) {
      const Sides<Scalar> beside = sides(gap);
      const bool only_turns = e_ == Scalar(1) && (is_end(gap) || beside.m1 == beside.m2);
      margin_.add_collision(now_, beside, !only_turns || (is_rounded_ && !is_end(gap)));
    }
  }
  void note_near() {
    if (ties_.near++ == 0) ties_.first_near = number_;
  }
  /// Do the two approach, or is that only rounding? What was never met moves as it was told to.
  void note_near_rest(std::size_t gap) requires rounds {
    const bool is_told = (is_left_end(gap) || !bodies_[gap - 1].was_met) &&
                         (is_right_end(gap) || !bodies_[gap].was_met);
    if (!is_told && margin_.reaches_rest(sides(gap))) note_near();
  }
  /// Of this gap and the next ones, where they are still due.
  void note_ties(std::size_t gap) {
    for (const std::size_t other : {gap - 1, gap + 1}) {
      if (other > bodies_.size() || !due_[other]) continue;
      if constexpr (rounds) {
        if (margin_.reaches_time(due_[other]->time - now_, now_, sides(gap), sides(other)))
          note_near();
      } else if (due_[other]->time == now_) {
        ++ties_.simultaneous;
      }
    }
  }
};

}  // namespace magicmass::simulator
