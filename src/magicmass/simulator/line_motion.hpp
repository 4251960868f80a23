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
  std::size_t gap;
  Scalar time;
  Scalar position;
  Scalar v_left;  ///< just after it; 0 for a wall
  Scalar v_right;
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

/// Order of events: by time; of equal times the leftmost gap goes first. Gaps that share no body do not
/// influence each other, so only gaps side by side are compared for ties.
template <Field Scalar>
class LineMotion {
public:
  /// The line must be in order: positions not decreasing, masses > 0.
  explicit LineMotion(Line<Scalar> line)
      : line_(std::move(line)),
        since_(line_.bodies(), Scalar(0)),
        touched_(line_.bodies(), false),
        due_(line_.bodies() + 1),
        margin_(line_),
        elastic_(line_.restitution == Scalar(1)) {
    for (std::size_t gap = 0; gap <= line_.bodies(); ++gap) schedule(gap);
    due_.replay(0, line_.bodies());
  }

  /// The time of the next contact; nothing if there is none.
  std::optional<Scalar> next() const {
    const auto& due = due_[due_.first()];
    if (is_never<Scalar>(due)) return std::nullopt;
    return time_of<Scalar>(due);
  }

  /// Runs the next contact, which must exist.
  LineEvent<Scalar> step() {
    const std::size_t gap = due_.first();
    const Scalar now = time_of<Scalar>(due_[gap]);
    note_ties(gap, now);
    now_ = now;
    ++events_;
    LineEvent<Scalar> event = gap == 0                ? meet_wall(0, gap)
                              : gap == line_.bodies() ? meet_wall(gap - 1, gap)
                                                      : meet(gap);
    if constexpr (rounds)
      lost_rebound_ = lost_rebound_ || !(closing(gap) <= -std::numeric_limits<Scalar>::min());
    due_.set(gap, never<Scalar>());
    const std::size_t first = gap == 0 ? 0 : gap - 1;
    const std::size_t last = gap == line_.bodies() ? gap : gap + 1;
    if (first != gap) schedule(first);
    if (last != gap) schedule(last);
    due_.replay(first, last);
    return event;
  }

  const Line<Scalar>& line() const { return line_; }  ///< each body where it was last touched
  const Scalar& now() const { return now_; }
  std::int64_t events() const { return events_; }
  const Ties& ties() const { return ties_; }
  Losses losses() const {
    Losses lost{lost_rebound_, false};
    for (std::size_t gap = 0; gap <= line_.bodies(); ++gap)
      lost.time =
          lost.time || (closes(gap) && Scalar(0) < closing(gap) && is_never<Scalar>(due_[gap]));
    return lost;
  }
  /// Memory of its containers, without what numbers of a long type hold elsewhere.
  std::size_t bytes() const {
    const std::size_t numbers = line_.masses.capacity() + line_.positions.capacity() +
                                line_.velocities.capacity() + since_.capacity();
    return numbers * sizeof(Scalar) + touched_.capacity() / 8 + due_.bytes();
  }
  Scalar position(std::size_t body, const Scalar& time) const {
    return line_.positions[body] + line_.velocities[body] * (time - since_[body]);
  }

private:
  Line<Scalar> line_;
  std::vector<Scalar> since_;
  std::vector<bool> touched_;
  DueTimes<Scalar> due_;
  struct NoMargin {
    explicit NoMargin(const Line<Scalar>& /*line*/) {}
  };
  static constexpr bool rounds = std::floating_point<Scalar>;
  std::conditional_t<rounds, RoundingMargin<Scalar>, NoMargin> margin_;
  bool elastic_;
  Scalar now_ = Scalar(0);
  std::int64_t events_ = 0;
  Ties ties_;
  bool lost_rebound_ = false;

  bool has_left(std::size_t gap) const { return gap > 0; }
  bool has_right(std::size_t gap) const { return gap < line_.bodies(); }

  /// Are there two to meet: bodies, or a body and a wall?
  bool closes(std::size_t gap) const {
    return (has_left(gap) || line_.left_wall) && (has_right(gap) || line_.right_wall);
  }

  /// How fast a gap closes.
  Scalar closing(std::size_t gap) const {
    if (!has_left(gap)) return Scalar(0) - line_.velocities[0];
    if (!has_right(gap)) return line_.velocities[gap - 1];
    return line_.velocities[gap - 1] - line_.velocities[gap];
  }

  Scalar width(std::size_t gap) const {
    const Scalar right = has_right(gap) ? position(gap, now_) : *line_.right_wall;
    return right - (has_left(gap) ? position(gap - 1, now_) : *line_.left_wall);
  }

  void schedule(std::size_t gap) {
    if (!closes(gap)) return;
    const Scalar speed = closing(gap);
    if constexpr (rounds) note_near_rest(gap, speed);
    if (!(Scalar(0) < speed)) {
      due_.set(gap, never<Scalar>());
      return;
    }
    const Scalar left_over = width(gap);
    due_.set(gap, Scalar(0) < left_over ? Scalar(now_ + left_over / speed) : now_);
  }

  LineEvent<Scalar> meet(std::size_t gap) {
    const std::size_t i = gap - 1;
    const Scalar place = position(i, now_);
    touch(i, place);
    touch(gap, place);
    const Scalar &m1 = line_.masses[i], &m2 = line_.masses[gap];
    Scalar &u1 = line_.velocities[i], &u2 = line_.velocities[gap];
    if (elastic_ && m1 == m2) {
      std::swap(u1, u2);  // what the law gives, without rounding
    } else {
      const AfterContact<Scalar> after =
          elastic_ ? collide(m1, u1, m2, u2) : collide(m1, u1, m2, u2, line_.restitution);
      u1 = after.first;
      u2 = after.second;
      if constexpr (rounds) margin_.add_contact();
    }
    return {events_, gap, now_, place, u1, u2};
  }

  LineEvent<Scalar> meet_wall(std::size_t body, std::size_t gap) {
    const Scalar place = gap == 0 ? *line_.left_wall : *line_.right_wall;
    touch(body, place);
    Scalar& u = line_.velocities[body];
    u = rebound(u, line_.restitution);
    if constexpr (rounds)
      if (!elastic_) margin_.add_contact();
    return {events_, gap, now_, place, gap == 0 ? Scalar(0) : u, gap == 0 ? u : Scalar(0)};
  }

  void touch(std::size_t body, const Scalar& place) {
    line_.positions[body] = place;
    since_[body] = now_;
    touched_[body] = true;
    if constexpr (rounds) margin_.look_at(place);
  }

  void note_near() {
    if (ties_.near++ == 0) ties_.first_near = events_;
  }

  /// Do the two approach at all, or is that only rounding? What was never met moves as it was told to.
  void note_near_rest(std::size_t gap, const Scalar& speed) {
    if (!(has_left(gap) && touched_[gap - 1]) && !(has_right(gap) && touched_[gap])) return;
    const Scalar wall = std::numeric_limits<Scalar>::infinity();
    if (margin_.reaches_closing(speed, has_left(gap) ? line_.masses[gap - 1] : wall,
                                has_right(gap) ? line_.masses[gap] : wall))
      note_near();
  }

  void note_ties(std::size_t gap, const Scalar& now) {
    for (const std::size_t other : {gap - 1, gap + 1}) {
      if (other > line_.bodies() || is_never<Scalar>(due_[other])) continue;
      if constexpr (rounds) {
        if (margin_.reaches_time(due_[other] - now, now, closing(gap), closing(other))) note_near();
      } else {
        if (!(now < time_of<Scalar>(due_[other]))) ++ties_.simultaneous;
      }
    }
  }
};

}  // namespace magicmass
