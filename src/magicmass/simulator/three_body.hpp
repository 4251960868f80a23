// SPDX-License-Identifier: MIT
// Event-driven simulation with places and times: each step looks for the earliest contact and moves there.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "magicmass/counts.hpp"
#include "magicmass/simulator/conservation_audit.hpp"
#include "magicmass/simulator/contact.hpp"
#include "magicmass/simulator/motion.hpp"
#include "magicmass/simulator/valid_input.hpp"

namespace magicmass {

/// One contact of a block with the ball: the n-th of that block (P_n for A, Q_n for B).
template <class Scalar>
struct Event {
  Body body;
  std::int64_t n;
  Scalar time;                  ///< unit of L / V; P_1 is at 0
  Scalar position;              ///< where the two met, unit of L
  Velocities<Scalar> after;     ///< just after it, unit of V
  Positions<Scalar> positions;  ///< of all three at that time
};

/// Outcome of a run; terminal holds a_t, b_t, c_t if complete, else the velocities where it stopped.
template <class Scalar>
struct ThreeBodyRun {
  RunStatus status = RunStatus::complete;
  Counts counts;
  Velocities<Scalar> terminal;
  Positions<Scalar> last_positions;  ///< at last_time, the time of the last contact
  Scalar last_time;
  ConservationDrift<Scalar> drift;
};

/// Time until two bodies meet, or nothing if they do not approach. gap >= 0 is the distance between them, closing
/// the speed at which it shrinks. A gap that rounding made negative is a contact now.
template <Field Scalar>
std::optional<Scalar> time_to_contact(const Scalar& gap, const Scalar& closing) {
  if (!(Scalar(0) < closing)) {
    return std::nullopt;
  }
  return gap < Scalar(0) ? Scalar(0) : Scalar(gap / closing);
}

/// Simulates A (speed V, reaching C at time 0), the ball C at rest at 0 and B at rest at L, blocks of mass 1 and
/// ball of mass alpha (Ee & Lee Sec. II A). Which pair meets next is decided by the times to contact alone; if
/// both were equal A would go first. Calls on_event(const Event<Scalar>&) after each contact; constant memory.
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
  const Scalar block(1);
  Velocities<Scalar> v{Scalar(1), Scalar(0), Scalar(0)};
  Positions<Scalar> x{Scalar(0), Scalar(1), Scalar(0)};
  Scalar time(0);
  ConservationAudit<Scalar> audit(alpha, v);
  ThreeBodyRun<Scalar> run{};
  for (;;) {
    const std::optional<Scalar> until_A = time_to_contact<Scalar>(x.c - x.a, v.a - v.c);
    const std::optional<Scalar> until_B = time_to_contact<Scalar>(x.b - x.c, v.c - v.b);
    if (!until_A && !until_B) {
      break;
    }
    if (run.counts.N_A + run.counts.N_B >= max_events) {
      run.status = RunStatus::limited;
      break;
    }
    const bool with_A = until_A && (!until_B || !(*until_B < *until_A));
    const Scalar step = with_A ? *until_A : *until_B;
    time = time + step;
    x = {x.a + v.a * step, x.b + v.b * step, x.c + v.c * step};
    Scalar& met = with_A ? v.a : v.b;
    const Scalar place = with_A ? x.a : x.b;
    x.c = place;
    const AfterContact<Scalar> after = collide(block, met, alpha, v.c);
    met = after.first;
    v.c = after.second;
    audit.look(v);
    const std::int64_t n = with_A ? ++run.counts.N_A : ++run.counts.N_B;
    const Event<Scalar> event{
        with_A ? Body::A : Body::B, n, time * unit_time, place * L, scaled(v, V), scaled(x, L)};
    require_contact_fits(event.time, event.positions);
    on_event(event);
  }
  run.terminal = scaled(v, V);
  run.last_positions = scaled(x, L);
  run.last_time = time * unit_time;
  run.drift = audit.largest();
  return run;
}

/// A run together with all its events.
template <class Scalar>
struct RecordedRun {
  ThreeBodyRun<Scalar> run;
  std::vector<Event<Scalar>> events;
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
