// SPDX-License-Identifier: GPL-2.0-or-later
#include "long_run/stages.hpp"

#include "magicmass/arithmetic/tracked.hpp"
#include "magicmass/kernels/angle.hpp"
#include "magicmass/kernels/encounters.hpp"
#include "magicmass/kernels/ratios.hpp"
#include "magicmass/kernels/terminal.hpp"
#include "magicmass/kernels/velocities.hpp"
#include "magicmass/tiers/first_stages.hpp"

namespace magicmass::long_run {
namespace {

template <class Result>
bool is_certain(const Result& x) {
  if constexpr (requires { as_array(x); }) {
    bool all = true;
    for (const auto& member : as_array(x)) all = all && certainly_rounded(member);
    return all;
  } else {
    return certainly_rounded(x);
  }
}

/// What the tier itself decides without certified arithmetic; whether the first stage was enough for that.
template <template <class> class Kernel, class... Inputs>
Stage stage(bool is_decided, Inputs... inputs) {
  if (!is_decided) return Stage::certified;
  return is_certain(Kernel<arithmetic::Tracked<double>>::evaluate(inputs...)) ? Stage::first
                                                                              : Stage::second;
}

}  // namespace

Stage velocities_stage(double alpha, std::int64_t n) {
  if (n == 0) return Stage::first;
  generated::Velocities<double> result;
  return stage<generated::VelocitiesKernel>(tiers::first_stages(alpha, n, result), alpha,
                                            static_cast<double>(n));
}
Stage encounters_stage(double alpha, std::int64_t j) {
  if (j <= 1) return Stage::first;
  generated::Encounters<double> result;
  return stage<generated::EncountersKernel>(tiers::first_stages(alpha, j, result), alpha,
                                            static_cast<double>(j));
}
Stage angle_stage(double alpha) {
  double psi;
  return stage<generated::AngleKernel>(tiers::first_stages(alpha, psi), alpha);
}
Stage ratios_stage(std::int64_t k) {
  generated::Ratios<double> result;
  return stage<generated::RatiosKernel>(tiers::first_stages(k, result), static_cast<double>(k));
}
Stage terminal_stage(double alpha, const Counts& counts) {
  generated::TerminalValues<double> result;
  return stage<generated::TerminalKernel>(tiers::first_stages(alpha, counts, result), alpha,
                                          static_cast<double>(counts.N_A),
                                          counts.N_B == counts.N_A ? 1.0 : -1.0);
}

}  // namespace magicmass::long_run
