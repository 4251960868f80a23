// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/processor_clock.hpp"

namespace magicmass::report {

std::optional<Timed> dependent_additions() {
#if defined(__x86_64__) || defined(__aarch64__)
  constexpr int additions = 16;
  constexpr int turns = 64;
  // Of two registers: processors that add constants while renaming take no time for those.
  return Timed{on_steady_clock([] {
                 unsigned long sum = 1;
                 unsigned long term = 3;
                 asm volatile("" : "+r"(term));
                 for (int i = 0; i < turns; ++i)
#if defined(__x86_64__)
                   asm volatile(".rept 16\n\tadd %1, %0\n\t.endr" : "+r"(sum) : "r"(term) : "cc");
#else
                   asm volatile(".rept 16\n\tadd %0, %0, %1\n\t.endr" : "+r"(sum) : "r"(term));
#endif
               }),
               double{additions} * turns};
#else
  return std::nullopt;
#endif
}

}  // namespace magicmass::report
