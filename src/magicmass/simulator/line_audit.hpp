// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "magicmass/simulator/conservation_audit.hpp"
#include "magicmass/simulator/line_motion.hpp"

namespace magicmass {

/// Watches energy and momentum of a line as it runs: all bodies are summed up once in so many events as there are
/// bodies (at least 4096), and at the end, so it costs next to nothing an event. Momentum is measured in units of
/// sum m |v| at the start, and what walls took is accounted for. With e < 1 energy may only fall.
template <Field Scalar>
class LineAudit {
public:
  /// Takes note of the start.
  explicit LineAudit(const Line<Scalar>& start)
      : energy_(energy(start)),
        momentum_(momentum(start)),
        scale_(0),
        elastic_(start.restitution == Scalar(1)) {
    for (std::size_t i = 0; i < start.bodies(); ++i)
      scale_ = scale_ + size(start.masses[i] * start.velocities[i]);
    period_ = start.bodies() < 4096 ? 4096 : static_cast<std::int64_t>(start.bodies());
  }

  /// After each event of the motion.
  void look(const LineMotion<Scalar>& motion, const LineEvent<Scalar>& event) {
    if (event.gap == 0) add_impulse(motion.body(0), motion.restitution());
    if (event.gap == motion.bodies()) add_impulse(motion.body(event.gap - 1), motion.restitution());
    if (event.number % period_ == 0) look(motion.line());
  }

  /// At the end.
  void look(const Line<Scalar>& line) {
    keep_larger(drift_.momentum, momentum(line) - momentum_, scale_);
    const Scalar change = energy(line) - energy_;
    if (elastic_ || Scalar(0) < change) keep_larger(drift_.energy, change, energy_);
  }

  /// So far.
  const ConservationDrift<Scalar>& largest() const { return drift_; }

private:
  Scalar energy_, momentum_, scale_;
  bool elastic_;
  std::int64_t period_ = 0;
  ConservationDrift<Scalar> drift_{Scalar(0), Scalar(0)};

  static Scalar size(const Scalar& x) { return x < Scalar(0) ? Scalar(Scalar(0) - x) : x; }
  static Scalar energy(const Line<Scalar>& line) {
    Scalar sum(0);
    for (std::size_t i = 0; i < line.bodies(); ++i)
      sum = sum + line.masses[i] * line.velocities[i] * line.velocities[i];
    return sum;
  }
  static Scalar momentum(const Line<Scalar>& line) {
    Scalar sum(0);
    for (std::size_t i = 0; i < line.bodies(); ++i) sum = sum + line.masses[i] * line.velocities[i];
    return sum;
  }
  /// The body came with -v/e, where v is what it left the wall with.
  void add_impulse(const BodyState<Scalar>& body, const Scalar& e) {
    momentum_ = momentum_ + body.mass * (body.velocity + body.velocity / e);
  }
  static void keep_larger(Scalar& kept, const Scalar& change, const Scalar& unit) {
    if (!(Scalar(0) < unit)) return;  // nothing moved, nothing moves
    const Scalar drift = size(change) / unit;
    if (kept < drift) kept = drift;
  }
};

}  // namespace magicmass
