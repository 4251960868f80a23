// SPDX-License-Identifier: GPL-2.0-or-later
// All targets, and registers and single numbers, give the same bits.
#include <cstdint>

#include "catch.hpp"

namespace magicmass::arithmetic::baseline {
std::uint64_t fingerprint();
}
namespace magicmass::arithmetic::avx2 {
std::uint64_t fingerprint();
}
namespace magicmass::arithmetic::avx512 {
std::uint64_t fingerprint();
}

TEST_CASE("all targets give the same bits as one number at a time") {
  // As g++ 12 and clang 14 give it on x86-64 and aarch64.
  constexpr std::uint64_t expected = 0x665e1359115baf91;
  REQUIRE(magicmass::arithmetic::baseline::fingerprint() == expected);
#ifdef MAGICMASS_TEST_X86
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    CHECK(magicmass::arithmetic::avx2::fingerprint() == expected);
  if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
    CHECK(magicmass::arithmetic::avx512::fingerprint() == expected);
#endif
}
