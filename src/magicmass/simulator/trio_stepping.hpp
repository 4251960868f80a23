// SPDX-License-Identifier: MIT
// A ball between two blocks, or a block and a wall, stepped contact by contact without a queue: what the ball met last
// it cannot meet next.
#pragma once

#include <cstdint>
#include <utility>

#include "magicmass/counts.hpp"
#include "magicmass/simulator/contact.hpp"
#include "magicmass/simulator/line.hpp"
#include "magicmass/simulator/motion.hpp"

namespace magicmass {

/// A contact by the shares of their relative velocity that block and ball take over, computed once.
template <class Scalar>
struct ContactWeights {
  Scalar of_block;  ///< what the block takes over
  Scalar of_ball;   ///< what the ball takes over

  /// Both velocities after the contact, in their places.
  void apply(Scalar& block, Scalar& ball) const {
    const Scalar faster = block - ball;
    block = block - of_block * faster;
    ball = ball + of_ball * faster;
  }
};

/// From the collision law at unit velocities: each share is what the one that rests gets, and within 2 eps. So each
/// velocity is within 16 eps of the larger of the two speeds, and a light ball's small share is not lost in a block's.
template <Arithmetic Scalar>
ContactWeights<Scalar> contact_weights(const Scalar& block, const Scalar& ball, const Scalar& e) {
  return {collide(block, Scalar(0), ball, Scalar(1), e).first,
          collide(block, Scalar(1), ball, Scalar(0), e).second};
}

/// The block is a wall, which keeps its velocity: the ball's, relative to it, is turned round.
template <Arithmetic Scalar>
ContactWeights<Scalar> wall_weights(const Scalar& e) {
  return {Scalar(0), Scalar(1) - rebound(Scalar(1), e)};
}

/// The contacts of A with the ball, and of the ball with B.
template <class Scalar>
struct Trio {
  ContactWeights<Scalar> P;  ///< of A with the ball
  ContactWeights<Scalar> Q;  ///< of the ball with B
};

/// The paper's: blocks of mass 1, a ball of mass alpha, elastic contacts.
template <Arithmetic Scalar>
Trio<Scalar> trio_of(const Scalar& alpha) {
  const ContactWeights<Scalar> weights = contact_weights(Scalar(1), alpha, Scalar(1));
  return {weights, weights};
}

/// Bodies A, C and B of a line, or A, C and its right wall.
template <Arithmetic Scalar>
Trio<Scalar> trio_of(const Line<Scalar>& line) {
  const auto& m = line.masses;
  const Scalar& e = line.restitution;
  return {contact_weights(m[0], m[1], e),
          line.right_wall ? wall_weights(e) : contact_weights(m[2], m[1], e)};
}

/// Their velocities, a wall's included.
template <Arithmetic Scalar>
BodyVelocities<Scalar> trio_velocities(const Line<Scalar>& line) {
  return {line.velocities[0], line.right_wall ? Scalar(0) : line.velocities[2], line.velocities[1]};
}

/// The contacts of A among so many, A first; the others are B's.
constexpr Counts counts_of(std::int64_t contacts) {
  return {contacts - contacts / 2, contacts / 2};
}

/// After so many contacts, do the next two approach?
template <Field Scalar>
bool approach(const BodyVelocities<Scalar>& v, std::int64_t contacts) {
  return contacts % 2 == 0 ? v.c < v.a : v.b < v.c;
}

/// Steps velocities alone, A first, until the next pair does not approach or after `most` contacts; returns how many
/// there were. v is changed in place. From one contact to the next the ball's velocity goes through
/// a subtraction, a multiplication and an addition.
/// on_event(n, velocities after it), n = 1, 2, ...
template <Field Scalar, class OnEvent>
std::int64_t step_trio(const Trio<Scalar>& trio, BodyVelocities<Scalar>& v, std::int64_t most,
                       OnEvent&& on_event) {
  std::int64_t contacts = 0;
  BodyVelocities<Scalar> w = v;
  const ContactWeights<Scalar> P = trio.P, Q = trio.Q;
  while (contacts < most && w.c < w.a) {
    P.apply(w.a, w.c);
    on_event(++contacts, std::as_const(w));
    if (!(contacts < most && w.b < w.c)) break;
    Q.apply(w.b, w.c);
    on_event(++contacts, std::as_const(w));
  }
  v = w;
  return contacts;
}

/// The same without a listener.
template <Field Scalar>
std::int64_t step_trio(const Trio<Scalar>& trio, BodyVelocities<Scalar>& v, std::int64_t most) {
  return step_trio(trio, v, most, [](std::int64_t, const BodyVelocities<Scalar>&) {});
}

/// When and where the ball is, and how far from it the block that it meets next.
template <class Scalar>
struct TrioPlace {
  Scalar time;  ///< of the last contact
  Scalar ball;  ///< its place then
  Scalar gap;   ///< to the block that is next

  /// All three just after so many contacts, one or more.
  BodyPositions<Scalar> positions(std::int64_t contacts) const {
    if (contacts % 2 == 0) return {ball - gap, ball, ball};
    return {ball, ball + gap, ball};
  }
};

/// The same with times and places. At the start A meets the ball at place.ball and place.time, and B is place.gap ahead;
/// after n contacts `place` is that of the n-th. on_event(n, place, velocities after it).
template <Field Scalar, class OnEvent>
std::int64_t step_trio(const Trio<Scalar>& trio, BodyVelocities<Scalar>& v,
                       TrioPlace<Scalar>& place, std::int64_t most, OnEvent&& on_event) {
  std::int64_t contacts = 0;
  const auto fly = [&](const Scalar& closing, const Scalar& opening) {
    const Scalar step = place.gap / closing;
    place = {place.time + step, place.ball + v.c * step, opening * step};
  };
  while (contacts < most && v.c < v.a) {
    if (contacts > 0) fly(v.a - v.c, v.b - v.c);
    trio.P.apply(v.a, v.c);
    on_event(++contacts, std::as_const(place), std::as_const(v));
    if (!(contacts < most && v.b < v.c)) break;
    fly(v.c - v.b, v.c - v.a);
    trio.Q.apply(v.b, v.c);
    on_event(++contacts, std::as_const(place), std::as_const(v));
  }
  return contacts;
}

}  // namespace magicmass
