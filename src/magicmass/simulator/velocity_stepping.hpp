// SPDX-License-Identifier: MIT
// The paper's scene in velocities alone, contact by contact: what it takes and gives, around step_trio().
#pragma once

#include <cstdint>
#include <limits>

#include "magicmass/counts.hpp"
#include "magicmass/simulator/motion.hpp"
#include "magicmass/simulator/trio_stepping.hpp"
#include "magicmass/simulator/valid_input.hpp"

namespace magicmass {

/// One contact: the n-th of this block with the ball (P_n for A, Q_n for B) and the velocities just after it.
template <class Scalar>
struct VelocityEvent {
  Body body;                     ///< the block
  std::int64_t n;                ///< from 1 on
  BodyVelocities<Scalar> after;  ///< in the unit of V
};

/// Outcome of a run; terminal holds a_t, b_t, c_t if complete, else the velocities where it stopped.
template <class Scalar>
struct VelocityRun {
  RunStatus status = RunStatus::complete;  ///< whether all contacts were seen
  Counts counts;                           ///< of the contacts seen
  BodyVelocities<Scalar> terminal;         ///< in the unit of V
};

/// Steps through the contacts of A (speed V), C and B (both at rest). C is between A and B, so after a contact
/// on one side the next can only be on the other, and it happens just when those two approach.
/// alpha > 0 (unit 1), V > 0; calls on_event(const VelocityEvent<Scalar>&) after each contact; constant memory.
/// Exact for exact scalars; in floating point an error of a few eps a contact adds up, so a count close to a
/// threshold may be off by one. Runs at V = 1 and scales what it reports, so no V can change a count.
/// Throws InvalidInput where alpha or V is not positive and finite.
template <Field Scalar, class OnEvent>
VelocityRun<Scalar> step_velocities(const Scalar& alpha, const Scalar& V,
                                    std::int64_t max_collisions, OnEvent&& on_event) {
  require_positive_finite("alpha", alpha);
  require_positive_finite("V", V);
  BodyVelocities<Scalar> v{Scalar(1), Scalar(0), Scalar(0)};
  const std::int64_t contacts = step_trio(
      trio_of(alpha), v, max_collisions, [&](std::int64_t j, const BodyVelocities<Scalar>& after) {
        on_event(
            VelocityEvent<Scalar>{j % 2 == 0 ? Body::B : Body::A, (j + 1) / 2, scaled(after, V)});
      });
  return {approach(v, contacts) ? RunStatus::limited : RunStatus::complete, counts_of(contacts),
          scaled(v, V)};
}

/// The same without a listener.
template <Field Scalar>
VelocityRun<Scalar> step_velocities(
    const Scalar& alpha, const Scalar& V = Scalar(1),
    std::int64_t max_collisions = std::numeric_limits<std::int64_t>::max()) {
  return step_velocities(alpha, V, max_collisions, [](const VelocityEvent<Scalar>&) {});
}

}  // namespace magicmass
