// SPDX-License-Identifier: GPL-2.0-or-later
// Magic mass ratios: what is proved about them, and how much is lost when the mass is only nearly
// right.
#include <cstdio>

#include "derivation/book.hpp"
#include "kernel/print.hpp"
#include "magicmass/numbers/accurate.hpp"

int main() {
  for (const char* id : {"magic.counts", "magic.velocities", "deficient.counts",
                         "deficient.velocities", "ratios.order", "ratios.order_next"})
    std::printf("%s\n", kernel::text(derivation::the_book()[id].conclusion()).c_str());
  std::printf("k | alpha_k | beta_k | b_t beside alpha_k | b_t beside beta_k\n");
  for (int k = 1; k <= 8; ++k) {
    const auto ratios = magicmass::accurate::ratios(k);
    std::printf("%d | %.6f | %.6f | %.6f | %.6f\n", k, ratios.magic, ratios.deficient,
                magicmass::accurate::terminal(ratios.magic)->b_t,
                magicmass::accurate::terminal(ratios.deficient)->b_t);
  }
  const double alpha_3 = magicmass::accurate::ratios(3).magic;
  std::printf("ball too heavy by | energy that B does not get | N_A | N_B\n");
  for (const double miss : {-0.1, -0.01, -0.001, 0.001, 0.01, 0.1}) {
    const auto end = magicmass::accurate::terminal(alpha_3 * (1 + miss)).value();
    std::printf("%g | %.2g | %lld | %lld\n", miss, 1 - end.rho,
                static_cast<long long>(end.counts.N_A), static_cast<long long>(end.counts.N_B));
  }
}
