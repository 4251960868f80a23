// SPDX-License-Identifier: MIT
// The event engine: a collision costs O(log bodies), and a body is moved only when it is met. Eigen
// would not serve: no step is one on all bodies.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <tuple>

#include "magicmass/simulator/rounding_margin.hpp"

namespace magicmass::simulator {

/// Gap g closed: bodies g - 1 and g met, or body 0 (g = 0) or the last one a wall.
template <class Scalar>
struct Collision {
  std::int64_t number;  ///< 1 for the first
  std::size_t gap;
  Scalar time;
  Scalar position;
  Scalar v_left;   ///< just after it; 0 for a wall
  Scalar v_right;  ///< likewise
};

/// When a gap closes. What closes at the same time is told apart by what a mirror shows, too: the
/// faster first, then the pair of the larger mass, of which a wall has more than any.
template <Field Scalar>
struct Due {
  Scalar time;
  Scalar closing;  ///< speed, > 0
  bool has_wall;
  Scalar mass;  ///< of the bodies beside the gap

  bool operator==(const Due&) const = default;
  friend bool operator<(const Due& x, const Due& y) {
    return std::tie(x.time, y.closing, y.has_wall, y.mass) <
           std::tie(y.time, x.closing, x.has_wall, x.mass);
  }
};

/// Which gap closes first: a tournament in a heap whose leaves stay; a change costs O(log gaps).
template <Field Scalar>
class DueTimes {
public:
  using Entry = std::optional<Due<Scalar>>;  ///< nothing: never

  explicit DueTimes(std::size_t gaps) : due_(std::bit_ceil(gaps)), winner_(2 * due_.size()) {
    for (std::size_t gap = 0; gap < due_.size(); ++gap) winner_[due_.size() + gap] = gap;
    for (std::size_t node = due_.size(); node-- > 1;) winner_[node] = winner_[2 * node];
  }

  const Entry& operator[](std::size_t gap) const { return due_[gap]; }
  void set(std::size_t gap, Entry due) {
    due_[gap] = std::move(due);
    for (std::size_t node = (due_.size() + gap) / 2; node > 0; node /= 2) {
      const std::size_t left = winner_[2 * node];
      const std::size_t right = winner_[2 * node + 1];
      winner_[node] = is_sooner(due_[right], due_[left]) ? right : left;
    }
  }
  /// The gap that closes first, of equals the leftmost; any one where none does.
  std::size_t first() const { return winner_[1]; }

private:
  std::vector<Entry> due_;
  std::vector<std::size_t> winner_;  // of node n; nodes 2n and 2n + 1 are below it

  static bool is_sooner(const Entry& x, const Entry& y) { return x && (!y || *x < *y); }
};

struct Ties {
  std::int64_t near = 0;        ///< decisions closer than rounding can tell
  std::int64_t first_near = 0;  ///< so many collisions were before the first of them
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
      : line_(without_fault(line)), due_(line.masses.size() + 1), margin_(line) {
    const Scalar zero(0);
    const Scalar wall = rounds ? std::numeric_limits<Scalar>::infinity() : zero;
    all_.reserve(line.masses.size() + 2);
    all_.push_back({{wall, line.left_wall.value_or(zero), zero}});
    for (std::size_t i = 0; i < line.masses.size(); ++i)
      all_.push_back({{line.masses[i], line.positions[i], line.velocities[i]}});
    all_.push_back({{wall, line.right_wall.value_or(zero), zero}});
    for (std::size_t gap = 0; gap <= line.masses.size(); ++gap) schedule(gap);
  }

  /// The time of the next collision, or nothing where none comes.
  std::optional<Scalar> next() const {
    if (waiting() > 0) return now_;
    const auto& due = due_[due_.first()];
    return due ? std::optional<Scalar>(due->time) : std::nullopt;
  }
  /// Whether the next one, which must exist, comes by this time; counts a tie too near to tell.
  bool is_due_by(const Scalar& time) {
    const Scalar due = *next();
    if constexpr (rounds) {
      const auto side = sides(due_.first());
      if (waiting() == 0 &&
          margin_.reaches_time(std::abs(due - time), std::min(due, time), side, side))
        note_near();
    }
    return !(time < due);
  }
  /// Goes on to the next collision, which must exist. Collisions at one time that go together are
  /// told one after the other; the bodies are as after all of them.
  Collision<Scalar> step() {
    if (waiting() == 0) meet_next();
    return collisions_[std::size_t(told_++)];
  }
  /// How many of those that go together have not been told.
  std::int64_t waiting() const { return std::ssize(collisions_) - told_; }
  /// Ends the motion before those that went together last.
  void take_back() {
    for (auto met = before_.rbegin(); met != before_.rend(); ++met) all_[met->first] = met->second;
  }
  /// Ends the motion at a time, or after the last collision: counts a tie if more may be due then.
  void end([[maybe_unused]] const std::optional<Scalar>& at) {
    if constexpr (rounds) {
      const Scalar time = at.value_or(now_ + margin_.errors().time);
      for (std::size_t gap = 0; gap + 1 < all_.size(); ++gap) {
        if (!due_[gap]) continue;
        const Scalar apart = due_[gap]->time - time;
        if (!(0 < apart) || margin_.reaches_time(apart, time, sides(gap), sides(gap))) note_near();
      }
    }
  }

  std::span<const MovingBody<Scalar>> bodies() const {
    return std::span(all_).subspan(1, all_.size() - 2);
  }
  /// Where a body is at a time, if it meets nothing until then.
  Scalar position(std::size_t body, const Scalar& time) const { return place(body + 1, time); }
  /// Of the last collision; 0 before the first.
  const Scalar& now() const { return now_; }
  const Ties& ties() const { return ties_; }
  /// Of what was told so far, or before the first near decision.
  const Errors<Scalar>& errors() const { return ties_.near > 0 ? certain_ : margin_.errors(); }
  /// Whether two approach, but at no time of floating point: no next one then says nothing of them.
  bool has_lost() const {
    for (std::size_t gap = 0; gap + 1 < all_.size(); ++gap)
      if (closes(gap) && Scalar(0) < sides(gap).closing() && !due_[gap]) return true;
    return false;
  }

private:
  static constexpr bool rounds = std::floating_point<Scalar>;

  // Gap g is between g and g + 1. First and last are walls, which are there or not; their mass is
  // infinite in floating point and matters in no exact field.
  std::vector<MovingBody<Scalar>> all_;
  Line<Scalar> line_;  // as it was at time 0
  DueTimes<Scalar> due_;
  RoundingMargin<Scalar> margin_;
  Scalar now_{0};
  std::int64_t number_ = 0;
  Ties ties_;
  Errors<Scalar> certain_;                     // where there are some
  std::vector<std::size_t> together_;          // gaps that close now
  std::vector<Collision<Scalar>> collisions_;  // of now, of which told_ were told
  std::int64_t told_ = 0;
  std::vector<std::pair<std::size_t, MovingBody<Scalar>>> before_;  // of these, bodies as they were

  /// Are there two to meet?
  bool closes(std::size_t gap) const {
    return (gap > 0 || line_.left_wall) && (gap + 2 < all_.size() || line_.right_wall);
  }
  bool has_wall(std::size_t gap) const { return gap == 0 || gap + 2 == all_.size(); }
  Scalar place(std::size_t i, const Scalar& time) const {
    return all_[i].position + all_[i].velocity * (time - all_[i].since);
  }
  Sides<Scalar> sides(std::size_t gap) const { return {all_[gap], all_[gap + 1]}; }

  void schedule(std::size_t gap) {
    if (gap + 1 >= all_.size() || !closes(gap)) return;
    note_near_rest(gap);
    const Scalar speed = sides(gap).closing();
    due_.set(gap, std::nullopt);
    if (!(Scalar(0) < speed)) return;
    const Scalar width = place(gap + 1, now_) - place(gap, now_);
    const Scalar time = Scalar(0) < width ? Scalar(now_ + width / speed) : now_;
    if constexpr (rounds)
      if (!(time <= std::numeric_limits<Scalar>::max())) return;
    due_.set(gap, Due<Scalar>{time, speed, has_wall(gap), all_[gap].mass + all_[gap + 1].mass});
  }

  /// All gaps that are due first and alike, row by row of neighbours.
  void meet_next() {
    together_.clear();
    collisions_.clear();
    before_.clear();
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
      if (met.gap > 0) schedule(met.gap - 1);
      schedule(met.gap + 1);
    }
  }

  void meet(std::size_t gap) {
    note_error(gap);
    const Scalar where = meeting_place(gap);
    for (const std::size_t i : {gap, gap + 1}) {
      put(i, where);
      if (has_wall(gap)) turn_round(i, Scalar(0));  // a wall's stays 0
    }
    if (!has_wall(gap)) collide(all_[gap], all_[gap + 1], line_.restitution);
    tell(gap);
  }
  /// Gaps `gap` and gap + 1, mirror images of each other.
  void meet_both(std::size_t gap) {
    note_error(gap);
    note_error(gap + 1);
    const Scalar where = place(gap + 1, now_);
    for (const std::size_t i : {gap, gap + 1, gap + 2}) {
      put(i, where);
      turn_round(i, all_[gap + 1].velocity);
    }
    tell(gap);
    tell(gap + 1);
  }
  /// Seen from what moves at this velocity.
  void turn_round(std::size_t i, const Scalar& centre) {
    all_[i].velocity = centre - line_.restitution * (all_[i].velocity - centre);
  }
  /// The heavier one is where it is: the clock's rounding moves the lighter one.
  Scalar meeting_place(std::size_t gap) const {
    const Scalar left = place(gap, now_);
    const Scalar right = place(gap + 1, now_);
    const Scalar& m1 = all_[gap].mass;
    const Scalar& m2 = all_[gap + 1].mass;
    return m1 < m2 ? right : m2 < m1 ? left : Scalar((left + right) / Scalar(2));
  }
  void put(std::size_t i, const Scalar& where) {
    before_.emplace_back(i, all_[i]);
    all_[i] = {{all_[i].mass, where, all_[i].velocity}, now_, true};
  }
  void tell(std::size_t gap) {
    collisions_.push_back(
        {++number_, gap, now_, all_[gap].position, all_[gap].velocity, all_[gap + 1].velocity});
  }

  void note_error([[maybe_unused]] std::size_t gap) {
    if constexpr (rounds) {
      const bool is_swap = all_[gap].mass == all_[gap + 1].mass && !line_.is_rounded;
      const bool only_turns = line_.restitution == Scalar(1) && (has_wall(gap) || is_swap);
      margin_.add_collision(now_, sides(gap), !only_turns);
    }
  }
  void note_near() {
    if (ties_.near++ > 0) return;
    ties_.first_near = number_;
    certain_ = margin_.errors();
  }
  /// Do they approach, or is that rounding? What was never met moves as it was told to, 0 is exact.
  void note_near_rest([[maybe_unused]] std::size_t gap) {
    if constexpr (rounds) {
      const auto may_be_off = [&](const MovingBody<Scalar>& body) {
        return body.was_met || (line_.has_rounded_velocities && body.velocity != 0);
      };
      if ((may_be_off(all_[gap]) || may_be_off(all_[gap + 1])) && margin_.reaches_rest(sides(gap)))
        note_near();
    }
  }
  /// Of this gap and the next ones, where they are still due.
  void note_ties([[maybe_unused]] std::size_t gap) {
    if constexpr (rounds) {
      margin_.look_at(place(gap, now_));
      for (const std::size_t other : {gap - 1, gap + 1}) {
        if (other >= all_.size() - 1 || !due_[other]) continue;
        if (margin_.reaches_time(due_[other]->time - now_, now_, sides(gap), sides(other)))
          note_near();
      }
    }
  }
};

}  // namespace magicmass::simulator
