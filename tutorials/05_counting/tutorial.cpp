// SPDX-License-Identifier: GPL-2.0-or-later
// How many collisions: the approach speeds one by one, the exact count, and a
// count that goes wrong.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numbers>

#include "magicmass/accurate.hpp"
#include "magicmass/angle_closed.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/simulator/velocity_stepping.hpp"

using magicmass::Body;

// Collisions of one run, one by one, each with the speed at which the pair
// approaches.
void print_run(double alpha) {
  std::printf(
      "run:\n  collision | a | b | ball | approach speed before the next\n");
  magicmass::step_velocities(alpha, 1.0, 1000, [](const auto& event) {
    const auto& v = event.after;
    // After A was hit, the ball goes for B, and the other way round.
    const double approach = event.body == Body::A ? v.c - v.b : v.a - v.c;
    std::printf("  %c %lld | %.4f | %.4f | %.4f | %.4f\n",
                event.body == Body::A ? 'P' : 'Q', static_cast<long long>(event.n),
                v.a, v.b, v.c, approach);
  });
}

// The exact counts for lighter and lighter balls. If they grow as one over the
// root of the mass ratio, then the last column tends to a number.
void print_light_balls() {
  std::printf("light_balls:\n  alpha | N_A | N_B | N_A*sqrt(alpha)\n");
  for (const double alpha :
       {10.0, 1.0, 0.5, 0.12, 1e-2, 1e-4, 1e-8, 1e-16, 1e-30}) {
    const auto counts = magicmass::count_collisions(alpha).value();
    std::printf("  %g | %lld | %lld | %.6f\n", alpha,
                static_cast<long long>(counts.N_A),
                static_cast<long long>(counts.N_B),
                static_cast<double>(counts.N_A) * std::sqrt(alpha));
  }
}

// The naive count: the generated angle, then theorem counting.N_A (Ee & Lee eq.
// eq:NA-ans) as anybody would type it. Good, but for rounding.
std::int64_t typed_count(double alpha) {
  const double psi = magicmass::generated::angle_closed(alpha);
  return static_cast<std::int64_t>(std::ceil(std::numbers::pi / psi - 0.5));
}

int main() {
  print_run(0.12);
  print_light_balls();

  // Just at the thresholds alpha_k: the double nearest to each, and its two
  // neighbours.
  int wrong = 0, asked = 0;
  for (std::int64_t k = 1; k <= 1000; ++k) {
    const double threshold = magicmass::accurate::ratios(k).magic;
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double alpha : {std::nextafter(threshold, 0.0), threshold,
                               std::nextafter(threshold, infinity)}) {
      ++asked;
      if (typed_count(alpha) != magicmass::count_collisions(alpha)->N_A) ++wrong;
    }
  }
  std::printf("asked_near_thresholds: %d\n", asked);
  // How often exactly depends on the C library, so only how often, roughly.
  std::printf("wrong_near_thresholds: %s\n",
              10 * wrong >= 2 * asked ? "more than one in five" : "fewer");
}
