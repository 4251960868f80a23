// SPDX-License-Identifier: MIT
// The README's ten lines: how a story ends.
#include <cstdio>

#include "magicmass/numbers/accurate.hpp"

int main() {
  const double alpha = 0.12;  // ball mass / block mass
  const auto end = magicmass::accurate::terminal(alpha).value();
  std::printf("%d + %d collisions, B leaves with %.6f V\n", int(end.counts.N_A),
              int(end.counts.N_B), end.b_t);
}
