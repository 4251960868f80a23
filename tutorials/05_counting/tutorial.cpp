// How many collisions: approach speeds one by one, the exact count, and a count that goes wrong.
#include <cmath>
#include <cstdio>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/counts.hpp"
#include "magicmass/plain/closed.hpp"
#include "magicmass/simulator/three_bodies.hpp"

int main() {
  // Collisions of one run, one by one, each with the speed at which the next pair approaches.
  std::printf("clock:\n  collision | A | B | ball | approach speed before the next\n");
  magicmass::simulator::ThreeBodies<double> motion(0.12);
  for (int j = 0; const auto event = motion.step(); ++j) {
    const auto& [A, C, B] = motion.bodies();
    const bool with_A = event->gap == 1;
    const double approach = with_A ? C.velocity - B.velocity : A.velocity - C.velocity;
    std::printf("  %c %d | %.4f | %.4f | %.4f | %.4f\n", with_A ? 'P' : 'Q', j / 2 + 1, A.velocity,
                B.velocity, C.velocity, approach);
  }
  // If the counts grow as one over the root of the mass ratio, the last column tends to a number.
  std::printf("light_balls:\n  alpha | N_A | N_B | N_A*sqrt(alpha)\n");
  for (const double alpha : {10.0, 1.0, 0.5, 0.12, 1e-2, 1e-4, 1e-8, 1e-16, 1e-30}) {
    const auto counts = magicmass::count_collisions(alpha).value();
    std::printf("  %g | %lld | %lld | %.6f\n", alpha, static_cast<long long>(counts.N_A),
                static_cast<long long>(counts.N_B), double(counts.N_A) * std::sqrt(alpha));
  }
  // The paper's formula in doubles, at the doubles nearest to the thresholds and their neighbours.
  int wrong = 0, asked = 0;
  for (std::int64_t k = 2; k <= 1000; ++k) {
    const double threshold = magicmass::accurate::ratios(k).magic;
    for (const double alpha :
         {std::nextafter(threshold, 0.0), threshold, std::nextafter(threshold, 1.0)}) {
      ++asked;
      const double formula = magicmass::generated::terminal_closed(alpha).N_A;
      if (formula != double(magicmass::count_collisions(alpha)->N_A)) ++wrong;
    }
  }
  // How often exactly depends on the C library, so only roughly.
  std::printf("asked_near_thresholds: %d\nwrong_near_thresholds: %s\n", asked,
              5 * wrong >= asked ? "more than one in five" : "fewer");
}
