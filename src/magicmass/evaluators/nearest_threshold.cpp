// SPDX-License-Identifier: MIT
#include "magicmass/nearest_threshold.hpp"

#include <cmath>
#include <cstddef>

#include "magicmass/counts.hpp"
#include "magicmass/evaluators/multiword_functions.hpp"
#include "magicmass/evaluators/multiword_pi.hpp"
#include "magicmass/evaluators/ziv.hpp"
#include "magicmass/ratios_product.hpp"

namespace magicmass {
namespace {

/// To the threshold where collision m >= 4 is lost, m h = pi: alpha_k with m = 2k+1, beta_k with m = 2(k+1). It is
/// irrational, so more words settle the rounding at last.
NearestThreshold from_threshold(double alpha, std::int64_t m) {
  NearestThreshold result{m % 2 == 1, m % 2 == 1 ? m / 2 : m / 2 - 1, 0.0};
  result.distance = certain("the distance to a threshold", [&]<std::size_t Words>() {
    using Number = NearInteger<Words>;
    const Number threshold = result.is_magic ? generated::magic_product<Number>(result.k)
                                             : generated::deficient_product<Number>(result.k);
    return rounded((Number(alpha) - threshold) / threshold);
  });
  return result;
}

}  // namespace

std::optional<NearestThreshold> nearest_threshold(double alpha) {
  const std::optional<Counts> counts = count_collisions(alpha);
  if (!counts) {
    return std::nullopt;
  }
  const NearestThreshold to_one{true, 1, alpha - 1.0};  // alpha_1 = 1, where the third is lost
  const std::int64_t total = counts->N_A + counts->N_B;
  if (total < 3) {
    return to_one;
  }
  // collision `total` takes place and the next does not: alpha is between the thresholds where these are lost
  const NearestThreshold above = total == 3 ? to_one : from_threshold(alpha, total);
  const NearestThreshold below = from_threshold(alpha, total + 1);
  return std::fabs(above.distance) < std::fabs(below.distance) ? above : below;
}

}  // namespace magicmass
