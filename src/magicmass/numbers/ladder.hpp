// SPDX-License-Identifier: MIT
// Single numbers, one number type after the other: the tier's own, Slow, MPFR's. nullopt: the
// inputs have no answer. Throw Undecided.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "magicmass/numbers/kernels.hpp"

namespace magicmass::numbers {
inline std::atomic<const Kernels*> chosen{};
const Kernels& choose();
/// The best table that this processor can run. In debug builds: after check_arithmetic().
inline const Kernels& kernels() {
#ifndef NDEBUG
  check_arithmetic();  // of single numbers, too: each takes its kernel here
#endif
  const Kernels* table = chosen.load(std::memory_order_relaxed);
  return table ? *table : choose();
}
/// The shortest text that is read as x.
std::string text_of(double x);
inline bool is_mass_ratio(double alpha) { return alpha > 0.0 && alpha <= 0x1.fffffffffffffp1023; }
std::optional<Velocities> velocities(Tier tier, double alpha, std::int64_t n);
std::optional<Terminal> terminal(Tier tier, double alpha);
}  // namespace magicmass::numbers
