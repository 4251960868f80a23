// SPDX-License-Identifier: MIT
// One attempt at a correctly rounded angle or ratio, in so many words; certified_angles.hpp is what to call.
//
// More words settle every rounding at last, as none of these is rational but alpha_1 = 1, which is a double: near one any
// small bound will do. cos(psi/2) = 1/(1+alpha) is rational and psi is not 0, so psi is transcendental (Lindemann).
// alpha_k and beta_k are 1/cos(r pi) - 1 with r = 1/(2k+1) and 1/(2(k+1)); a rational cos(r pi) is 0, +-1/2 or
// +-1 (Niven), which leaves r = 1/3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "magicmass/angle_product.hpp"
#include "magicmass/evaluators/multiword_functions.hpp"
#include "magicmass/evaluators/multiword_pi.hpp"
#include "magicmass/evaluators/ziv.hpp"
#include "magicmass/ratios_product.hpp"

namespace magicmass {

template <std::size_t Words>
std::optional<double> attempt_angle(double alpha) {
  return rounded(generated::angle_product(NearInteger<Words>(alpha)));
}

template <std::size_t Words>
std::optional<double> attempt_magic(std::int64_t k) {
  return rounded(generated::magic_product<NearInteger<Words>>(k));
}

template <std::size_t Words>
std::optional<double> attempt_deficient(std::int64_t k) {
  return rounded(generated::deficient_product<NearInteger<Words>>(k));
}

}  // namespace magicmass
