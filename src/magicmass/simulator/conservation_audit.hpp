// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/simulator/field.hpp"
#include "magicmass/simulator/motion.hpp"

namespace magicmass {

/// Largest relative departure from the initial kinetic energy and momentum; exactly 0 for exact scalars.
template <class Scalar>
struct ConservationDrift {
  Scalar energy;    ///< relative, at least 0
  Scalar momentum;  ///< relative, at least 0
};

/// Watches energy and momentum of two blocks of mass 1 and a ball of mass alpha. The start must have both
/// positive. Its own rounding is at most 6 eps relative in floating point.
template <Field Scalar>
class ConservationAudit {
public:
  /// Takes note of the start.
  ConservationAudit(const Scalar& alpha, const BodyVelocities<Scalar>& start)
      : alpha_(alpha),
        energy_(energy(start)),
        momentum_(momentum(start)),
        largest_{Scalar(0), Scalar(0)} {}

  /// Takes note of the velocities at a later time.
  void look(const BodyVelocities<Scalar>& v) {
    keep_larger(largest_.energy, (energy(v) - energy_) / energy_);
    keep_larger(largest_.momentum, (momentum(v) - momentum_) / momentum_);
  }

  /// So far.
  const ConservationDrift<Scalar>& largest() const { return largest_; }

private:
  Scalar alpha_;
  Scalar energy_;
  Scalar momentum_;
  ConservationDrift<Scalar> largest_;

  /// Twice the kinetic energy. (alpha c) c, not alpha (c c): c c underflows where alpha is huge.
  Scalar energy(const BodyVelocities<Scalar>& v) const {
    return v.a * v.a + v.b * v.b + (alpha_ * v.c) * v.c;
  }
  Scalar momentum(const BodyVelocities<Scalar>& v) const { return v.a + v.b + alpha_ * v.c; }

  static void keep_larger(Scalar& kept, const Scalar& drift) {
    const Scalar size = drift < Scalar(0) ? Scalar(Scalar(0) - drift) : drift;
    if (kept < size) {
      kept = size;
    }
  }
};

}  // namespace magicmass
