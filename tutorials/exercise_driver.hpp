// SPDX-License-Identifier: GPL-2.0-or-later
// What the driver of a code exercise needs: cases come from stdin, and what the student's function gives goes to
// descriptor 3, so that what it prints is no result. With MAGICMASS_PRINT results are printed, for a quiz server.
#pragma once

#include <cstdio>

namespace exercise {

class Case {
public:
  /// The next input of this case.
  double number() {
    double value = 0;
    if (std::scanf("%la", &value) != 1) value = 0;
    return value;
  }
  long whole() { return static_cast<long>(number()); }

  /// The next result, in the order of the outputs.
  void give(double result) {
#ifdef MAGICMASS_PRINT
    const bool is_rounding = result < 1e-12 && result > -1e-12;
    std::printf("%.9g ", is_rounding ? 0.0 : result);
#else
    std::fprintf(results(), "%a ", result);
#endif
  }

  void finish() {
#ifdef MAGICMASS_PRINT
    std::printf("\n");
#else
    std::fprintf(results(), "\n");
    std::fflush(results());
#endif
  }

private:
  static std::FILE* results() {
    static std::FILE* stream = fdopen(3, "w");
    return stream;
  }
};

/// Calls `play` with each case.
template <class Play>
int run_cases(const Play& play) {
  Case one;
  const long count = one.whole();
  for (long i = 0; i < count; ++i) {
    play(one);
    one.finish();
  }
  return 0;
}

}  // namespace exercise
