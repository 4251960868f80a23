// The end of the story for many mass ratios: the order of the bodies, and how little B can get.
#include <cstdio>

#include "magicmass/numbers/accurate.hpp"

int main() {
  std::printf("endings:\n  alpha | a_t | c_t | b_t | energy of B | twice the centre's velocity\n");
  for (const double alpha :
       {100.0, 10.0, 2.0, 1.0, 0.7, 0.4142, 0.3, 0.236, 0.12, 0.1, 0.01, 0.001}) {
    const auto end = magicmass::accurate::terminal(alpha).value();
    std::printf("  %g | %.6f | %.6f | %.6f | %.6f | %.6f\n", alpha, end.a_t, end.c_t, end.b_t,
                end.rho, 2 / (2 + alpha));
  }
  // Many ratios, evenly spaced on a logarithmic scale, put every rule of the chapter to the test.
  int asked = 0, in_order = 0, recoils = 0, never_faster = 0, at_least_twice = 0;
  double largest_recoil = 0, its_alpha = 0;
  for (double alpha = 1e-6; alpha < 1e3; alpha *= 1.0005) {
    const auto end = magicmass::accurate::terminal(alpha).value();
    ++asked;
    in_order += end.a_t <= end.c_t && end.c_t <= end.b_t;
    recoils += end.a_t <= 0;
    never_faster += end.b_t <= 1;
    at_least_twice += end.b_t >= 2 / (2 + alpha) - 1e-15;  // both sides are rounded
    if (alpha < 1 && -end.a_t > largest_recoil) {
      largest_recoil = -end.a_t;
      its_alpha = alpha;
    }
  }
  std::printf("asked: %d\nin_order: %d\nrecoils: %d\nnever_faster: %d\nat_least_twice: %d\n", asked,
              in_order, recoils, never_faster, at_least_twice);
  std::printf("largest_recoil: %.4f\nits_alpha: %.3f\n", largest_recoil, its_alpha);
}
