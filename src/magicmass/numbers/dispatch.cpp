// SPDX-License-Identifier: MIT
// Which of the compiled tables this processor can run.

#include <limits>

#include "magicmass/arithmetic/ieee.hpp"
#include "magicmass/arithmetic/simd.hpp"
#include "magicmass/numbers/errors.hpp"
#include "magicmass/numbers/ladder.hpp"

namespace magicmass::numbers {
namespace baseline {
extern const Kernels table;
}
#if defined(MAGICMASS_HAS_X86_TABLES)
namespace avx2 {
extern const Kernels table;
}
namespace avx512 {
extern const Kernels table;
}
#endif
namespace {
struct Target {
  const Kernels* table;
  bool (*runs)();
};
const Target targets[] = {
#if defined(MAGICMASS_HAS_X86_TABLES)
    {&avx512::table, [] { return arithmetic::runs_avx512(); }},
    {&avx2::table, [] { return arithmetic::runs_avx2(); }},
#endif
    {&baseline::table, [] { return true; }}};
}  // namespace
const Kernels* kernels_named(const char* name) {
  for (const Target& t : targets)
    if (std::strcmp(t.table->name, name) == 0 && t.runs()) return t.table;
  return nullptr;
}
void check_arithmetic() {
  if (arithmetic::arithmetic_is_ieee()) return;
  const volatile double smallest = std::numeric_limits<double>::min();
  throw NotIeee(smallest / 2 == 0 ? "this thread flushes subnormal numbers to zero"
                                  : "this thread does not round to nearest");
}
const Kernels& choose() {
  const Target* t = targets;
  while (!t->runs()) ++t;
  chosen.store(t->table, std::memory_order_relaxed);
  return *t->table;
}
}  // namespace magicmass::numbers
