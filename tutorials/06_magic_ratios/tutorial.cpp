// Magic mass ratios: what the nearest doubles give, and what is lost when the mass is nearly right.
#include <cstdio>

#include "magicmass/numbers/accurate.hpp"

int main() {
  std::printf("ratios:\n  k | alpha_k | b_t | beta_k | b_t\n");
  for (int k = 1; k <= 8; ++k) {
    const auto ratios = magicmass::accurate::ratios(k);
    std::printf("  %d | %.6f | %.6f | %.6f | %.6f\n", k, ratios.magic,
                magicmass::accurate::terminal(ratios.magic)->b_t, ratios.deficient,
                magicmass::accurate::terminal(ratios.deficient)->b_t);
  }
  const double alpha_3 = magicmass::accurate::ratios(3).magic;
  std::printf("misses:\n  ball too heavy by | energy that B does not get | N_A | N_B\n");
  for (const double miss : {-0.1, -0.01, -0.001, 0.001, 0.01, 0.1}) {
    const auto end = magicmass::accurate::terminal(alpha_3 * (1 + miss)).value();
    std::printf("  %g | %.2g | %lld | %lld\n", miss, 1 - end.rho,
                static_cast<long long>(end.counts.N_A), static_cast<long long>(end.counts.N_B));
  }
}
