// SPDX-License-Identifier: MIT
// The event engine: any number of bodies on a line, walls or none. Each contact costs O(log bodies), and a body is
// moved only when it is met.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "magicmass/simulator/contact.hpp"
#include "magicmass/simulator/due_times.hpp"
#include "magicmass/simulator/field.hpp"
#include "magicmass/simulator/line.hpp"
#include "magicmass/simulator/rounding_margin.hpp"

namespace magicmass {

/// One contact: gap g closed. Bodies g - 1 and g met, or body 0 (g = 0) or the last one a wall.
template <class Scalar>
struct LineEvent {
  std::int64_t number;  ///< 1 for the first
  std::size_t gap;      ///< its number
  Scalar time;          ///< from the start
  Scalar position;      ///< where they met
  Scalar v_left;        ///< just after it; 0 for a wall
  Scalar v_right;       ///< likewise
};

/// Contacts that floating point cannot tell apart, and in exact numbers those that are at once.
struct Ties {
  std::int64_t near = 0;        ///< decisions closer than rounding can tell
  std::int64_t first_near = 0;  ///< number of the event after which the first of them fell
  std::int64_t simultaneous =
      0;  ///< contacts at the same time that share a body: the order below decides
};

/// What floating point could not hold. Where no contact is due after such a loss, that says nothing about the motion.
struct Losses {
  bool rebound = false;  ///< a pair met and, as rounded or underflowed, did not separate
  bool time = false;     ///< a pair approaches so slowly that when it meets does not fit
};

/// A body where it was last touched, at the time `since`.
template <class Scalar>
struct BodyState {
  Scalar mass;      ///< > 0
  Scalar position;  ///< at the time `since`
  Scalar velocity;  ///< from then on
  Scalar since;     ///< a time
};

/// Order of events: by time; of equal times the leftmost gap goes first. Gaps that share no body do not
/// influence each other, so only gaps side by side are compared for ties.
template <Field Scalar>
class LineMotion {
public:
  /// The line must be in order: positions not decreasing, masses > 0.
  explicit LineMotion(const Line<Scalar>& line)
      : left_wall_(line.left_wall),
        right_wall_(line.right_wall),
        restitution_(line.restitution),
        touched_(line.bodies(), false),
        due_(line.bodies() + 1),
        margin_(line),
        elastic_(line.restitution == Scalar(1)),
        is_rounded_(line.is_rounded) {
    bodies_.reserve(line.bodies());
    for (std::size_t i = 0; i < line.bodies(); ++i)
      bodies_.push_back({line.masses[i], line.positions[i], line.velocities[i], Scalar(0)});
    for (std::size_t gap = 0; gap <= bodies(); ++gap) schedule(gap);
    due_.replay(0, bodies());
  }

  /// The time of the next contact; nothing if there is none.
  std::optional<Scalar> next() const {
    const auto& due = due_[due_.first()];
    if (is_never<Scalar>(due)) return std::nullopt;
    return time_of<Scalar>(due);
  }

  /// Whether the next contact, which must exist, is due at `time` or before; a near tie where rounding cannot tell.
  bool is_due_by(const Scalar& time) {
    const std::size_t gap = due_.first();
    const Scalar due = time_of<Scalar>(due_[gap]);
    if constexpr (rounds)
      if (margin_.reaches_time(std::abs(due - time), std::min(due, time), sides(gap), sides(gap)))
        note_near();
    return !(time < due);
  }

  /// Runs the next contact, which must exist.
  LineEvent<Scalar> step() {
    const std::size_t gap = due_.first();
    const Scalar now = time_of<Scalar>(due_[gap]);
    note_ties(gap, now);
    now_ = now;
    ++events_;
    const LineEvent<Scalar> event = !has_left(gap)    ? meet_wall(gap, gap, *left_wall_)
                                    : !has_right(gap) ? meet_wall(gap - 1, gap, *right_wall_)
                                                      : meet(gap);
    if constexpr (rounds)
      lost_rebound_ = lost_rebound_ || !(closing(gap) <= -std::numeric_limits<Scalar>::min());
    due_.set(gap, never<Scalar>());
    const std::size_t first = has_left(gap) ? gap - 1 : gap;
    const std::size_t last = has_right(gap) ? gap + 1 : gap;
    if (first != gap) schedule(first);
    if (last != gap) schedule(last);
    due_.replay(first, last);
    if constexpr (rounds) fetch(due_.fetch_soon());
    return event;
  }

  /// How many there are.
  std::size_t bodies() const { return bodies_.size(); }
  /// Body i < bodies().
  const BodyState<Scalar>& body(std::size_t i) const { return bodies_[i]; }
  /// e of every contact.
  const Scalar& restitution() const { return restitution_; }
  /// Each body where it was last touched, all of them copied.
  Line<Scalar> line() const {
    Line<Scalar> line{{}, {}, {}, left_wall_, right_wall_, restitution_, is_rounded_};
    for (const BodyState<Scalar>& one : bodies_) {
      line.masses.push_back(one.mass);
      line.positions.push_back(one.position);
      line.velocities.push_back(one.velocity);
    }
    return line;
  }
  /// Of body i, if it meets nothing until then.
  Scalar position(std::size_t i, const Scalar& time) const {
    const BodyState<Scalar>& one = bodies_[i];
    return one.position + one.velocity * (time - one.since);
  }
  /// The time of the last event; 0 before the first.
  const Scalar& now() const { return now_; }
  /// How many there were.
  std::int64_t events() const { return events_; }
  /// So far.
  const Ties& ties() const { return ties_; }
  /// How far all that may be from the truth.
  const RoundingMargin<Scalar>& margin() const requires std::floating_point<Scalar> {
    return margin_;
  }
  /// So far, and at what comes next.
  Losses losses() const {
    Losses lost{lost_rebound_, false};
    for (std::size_t gap = 0; gap <= bodies(); ++gap)
      lost.time =
          lost.time || (closes(gap) && Scalar(0) < closing(gap) && is_never<Scalar>(due_[gap]));
    return lost;
  }
  /// Memory of its containers, without what numbers of a long type hold elsewhere.
  std::size_t bytes() const {
    return bodies_.capacity() * sizeof(BodyState<Scalar>) + touched_.capacity() / 8 + due_.bytes();
  }

private:
  std::vector<BodyState<Scalar>> bodies_;
  std::optional<Scalar> left_wall_, right_wall_;
  Scalar restitution_;
  std::vector<bool> touched_;
  DueTimes<Scalar> due_;
  struct NoMargin {
    explicit NoMargin(const Line<Scalar>& /*line*/) {}
  };
  static constexpr bool rounds = std::floating_point<Scalar>;
  std::conditional_t<rounds, RoundingMargin<Scalar>, NoMargin> margin_;
  bool elastic_;
  bool is_rounded_;
  Scalar now_ = Scalar(0);
  std::int64_t events_ = 0;
  Ties ties_;
  bool lost_rebound_ = false;

  /// A long chain is not in the cache: of the gap's four bodies, two or three lines.
  void fetch(std::size_t gap) const {
    for (const std::size_t i : {gap > 1 ? gap - 2 : 0, gap < bodies() ? gap : gap - 1})
      __builtin_prefetch(&bodies_[i]);
  }

  bool has_left(std::size_t gap) const { return gap > 0; }
  bool has_right(std::size_t gap) const { return gap < bodies(); }

  /// Are there two to meet: bodies, or a body and a wall?
  bool closes(std::size_t gap) const {
    return (has_left(gap) || left_wall_) && (has_right(gap) || right_wall_);
  }

  /// How fast a gap closes.
  Scalar closing(std::size_t gap) const {
    if (!has_left(gap)) return Scalar(0) - bodies_[0].velocity;
    if (!has_right(gap)) return bodies_[gap - 1].velocity;
    return bodies_[gap - 1].velocity - bodies_[gap].velocity;
  }

  Scalar width(std::size_t gap) const {
    const Scalar right = has_right(gap) ? position(gap, now_) : *right_wall_;
    return right - (has_left(gap) ? position(gap - 1, now_) : *left_wall_);
  }

  GapSides<Scalar> sides(std::size_t gap) const requires rounds {
    const Scalar wall = std::numeric_limits<Scalar>::infinity();
    return {has_left(gap) ? bodies_[gap - 1].mass : wall,
            has_left(gap) ? bodies_[gap - 1].velocity : Scalar(0),
            has_right(gap) ? bodies_[gap].mass : wall,
            has_right(gap) ? bodies_[gap].velocity : Scalar(0)};
  }

  void schedule(std::size_t gap) {
    if (!closes(gap)) return;
    const Scalar speed = closing(gap);
    if constexpr (rounds) note_near_rest(gap);
    if (!(Scalar(0) < speed)) {
      due_.set(gap, never<Scalar>());
      return;
    }
    const Scalar left_over = width(gap);
    Scalar due = Scalar(0) < left_over ? Scalar(now_ + left_over / speed) : now_;
    if constexpr (rounds)
      if (!(due < never<Scalar>())) due = never<Scalar>();  // not a number, either
    due_.set(gap, std::move(due));
  }

  LineEvent<Scalar> meet(std::size_t gap) {
    BodyState<Scalar>&left = bodies_[gap - 1], &right = bodies_[gap];
    // The heavier one is where it is: the clock's rounding moves the lighter one, and less momentum.
    const Scalar place = position(left.mass < right.mass ? gap : gap - 1, now_);
    const bool swap = elastic_ && left.mass == right.mass;
    if constexpr (rounds) {
      margin_.look_at(place);
      margin_.add_contact(now_, sides(gap), !swap || is_rounded_);
    }
    touch(gap - 1, place);
    touch(gap, place);
    if (swap) {
      std::swap(left.velocity, right.velocity);  // what the law gives, without rounding
    } else {
      const AfterContact<Scalar> after =
          elastic_ ? collide(left.mass, left.velocity, right.mass, right.velocity)
                   : collide(left.mass, left.velocity, right.mass, right.velocity, restitution_);
      left.velocity = after.first;
      right.velocity = after.second;
    }
    return {events_, gap, now_, place, left.velocity, right.velocity};
  }

  LineEvent<Scalar> meet_wall(std::size_t i, std::size_t gap, const Scalar& place) {
    if constexpr (rounds) margin_.add_contact(now_, sides(gap), !elastic_);
    touch(i, place);
    Scalar& u = bodies_[i].velocity;
    u = rebound(u, restitution_);
    return {
        events_, gap, now_, place, has_left(gap) ? u : Scalar(0), has_left(gap) ? Scalar(0) : u};
  }

  void touch(std::size_t i, const Scalar& place) {
    bodies_[i].position = place;
    bodies_[i].since = now_;
    touched_[i] = true;
  }

  void note_near() {
    if (ties_.near++ == 0) ties_.first_near = events_;
  }

  /// Do the two approach at all, or is that only rounding? What was never met moves as it was told to.
  void note_near_rest(std::size_t gap) {
    if (!(has_left(gap) && touched_[gap - 1]) && !(has_right(gap) && touched_[gap])) return;
    if (margin_.reaches_closing(sides(gap))) note_near();
  }

  void note_ties(std::size_t gap, const Scalar& now) {
    for (const std::size_t other : {gap - 1, gap + 1}) {
      if (other > bodies() || is_never<Scalar>(due_[other])) continue;
      if constexpr (rounds) {
        if (margin_.reaches_time(due_[other] - now, now, sides(gap), sides(other))) note_near();
      } else {
        if (!(now < time_of<Scalar>(due_[other]))) ++ties_.simultaneous;
      }
    }
  }
};

}  // namespace magicmass
