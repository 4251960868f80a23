// SPDX-License-Identifier: GPL-2.0-or-later
// A target that nothing passes, to see the replay fail.
#include "fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t) {
  magicmass::fuzz::require(false, "planted");
  return 0;
}
