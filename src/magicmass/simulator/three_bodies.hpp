// SPDX-License-Identifier: MIT
// Block A, ball C and block B from left to right, stepped collision by collision.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include "magicmass/simulator/contact.hpp"

namespace magicmass::simulator {

/// One collision: of body `left` and its right neighbour, in the order A, C, B.
template <Field Scalar>
struct Event {
  std::size_t left;
  Scalar time;
  Scalar position;
};

/// The motion of three bodies. In floating point errors add up from collision to collision, so a
/// count near a threshold may be off by one: near_ties() then is not 0.
template <Field Scalar>
class ThreeBodies {
public:
  /// The paper's: at time 0, A moves with V = 1 and touches C; C rests at 0, B rests at L = 1; the
  /// blocks have mass 1 and the ball alpha. Throws std::invalid_argument unless alpha > 0 (and, in
  /// floating point, finite).
  explicit ThreeBodies(const Scalar& alpha)
      : bodies_{{{Scalar(1), Scalar(0), Scalar(1)},
                 {alpha, Scalar(0), Scalar(0)},
                 {Scalar(1), Scalar(1), Scalar(0)}}} {
    if (!(Scalar(0) < alpha) || !(Scalar(0) < Scalar(1) / alpha))
      throw std::invalid_argument("alpha must be a positive finite number");
  }

  /// Goes on to just after the next collision; returns nothing where none comes. What the ball met
  /// last it cannot meet next: the two move apart.
  std::optional<Event<Scalar>> step() {
    const std::size_t left = next_;
    const Scalar closing = bodies_[left].velocity - bodies_[left + 1].velocity;
    note_near_tie(left, closing);
    if (!(Scalar(0) < closing)) return std::nullopt;
    const Scalar wait = (bodies_[left + 1].position - bodies_[left].position) / closing;
    time_ = time_ + wait;
    for (Body<Scalar>& body : bodies_) body.position = body.position + body.velocity * wait;
    const Scalar place = bodies_[left == 0 ? 0 : 2].position;
    bodies_[1].position = place;  // in floating point the ball may be beside the block
    note_error(bodies_[left], bodies_[left + 1]);
    collide(bodies_[left], bodies_[left + 1]);
    next_ = 1 - left;
    return Event<Scalar>{left, time_, place};
  }

  /// A, C, B at the time of the last collision, just after it.
  const std::array<Body<Scalar>, 3>& bodies() const { return bodies_; }

  /// How often rounding may have decided whether two bodies approach; always 0 for exact fields.
  std::int64_t near_ties() const { return near_ties_; }

private:
  std::array<Body<Scalar>, 3> bodies_;
  std::size_t next_ = 0;  // the left one of the two that meet next, if they do
  Scalar time_{0};
  Scalar velocity_error_{0};
  std::int64_t near_ties_ = 0;

  // Velocities are measured as sqrt(sum m v^2). A collision is a reflection in that length, so
  // errors only add up: masses and results together cost 8 eps (sqrt(m1) |u1| + sqrt(m2) |u2|),
  // and 10 are taken. Equal masses only swap.
  void note_error([[maybe_unused]] const Body<Scalar>& first,
                  [[maybe_unused]] const Body<Scalar>& second) {
    if constexpr (std::floating_point<Scalar>) {
      const Scalar rounded = first.mass == second.mass ? 0 : 10;
      const Scalar size = std::sqrt(first.mass) * std::abs(first.velocity) +
                          std::sqrt(second.mass) * std::abs(second.velocity);
      velocity_error_ += rounded * std::numeric_limits<Scalar>::epsilon() * size;
    }
  }

  // A difference of two velocities is within sqrt(1/m1 + 1/m2) of such a length.
  void note_near_tie([[maybe_unused]] std::size_t left, [[maybe_unused]] const Scalar& closing) {
    if constexpr (std::floating_point<Scalar>) {
      const Scalar spread = std::sqrt(1 / bodies_[left].mass + 1 / bodies_[left + 1].mass);
      if (std::abs(closing) <= velocity_error_ * spread && velocity_error_ > 0) ++near_ties_;
    }
  }
};

}  // namespace magicmass::simulator
