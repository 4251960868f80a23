// SPDX-License-Identifier: GPL-2.0-or-later
// The end of the story over many mass ratios: who is where in the order, and how
// little B can get.
#include <array>
#include <cstdio>
#include <numeric>

#include "magicmass/accurate.hpp"

// Where the centre of mass goes: all momentum over all mass, at the start, when A
// comes with 1 and the others rest.
double centre_velocity(double alpha) {
  const std::array<double, 3> masses{1, alpha, 1}, velocities{1, 0, 0};
  const double momentum =
      std::inner_product(masses.begin(), masses.end(), velocities.begin(), 0.0);
  return momentum / std::accumulate(masses.begin(), masses.end(), 0.0);
}

int main() {
  std::printf(
      "endings:\n  alpha | a_t | c_t | b_t | energy of B | twice the centre's "
      "velocity\n");
  for (const double alpha :
       {100.0, 10.0, 2.0, 1.0, 0.7, 0.4142, 0.3, 0.236, 0.12, 0.1, 0.01, 0.001}) {
    const auto end = magicmass::accurate::terminal(alpha).value();
    std::printf("  %g | %.6f | %.6f | %.6f | %.6f | %.6f\n", alpha, end.a_t,
                end.c_t, end.b_t, end.rho, 2 * centre_velocity(alpha));
  }

  // Many ratios, evenly spaced on a logarithmic scale. Every rule of the chapter
  // is put to the test.
  int in_order = 0, recoils = 0, never_faster = 0, at_least_twice = 0, asked = 0;
  double largest_recoil = 0, its_alpha = 0;
  for (double alpha = 1e-6; alpha < 1e3; alpha *= 1.0005) {
    const auto end = magicmass::accurate::terminal(alpha).value();
    ++asked;
    in_order += end.a_t <= end.c_t && end.c_t <= end.b_t;
    recoils += end.a_t <= 0;
    never_faster += end.b_t <= 1;
    // both sides are rounded
    at_least_twice += end.b_t >= 2 * centre_velocity(alpha) - 1e-15;
    if (alpha < 1 && -end.a_t > largest_recoil) {
      largest_recoil = -end.a_t;
      its_alpha = alpha;
    }
  }
  std::printf(
      "asked: %d\nin_order: %d\nrecoils: %d\nnever_faster: %d\nat_least_twice: "
      "%d\n",
      asked, in_order, recoils, never_faster, at_least_twice);
  std::printf("largest_recoil: %.4f\nits_alpha: %.3f\n", largest_recoil, its_alpha);
}
