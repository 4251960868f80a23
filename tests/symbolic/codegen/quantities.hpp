// SPDX-License-Identifier: GPL-2.0-or-later
// The physics' formulas as definitions of the tests: typed here, so that the generator is tested
// without the derivation.
#pragma once

#include "codegen/quantity.hpp"

namespace test {
/// velocities, terminal, ratios (magic, deficient), angle.
const std::vector<codegen::Quantity>& quantities();
}  // namespace test
