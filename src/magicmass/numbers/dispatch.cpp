// SPDX-License-Identifier: MIT
// Which of the compiled tables this processor can run.

#include "magicmass/arithmetic/simd.hpp"
#include "magicmass/numbers/kernels.hpp"

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
  for (const Target& t : targets) {
    if (std::strcmp(t.table->name, name) == 0 && t.runs()) return t.table;
  }
  return nullptr;
}
const Kernels& kernels() {
  static const Kernels& chosen = []() -> const Kernels& {
    const Target* t = targets;
    while (!t->runs()) ++t;
    return *t->table;
  }();
  return chosen;
}
}  // namespace magicmass::numbers
