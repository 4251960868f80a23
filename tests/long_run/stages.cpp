// SPDX-License-Identifier: GPL-2.0-or-later
#include "long_run/stages.hpp"

#include "magicmass/arithmetic/bounded.hpp"
#include "magicmass/arithmetic/tracked.hpp"
#include "magicmass/kernels/angle.hpp"
#include "magicmass/kernels/encounters.hpp"
#include "magicmass/kernels/ratios.hpp"
#include "magicmass/kernels/terminal.hpp"
#include "magicmass/kernels/velocities.hpp"

namespace magicmass::long_run {
namespace {

using arithmetic::Bounded;
using arithmetic::Tracked;

bool is_in_range(double alpha) { return alpha >= 0x1p-900 && alpha <= 0x1p400; }
constexpr std::int64_t most_index = std::int64_t{1} << 51U;

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

template <template <class> class Kernel, class... Inputs>
Stage stage(bool is_asked, Inputs... inputs) {
  if (!is_asked) return Stage::certified;
  if (is_certain(Kernel<Tracked<double>>::evaluate(inputs...))) return Stage::first;
  if (is_certain(Kernel<Bounded<double>>::evaluate(inputs...))) return Stage::second;
  return Stage::certified;
}

}  // namespace

Stage velocities_stage(double alpha, std::int64_t n) {
  if (n == 0) return Stage::first;
  return stage<generated::VelocitiesKernel>(
      is_in_range(alpha) && n <= (alpha >= 1.0 ? 1 : most_index), alpha, static_cast<double>(n));
}
Stage encounters_stage(double alpha, std::int64_t j) {
  if (j == 0 && is_in_range(alpha)) return Stage::first;
  return stage<generated::EncountersKernel>(
      is_in_range(alpha) && j >= 2 && j <= most_index && alpha < 1.0, alpha,
      static_cast<double>(j));
}
Stage angle_stage(double alpha) { return stage<generated::AngleKernel>(is_in_range(alpha), alpha); }
Stage ratios_stage(std::int64_t k) {
  return stage<generated::RatiosKernel>(k >= 2 && k <= most_index, static_cast<double>(k));
}
Stage terminal_stage(double alpha, const Counts& counts) {
  return stage<generated::TerminalKernel>(is_in_range(alpha) && counts.N_A <= most_index, alpha,
                                          static_cast<double>(counts.N_A),
                                          counts.N_B == counts.N_A ? 1.0 : -1.0);
}

}  // namespace magicmass::long_run
