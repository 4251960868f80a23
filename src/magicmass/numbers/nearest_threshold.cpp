// SPDX-License-Identifier: MIT
#include <cmath>

#include "magicmass/numbers/counts.hpp"
#include "magicmass/numbers/ziv.hpp"

namespace magicmass {
namespace {
/// Where pi/h = m >= 3: alpha_k for m = 2k + 1, beta_k for m = 2k + 2.
Threshold threshold_at(double alpha, std::int64_t m) {
  const bool is_magic = m % 2 == 1;
  const std::int64_t k = (m - 1) / 2;
  if (m == 3) return {true, 1, alpha - 1.0};
  return {is_magic, k, numbers::distance_by_mpfr(alpha, is_magic, k)};
}
}  // namespace

std::optional<Threshold> nearest_threshold(double alpha) {
  const std::optional<Counts> counts = count_collisions(alpha);
  if (!counts) return std::nullopt;
  // N_A + N_B = ceil(pi/h) - 1: collision N takes place, the next does not.
  const std::int64_t N = counts->N_A + counts->N_B;
  if (N < 3) return threshold_at(alpha, 3);
  const Threshold above = threshold_at(alpha, N);
  if (N == INT64_MAX) return above;
  const Threshold below = threshold_at(alpha, N + 1);
  return std::fabs(above.distance) < std::fabs(below.distance) ? above : below;
}
}  // namespace magicmass
