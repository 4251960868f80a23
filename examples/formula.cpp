// SPDX-License-Identifier: MIT
// The paper's formula as it stands, for any real type, beside the correctly rounded value.
#include <cstdio>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/plain/closed.hpp"

int main() {
  const double alpha = 1e-9;
  const std::int64_t n = 30000;
  const auto typed = magicmass::generated::velocities_closed(alpha, n);
  const auto rounded = magicmass::accurate::velocities(alpha, n);
  std::printf("a_n = %.17g V\nformula: %.1e off\n", rounded.a, typed.a - rounded.a);
}
