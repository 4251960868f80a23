// SPDX-License-Identifier: MIT
#include "magicmass/evaluators/certified_angles.hpp"

#include <cstddef>
#include <string>

#include "magicmass/errors.hpp"
#include "magicmass/evaluators/angle_attempts.hpp"
#include "magicmass/simulator/valid_input.hpp"

namespace magicmass {
namespace {

void require_index(std::int64_t k) {
  if (k < 1) {
    throw InvalidInput("k must be 1 or more, got " + std::to_string(k));
  }
}

}  // namespace

double certified_angle(double alpha) {
  require_positive_finite("alpha", alpha);
  return certain("the rounding of psi",
                 [&]<std::size_t Words>() { return attempt_angle<Words>(alpha); });
}

double certified_magic(std::int64_t k) {
  require_index(k);
  return certain("the rounding of a magic ratio",
                 [&]<std::size_t Words>() { return attempt_magic<Words>(k); });
}

double certified_deficient(std::int64_t k) {
  require_index(k);
  return certain("the rounding of a deficient ratio",
                 [&]<std::size_t Words>() { return attempt_deficient<Words>(k); });
}

generated::Ratios<double> certified_ratios(std::int64_t k) {
  return {certified_magic(k), certified_deficient(k)};
}

}  // namespace magicmass
