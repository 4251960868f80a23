// The paper's formulas typed by hand, as anybody would who needs the numbers, V = 1: the baseline
// of ratios; known to be bad near thresholds. Nobody else may call this.
#pragma once

#include <cmath>
#include <numbers>

#include "magicmass/numbers/values.hpp"

namespace report::naive {

/// Ee & Lee eq. def:psi.
inline double psi(double alpha) { return 2 * std::atan(std::sqrt(alpha * (2 + alpha))); }

/// Ee & Lee eqs. eq:a-final to eq:c'-final, with V_CM = V/(2 + alpha); shares its trigonometry.
inline magicmass::Velocities velocities(double alpha, std::int64_t n) {
  const double V_CM = 1 / (2 + alpha), turn = psi(alpha), k = double(n);
  const double cosine = std::cos(turn / 2), sine = std::sin(turn / 4);
  return {V_CM * (1 + std::cos(k * turn) / cosine),
          V_CM * (1 - std::cos((k + 0.5) * turn) / cosine),
          V_CM * (1 + std::sin((k - 0.25) * turn) / sine),
          V_CM * (1 - std::sin((k + 0.25) * turn) / sine)};
}

/// A straight line across mirror images of one wedge meets the j-th of them.
inline magicmass::Collision collision(double alpha, std::int64_t j) {
  const double h = psi(alpha) / 2, sine = std::sin((double(j) + 1) * h);
  return {std::sin(double(j) * h) / sine, std::sin(h) / sine};
}

/// Ee & Lee eqs. eq:NA-ans and eq:NB-ans.
inline magicmass::Counts counts_of(double turn) {
  const double cycles = std::numbers::pi / turn;
  return {std::int64_t(std::ceil(cycles - 0.5)), std::int64_t(std::ceil(cycles - 1))};
}
inline magicmass::Counts counts(double alpha) { return counts_of(psi(alpha)); }

/// Ee & Lee eqs. eq:a-terminal, eq:b-terminal and eq:ct, with these counts.
inline magicmass::Terminal terminal(double alpha) {
  const double turn = psi(alpha);
  const magicmass::Counts N = counts_of(turn);
  const double V_CM = 1 / (2 + alpha);
  const double a_t = V_CM * (1 + (1 + alpha) * std::cos(double(N.N_A) * turn));
  const double b_t = V_CM * (1 - (1 + alpha) * std::cos((double(N.N_B) + 0.5) * turn));
  return {N, a_t, b_t, (1 - a_t - b_t) / alpha, b_t * b_t};
}

/// Ee & Lee eqs. exact:ak and exact:bk.
inline magicmass::Ratios ratios(std::int64_t k) {
  const auto secant = [](double x) { return 1 / std::cos(x); };
  return {secant(std::numbers::pi / (2 * double(k) + 1)) - 1,
          secant(std::numbers::pi / (2 * double(k) + 2)) - 1};
}

}  // namespace report::naive
