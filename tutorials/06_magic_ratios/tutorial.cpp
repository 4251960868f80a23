// SPDX-License-Identifier: GPL-2.0-or-later
// Magic mass ratios with exact numbers: collisions among the irrational numbers
// themselves, nothing rounded.
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "magicmass/accurate.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/reference/number_field.hpp"
#include "magicmass/simulator/velocity_stepping.hpp"

namespace reference = magicmass::reference;
using reference::FieldNumber;

// 1/cos(pi/q) - 1, a number of the field with y = 2 cos(pi/q) in it: sums of
// fractions times powers of y.
FieldNumber exact_ratio(std::int64_t q) {
  const auto field = reference::cosine_field(q);
  const FieldNumber y(field, {0, 1});
  return FieldNumber(2) / y - FieldNumber(1);
}

// Contact after contact in exact arithmetic, from the law of one contact alone.
void print_exact_run(std::int64_t k, const FieldNumber& alpha) {
  const auto run = magicmass::step_velocities<FieldNumber>(alpha);
  std::printf("  %lld | %.6f | %lld | %lld | %.6f | %.6f | %.6f | %s\n",
              static_cast<long long>(k), reference::nearest_double(alpha),
              static_cast<long long>(run.counts.N_A),
              static_cast<long long>(run.counts.N_B),
              reference::nearest_double(run.terminal.a),
              reference::nearest_double(run.terminal.c),
              reference::nearest_double(run.terminal.b),
              run.terminal.b == FieldNumber(1)   ? "everything"
              : run.terminal.b == run.terminal.c ? "side by side"
                                                 : "neither");
}

int main() {
  std::printf("magic:\n  k | alpha_k | N_A | N_B | a_t | c_t | b_t | exactly\n");
  for (std::int64_t k = 2; k <= 8; ++k) print_exact_run(k, exact_ratio(2 * k + 1));
  std::printf("deficient:\n  k | beta_k | N_A | N_B | a_t | c_t | b_t | exactly\n");
  for (std::int64_t k = 1; k <= 7; ++k) print_exact_run(k, exact_ratio(2 * k + 2));

  // How much is lost when the mass is only nearly right?
  const double alpha_3 = magicmass::accurate::ratios(3).magic;
  std::printf(
      "misses:\n  ball too heavy by | energy that B does not get | N_A | N_B\n");
  for (const double miss : {-0.1, -0.01, -0.001, 0.001, 0.01, 0.1}) {
    const auto end = magicmass::accurate::terminal(alpha_3 * (1 + miss)).value();
    std::printf("  %g | %.2g | %lld | %lld\n", miss, 1 - end.rho,
                static_cast<long long>(end.counts.N_A),
                static_cast<long long>(end.counts.N_B));
  }
}
