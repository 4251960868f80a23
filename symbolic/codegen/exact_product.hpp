// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <stdexcept>

namespace magicmass::codegen {

// x y. Throws std::logic_error where that does not fit.
inline std::int64_t exact_product(std::int64_t x, std::int64_t y) {
  std::int64_t product = 0;
  if (__builtin_mul_overflow(x, y, &product))
    throw std::logic_error("a constant of a formula does not fit 64 bits");
  return product;
}

}  // namespace magicmass::codegen
