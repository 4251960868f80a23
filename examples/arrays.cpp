// SPDX-License-Identifier: MIT
// A million mass ratios at once: which of them give B the largest share of the energy?
#include <algorithm>
#include <cstdio>
#include <vector>

#include "magicmass/numbers/fast.hpp"

int main() {
  std::vector<double> alpha(1'000'000), rho(alpha.size());
  for (std::size_t i = 0; i < alpha.size(); ++i) alpha[i] = double(i + 1) / 2e6;
  magicmass::fast::terminal(alpha, {.rho = rho});
  const auto best = std::max_element(rho.begin(), rho.end()) - rho.begin();
  std::printf("rho = %.9f at alpha = %.6f\n", rho[std::size_t(best)], alpha[std::size_t(best)]);
}
