// SPDX-License-Identifier: MIT
#include "magicmass/accurate.hpp"

#include <cmath>

#include "magicmass/counts.hpp"
#include "magicmass/evaluators/certified_angles.hpp"
#include "magicmass/evaluators/certified_encounters.hpp"
#include "magicmass/evaluators/certified_velocities.hpp"
#include "magicmass/tiers/first_encounter.hpp"
#include "magicmass/tiers/first_stages.hpp"
#include "magicmass/tiers/single_kernels.hpp"

namespace magicmass {
namespace {

/// No product of a kernel is below 2^-960 or beyond 2^960 for these; false for NaN.
bool is_in_range(double alpha) { return alpha >= 0x1p-900 && alpha <= 0x1p400; }

/// Twice it is a double, exactly.
constexpr std::int64_t most_index = std::int64_t{1} << 51U;

}  // namespace

namespace tiers {

bool first_stages(double alpha, std::int64_t n, generated::Velocities<double>& result) {
  if (!is_in_range(alpha) || n < 0 || n > (alpha >= 1.0 ? 1 : most_index)) [[unlikely]]
    return false;
  if (n == 0) {
    result = {1.0, 0.0, 0.0, 0.0};
    return true;
  }
  return single_kernels().velocities(alpha, static_cast<double>(n), result);
}

bool first_stages(double alpha, std::int64_t j, generated::Encounters<double>& result) {
  if (!(alpha > 0.0 && std::isfinite(alpha)) || j < 0) return false;
  if (j == 0) {
    result = {0.0, 1.0};
    return true;
  }
  if (j == 1) {
    result = first_encounter(alpha);
    return true;
  }
  return is_in_range(alpha) && j <= most_index && alpha < 1.0 &&
         single_kernels().encounters(alpha, static_cast<double>(j), result) && result.s > 0.0;
}

bool first_stages(double alpha, const Counts& counts, generated::TerminalValues<double>& result) {
  return is_in_range(alpha) && counts.N_A <= most_index &&
         single_kernels().terminal(alpha, static_cast<double>(counts.N_A),
                                   counts.N_B == counts.N_A ? 1.0 : -1.0, result);
}

bool first_stages(double alpha, double& psi) {
  return is_in_range(alpha) && single_kernels().angle(alpha, psi);
}

bool first_stages(std::int64_t k, generated::Ratios<double>& result) {
  return k >= 1 && k <= most_index && single_kernels().ratios(static_cast<double>(k), result);
}

}  // namespace tiers

namespace accurate {

generated::Velocities<double> velocities(double alpha, std::int64_t n) {
  generated::Velocities<double> result;
  if (!tiers::first_stages(alpha, n, result)) [[unlikely]]
    result = certified_velocities(alpha, n);
  return result;
}

generated::Encounters<double> encounters(double alpha, std::int64_t j) {
  generated::Encounters<double> result;
  if (!tiers::first_stages(alpha, j, result)) [[unlikely]]
    result = certified_encounters(alpha, j);
  return result;
}

std::optional<Terminal> terminal(double alpha) {
  const std::optional<Counts> counts = count_collisions(alpha);
  if (!counts) return std::nullopt;
  generated::TerminalValues<double> result;
  if (tiers::first_stages(alpha, *counts, result)) [[likely]]
    return Terminal{*counts, result.a_t, result.b_t, result.c_t, result.rho};
  return Terminal{*counts, certified_velocity(Velocity::a, alpha, counts->N_A),
                  certified_velocity(Velocity::b, alpha, counts->N_B),
                  counts->N_B == counts->N_A
                      ? certified_velocity(Velocity::c_prime, alpha, counts->N_B)
                      : certified_velocity(Velocity::c, alpha, counts->N_A),
                  certified_energy_fraction(alpha)};
}

double angle(double alpha) {
  double psi;
  if (!tiers::first_stages(alpha, psi)) [[unlikely]]
    psi = certified_angle(alpha);
  return psi;
}

generated::Ratios<double> ratios(std::int64_t k) {
  generated::Ratios<double> result;
  if (!tiers::first_stages(k, result)) [[unlikely]]
    result = certified_ratios(k);
  return result;
}

}  // namespace accurate
}  // namespace magicmass
