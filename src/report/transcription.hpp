// SPDX-License-Identifier: GPL-2.0-or-later
// The paper's formulas typed by hand, as anybody would who needs the numbers: the known-bad canary, to show what the
// generated forms save one from. Nothing else may call this.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "magicmass/counts.hpp"
#include "magicmass/quantities.hpp"
#include "report/ending.hpp"

namespace magicmass::report::transcription {

/// Ee & Lee eq. def:psi. Angles are numbers of type Angle from here on; results are rounded to Real.
template <class Real, class Angle>
Angle psi(Real alpha) {
  const auto ratio = static_cast<Angle>(alpha);
  return 2 * std::atan(std::sqrt(ratio * (2 + ratio)));
}

/// Ee & Lee eqs. eq:a-final to eq:c'-final, with V_CM = V/(2 + alpha).
template <class Real, class Angle = Real>
generated::Velocities<Real> velocities(Real alpha, std::int64_t n) {
  const Real V_CM = 1 / (2 + alpha);
  const Angle turn = psi<Real, Angle>(alpha);
  const auto n_ = static_cast<Angle>(n);
  const auto cosine = [](Angle x) { return static_cast<Real>(std::cos(x)); };
  const auto sine = [](Angle x) { return static_cast<Real>(std::sin(x)); };
  return {V_CM * (1 + cosine(n_ * turn) / cosine(turn / 2)),
          V_CM * (1 - cosine((n_ + Angle(0.5)) * turn) / cosine(turn / 2)),
          V_CM * (1 + sine((n_ - Angle(0.25)) * turn) / sine(turn / 4)),
          V_CM * (1 - sine((n_ + Angle(0.25)) * turn) / sine(turn / 4))};
}

/// One velocity a call, each with an angle of its own: what a program does that wants them one by one. Not inlined, lest
/// the compiler share what they have in common.
template <class Real>
[[gnu::noinline]] Real a_alone(Real alpha, std::int64_t n) {
  const Real turn = psi<Real, Real>(alpha);
  return 1 / (2 + alpha) * (1 + std::cos(static_cast<Real>(n) * turn) / std::cos(turn / 2));
}
template <class Real>
[[gnu::noinline]] Real b_alone(Real alpha, std::int64_t n) {
  const Real turn = psi<Real, Real>(alpha);
  return 1 / (2 + alpha) *
         (1 - std::cos((static_cast<Real>(n) + Real(0.5)) * turn) / std::cos(turn / 2));
}
template <class Real>
[[gnu::noinline]] Real c_alone(Real alpha, std::int64_t n) {
  const Real turn = psi<Real, Real>(alpha);
  return 1 / (2 + alpha) *
         (1 + std::sin((static_cast<Real>(n) - Real(0.25)) * turn) / std::sin(turn / 4));
}
template <class Real>
[[gnu::noinline]] Real c_prime_alone(Real alpha, std::int64_t n) {
  const Real turn = psi<Real, Real>(alpha);
  return 1 / (2 + alpha) *
         (1 - std::sin((static_cast<Real>(n) + Real(0.25)) * turn) / std::sin(turn / 4));
}

/// t_j = (L/V) sin(j psi/2)/sin((j+1) psi/2) and s_j = L sin(psi/2)/sin((j+1) psi/2): not in the paper, which stops at
/// velocities, but with its psi.
template <class Real, class Angle = Real>
generated::Encounters<Real> encounters(Real alpha, std::int64_t j) {
  const Angle half_turn = psi<Real, Angle>(alpha) / 2;
  const auto j_ = static_cast<Angle>(j);
  const auto sine = [](Angle x) { return static_cast<Real>(std::sin(x)); };
  const Real below = sine((j_ + 1) * half_turn);
  return {sine(j_ * half_turn) / below, sine(half_turn) / below};
}

/// Ee & Lee eqs. exact:ak and exact:bk.
template <class Real, class Angle = Real>
generated::Ratios<Real> ratios(std::int64_t k) {
  const auto k_ = static_cast<Angle>(k);
  constexpr Angle pi = std::numbers::pi_v<Angle>;
  const auto secant = [](Angle x) { return 1 / static_cast<Real>(std::cos(x)); };
  return {-1 + secant(pi / (2 * k_ + 1)), -1 + secant(pi / (2 * (k_ + 1)))};
}

/// Ee & Lee eqs. eq:NA-ans and N_B beside it.
template <class Real, class Angle = Real>
Counts counts(Real alpha) {
  const Angle cycles = std::numbers::pi_v<Angle> / psi<Real, Angle>(alpha);
  return {static_cast<std::int64_t>(std::ceil(cycles - Angle(0.5))),
          static_cast<std::int64_t>(std::ceil(cycles - 1))};
}

/// Ee & Lee eqs. eq:a-terminal, eq:b-terminal and eq:ct, with these counts.
template <class Real, class Angle = Real>
Ending<Real> ending(Real alpha) {
  const Angle turn = psi<Real, Angle>(alpha);
  const Angle cycles = std::numbers::pi_v<Angle> / turn;
  const Counts N{static_cast<std::int64_t>(std::ceil(cycles - Angle(0.5))),
                 static_cast<std::int64_t>(std::ceil(cycles - 1))};
  const Real V_CM = 1 / (2 + alpha);
  const auto cosine = [](Angle x) { return static_cast<Real>(std::cos(x)); };
  const Real a_t = V_CM * (1 + (1 + alpha) * cosine(static_cast<Angle>(N.N_A) * turn));
  const Real b_t =
      V_CM * (1 - (1 + alpha) * cosine((static_cast<Angle>(N.N_B) + Angle(0.5)) * turn));
  return {a_t, b_t, (1 - a_t - b_t) / alpha, N};
}

}  // namespace magicmass::report::transcription
