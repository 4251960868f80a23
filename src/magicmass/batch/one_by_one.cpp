// SPDX-License-Identifier: MIT
#include "magicmass/batch/one_by_one.hpp"

#include <limits>
#include <optional>

#include "magicmass/accurate.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/tiers/single_kernels.hpp"

namespace magicmass::batch {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <class Evaluate>
generated::Velocities<double> velocities_or_none(Evaluate evaluate) {
  try {
    return evaluate();
  } catch (const InvalidInput&) {
    return {none, none, none, none};
  }
}

template <class Evaluate>
Terminal terminal_or_none(Evaluate evaluate) {
  try {
    if (const std::optional<Terminal> all = evaluate()) return *all;
  } catch (const InvalidInput&) {
  }
  return {{-1, -1}, none, none, none, none};
}

}  // namespace

generated::Velocities<double> fast_velocities(double alpha, std::int64_t n) {
  return velocities_or_none([&] { return fast::velocities(alpha, n); });
}
generated::Velocities<double> accurate_velocities(double alpha, std::int64_t n) {
  return velocities_or_none([&] { return accurate::velocities(alpha, n); });
}
Terminal fast_terminal(double alpha) {
  return terminal_or_none([&] { return fast::terminal(alpha); });
}
Terminal accurate_terminal(double alpha) {
  return terminal_or_none([&] { return accurate::terminal(alpha); });
}
Terminal open_terminal(double alpha, const Counts& counts) {
  generated::TerminalValues<double> result;
  if (tiers::single_kernels().terminal_in_second_stage(
          alpha, static_cast<double>(counts.N_A), counts.N_B == counts.N_A ? 1.0 : -1.0, result))
    return {counts, result.a_t, result.b_t, result.c_t, result.rho};
  return accurate_terminal(alpha);
}
// Where alpha is too large or too small for the lanes: two collisions, or a collapse unless e = 1.
double transmission(double alpha, double e) {
  if (e == 1.0) return fast_terminal(alpha).rho;
  if (!(alpha > 1.0) || alpha == std::numeric_limits<double>::infinity()) return none;
  return fast::terminal(alpha, e, {1, 1}).rho;
}
generated::Ratios<double> fast_ratios(std::int64_t k) {
  return k < 1 ? generated::Ratios<double>{none, none} : fast::ratios(k);
}
generated::Ratios<double> accurate_ratios(std::int64_t k) {
  return k < 1 ? generated::Ratios<double>{none, none} : accurate::ratios(k);
}

}  // namespace magicmass::batch
