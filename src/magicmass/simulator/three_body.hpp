// SPDX-License-Identifier: MIT
// The paper's scene with places and times: what it takes and gives, around step_trio().
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "magicmass/counts.hpp"
#include "magicmass/simulator/conservation_audit.hpp"
#include "magicmass/simulator/motion.hpp"
#include "magicmass/simulator/trio_stepping.hpp"
#include "magicmass/simulator/valid_input.hpp"

namespace magicmass {

/// One contact of a block with the ball: the n-th of that block (P_n for A, Q_n for B).
template <class Scalar>
struct Event {
  Body body;                        ///< the block
  std::int64_t n;                   ///< from 1 on
  Scalar time;                      ///< unit of L / V; P_1 is at 0
  Scalar position;                  ///< where the two met, unit of L
  BodyVelocities<Scalar> after;     ///< just after it, unit of V
  BodyPositions<Scalar> positions;  ///< of all three at that time
};

/// Outcome of a run; terminal holds a_t, b_t, c_t if complete, else the velocities where it stopped.
template <class Scalar>
struct ThreeBodyRun {
  RunStatus status = RunStatus::complete;  ///< whether all contacts were seen
  Counts counts;                           ///< of the contacts seen
  BodyVelocities<Scalar> terminal;         ///< in the unit of V
  BodyPositions<Scalar> last_positions;    ///< at last_time, the time of the last contact
  Scalar last_time;                        ///< 0 where there was none
  ConservationDrift<Scalar> drift;         ///< the largest seen
};

/// Simulates A (speed V, reaching C at time 0), the ball C at rest at 0 and B at rest at L, blocks of mass 1 and
/// ball of mass alpha (Ee & Lee Sec. II A). What the ball met last it cannot meet next (LineMotion, which looks for the
/// earliest contact, sees the same). Calls on_event(const Event<Scalar>&) after each contact; constant memory.
/// alpha, V, L > 0 and finite, else throws InvalidInput. Exact for exact scalars. In floating point errors of a
/// few eps a contact add up, so a count close to a threshold may be off by one. Runs at V = L = 1 and scales
/// what it reports, so no V or L can change a count; throws Undecided if 2 V, L/V, V/L or a contact's time
/// or place leave the number type.
template <Field Scalar, class OnEvent>
ThreeBodyRun<Scalar> simulate_three_body(const Scalar& alpha, const Scalar& V, const Scalar& L,
                                         std::int64_t max_events, OnEvent&& on_event) {
  require_positive_finite("alpha", alpha);
  require_positive_finite("V", V);
  require_positive_finite("L", L);
  require_scales_fit(V, L);
  const Scalar unit_time = L / V;
  BodyVelocities<Scalar> v{Scalar(1), Scalar(0), Scalar(0)};
  TrioPlace<Scalar> place{Scalar(0), Scalar(0), Scalar(1)};
  ConservationAudit<Scalar> audit(alpha, v);
  ThreeBodyRun<Scalar> run{};
  run.last_positions = {Scalar(0), L, Scalar(0)};
  run.last_time = Scalar(0);
  const std::int64_t contacts = step_trio(
      trio_of(alpha), v, place, max_events,
      [&](std::int64_t j, const TrioPlace<Scalar>& at, const BodyVelocities<Scalar>& after) {
        audit.look(after);
        run.last_time = at.time * unit_time;
        run.last_positions = scaled(at.positions(j), L);
        require_contact_fits(run.last_time, run.last_positions);
        on_event(Event<Scalar>{j % 2 == 0 ? Body::B : Body::A, (j + 1) / 2, run.last_time,
                               run.last_positions.c, scaled(after, V), run.last_positions});
      });
  run.status = approach(v, contacts) ? RunStatus::limited : RunStatus::complete;
  run.counts = counts_of(contacts);
  run.terminal = scaled(v, V);
  run.drift = audit.largest();
  return run;
}

/// A run together with all its events.
template <class Scalar>
struct RecordedRun {
  ThreeBodyRun<Scalar> run;           ///< how it ended
  std::vector<Event<Scalar>> events;  ///< all of them, in order
};

/// The same, keeping every event: memory grows with their number, so bound it by max_events.
template <Field Scalar>
RecordedRun<Scalar> record_three_body(
    const Scalar& alpha, const Scalar& V = Scalar(1), const Scalar& L = Scalar(1),
    std::int64_t max_events = std::numeric_limits<std::int64_t>::max()) {
  RecordedRun<Scalar> recorded{};
  recorded.run = simulate_three_body(alpha, V, L, max_events, [&](const Event<Scalar>& event) {
    recorded.events.push_back(event);
  });
  return recorded;
}

}  // namespace magicmass
