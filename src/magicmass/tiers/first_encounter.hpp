// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/kernels/first_encounter.hpp"
#include "magicmass/quantities.hpp"

namespace magicmass::tiers {

/// Collision j = 1, Q_1, for alpha > 0: the nearest doubles, also where (1 + alpha)/2 is one or halfway between two. A pair holds
/// 1 + alpha, and its half is rounded once (below 2^-1021 of 1, what is lost of the low part is no part of a tie).
inline generated::Encounters<double> first_encounter(double alpha) {
  const auto exact = generated::FirstEncounterKernel<arithmetic::Pair<double>>::evaluate(alpha);
  return {rounded(exact.t), rounded(exact.s)};
}

}  // namespace magicmass::tiers
