// SPDX-License-Identifier: GPL-2.0-or-later
// What follows the last collision, from the oracle of velocities and the reference's counts: nothing of a tier in it.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/counts.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "report/exact_value.hpp"
#include "report/oracle.hpp"
#include "report/relative_motion.hpp"

namespace magicmass::testing {

struct ExactTerminal {
  Counts counts;
  report::ExactValue a_t, b_t, c_t, rho;
};

/// b_n^2, correctly rounded; n = N_B.
inline report::ExactValue exact_energy_fraction(double ratio, std::int64_t N_B) {
  const cln::cl_RA alpha = reference::exact(ratio);
  const cln::cl_I n(static_cast<long>(N_B));
  if (N_B == 1) {  // the only one that can be a tie
    const cln::cl_RA b = reference::exact_velocities(alpha, n).b;
    return report::exact_value(b * b);
  }
  for (long precision = 400 + 2 * std::labs(std::ilogb(ratio));; precision *= 2) {
    const auto b = report::enclosed_velocities(alpha, n, precision).b;
    const cln::cl_RA low = b.low() * b.low(), high = b.high() * b.high();
    if (reference::nearest<double>(low) == reference::nearest<double>(high) &&
        (high - low) * cln::cl_RA(cln::ash(cln::cl_I(1), 130)) < low)
      return report::exact_value(low);
  }
}

/// None where N_A + N_B is 2^63 or more.
inline std::optional<ExactTerminal> exact_terminal(report::Oracle& oracle, double alpha) {
  const auto large = reference::count_collisions(reference::exact(alpha));
  if (cln::integer_length(large.N_A + large.N_B) > 63) return std::nullopt;
  const Counts counts{cln::cl_I_to_long(large.N_A), cln::cl_I_to_long(large.N_B)};
  const auto at_A = oracle.at("velocities", {alpha, counts.N_A});
  const auto at_B = oracle.at("velocities", {alpha, counts.N_B});
  ExactTerminal exact{counts, at_A[0], at_B[1], counts.N_A == counts.N_B ? at_A[3] : at_A[2],
                      exact_energy_fraction(alpha, counts.N_B)};
  exact.rho.condition = 2 * exact.b_t.condition;
  return exact;
}

}  // namespace magicmass::testing
