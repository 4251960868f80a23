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

/// A contact as a linear map of the two velocities, computed once: (block, ball) -> (block, ball).
template <class Scalar>
struct ContactWeights {
  Scalar block_by_block, block_by_ball, ball_by_block, ball_by_ball;

  void apply(Scalar& block, Scalar& ball) const {
    const Scalar before = block;
    block = block_by_block * before + block_by_ball * ball;
    ball = ball_by_block * before + ball_by_ball * ball;
  }
};

/// From the collision law at unit velocities. Each weight is within 8 eps, so each velocity within 24 eps of the larger
/// of the two speeds.
template <Arithmetic Scalar>
ContactWeights<Scalar> contact_weights(const Scalar& block, const Scalar& ball, const Scalar& e) {
  const AfterContact<Scalar> by_block = collide(block, Scalar(1), ball, Scalar(0), e);
  const AfterContact<Scalar> by_ball = collide(block, Scalar(0), ball, Scalar(1), e);
  return {by_block.first, by_ball.first, by_block.second, by_ball.second};
}

/// The block is a wall, which keeps its velocity: the ball's, relative to it, is turned round.
template <Arithmetic Scalar>
ContactWeights<Scalar> wall_weights(const Scalar& e) {
  const Scalar turned = rebound(Scalar(1), e);
  return {Scalar(1), Scalar(0), Scalar(1) - turned, turned};
}

/// The contacts of A with the ball, and of the ball with B.
template <class Scalar>
struct Trio {
  ContactWeights<Scalar> P;
  ContactWeights<Scalar> Q;
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
Velocities<Scalar> trio_velocities(const Line<Scalar>& line) {
  return {line.velocities[0], line.right_wall ? Scalar(0) : line.velocities[2], line.velocities[1]};
}

/// The contacts of A among so many, A first; the others are B's.
constexpr Counts counts_of(std::int64_t contacts) {
  return {contacts - contacts / 2, contacts / 2};
}

/// After so many contacts, do the next two approach?
template <Field Scalar>
bool approach(const Velocities<Scalar>& v, std::int64_t contacts) {
  return contacts % 2 == 0 ? v.c < v.a : v.b < v.c;
}

/// Steps velocities alone, A first, until the next pair does not approach or after `most` contacts; returns how many
/// there were. v is changed in place. Two multiplications and an addition from one contact to the next.
/// on_event(n, velocities after it), n = 1, 2, ...
template <Field Scalar, class OnEvent>
std::int64_t step_trio(const Trio<Scalar>& trio, Velocities<Scalar>& v, std::int64_t most,
                       OnEvent&& on_event) {
  std::int64_t contacts = 0;
  Velocities<Scalar> w = v;
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

template <Field Scalar>
std::int64_t step_trio(const Trio<Scalar>& trio, Velocities<Scalar>& v, std::int64_t most) {
  return step_trio(trio, v, most, [](std::int64_t, const Velocities<Scalar>&) {});
}

/// When and where the ball is, and how far from it the block that it meets next.
template <class Scalar>
struct TrioPlace {
  Scalar time;
  Scalar ball;
  Scalar gap;

  /// All three just after so many contacts, one or more.
  Positions<Scalar> positions(std::int64_t contacts) const {
    if (contacts % 2 == 0) return {ball - gap, ball, ball};
    return {ball, ball + gap, ball};
  }
};

/// The same with times and places. At the start A meets the ball at place.ball and place.time, and B is place.gap ahead;
/// after n contacts `place` is that of the n-th. on_event(n, place, velocities after it).
template <Field Scalar, class OnEvent>
std::int64_t step_trio(const Trio<Scalar>& trio, Velocities<Scalar>& v, TrioPlace<Scalar>& place,
                       std::int64_t most, OnEvent&& on_event) {
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
