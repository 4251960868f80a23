// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts that lose energy: what still arrives at B, and collisions that never
// end.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "magicmass/fast.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/restitution.hpp"
#include "magicmass/simulator/line_motion.hpp"

using magicmass::Line;
using magicmass::LineEvent;
using magicmass::LineMotion;
namespace reference = magicmass::reference;

struct Outcome {
  magicmass::Counts counts;
  double a, b, c, time;
};

// Blocks of mass 1, a ball of mass alpha, restitution e; event after event, at
// most so many.
Outcome run(double alpha, double e, std::int64_t most) {
  LineMotion<double> motion(Line<double>{.masses = {1, alpha, 1},
                                         .positions = {0, 0, 1},
                                         .velocities = {1, 0, 0},
                                         .left_wall = {},
                                         .right_wall = {},
                                         .restitution = e});
  magicmass::Counts counts;
  while (motion.next() && motion.events() < most) {
    const LineEvent<double> event = motion.step();
    ++(event.gap == 1 ? counts.N_A : counts.N_B);
  }
  const auto& v = motion.line().velocities;
  return {counts, v[0], v[2], v[1], motion.now()};
}

// The collisions never end: decided exactly, for the numbers that the doubles are.
bool collapses(double alpha, double e) {
  return !reference::count_collisions(magicmass::MassRatio(alpha),
                                      reference::exact(e));
}

// Where `goes_on` changes from true to false between two numbers, by halving.
template <class Predicate>
double border(double below, double above, const Predicate& goes_on) {
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (below + above) / 2;
    (goes_on(middle) ? below : above) = middle;
  }
  return below;
}

int main() {
  const double alpha = 0.12;
  std::printf("alpha: %g\n", alpha);
  std::printf(
      "losses:\n  e | N_A | N_B | a_t | c_t | b_t | energy of B | energy of all\n");
  for (const double e : {1.0, 0.99, 0.95, 0.9, 0.8, 0.7, 0.6}) {
    const Outcome end = run(alpha, e, 1000);
    std::printf("  %g | %lld | %lld | %.4f | %.4f | %.4f | %.4f | %.4f\n", e,
                static_cast<long long>(end.counts.N_A),
                static_cast<long long>(end.counts.N_B), end.a, end.c, end.b,
                end.b * end.b,
                end.a * end.a + alpha * end.c * end.c + end.b * end.b);
  }

  std::printf("thresholds:\n  e | heaviest ball in collapse\n");
  for (const double e : {0.99, 0.9, 0.7, 0.5, 0.2, 0.1})
    std::printf("  %g | %.6f\n", e,
                border(1e-9, 10, [&](double ball) { return collapses(ball, e); }));
  std::printf("equal_masses: %.6f\n",
              border(1e-3, 1, [](double e) { return collapses(1, e); }));

  // Three equal masses, restitution from above towards the threshold: events in
  // double precision, and the exact count.
  std::printf("towards_collapse:\n  e | simulated | exact\n");
  for (const char* const e :
       {"1", "1/2", "1/5", "1/10", "2/25", "37/500", "9/125", "719/10000"}) {
    const cln::cl_RA exact_e = reference::parse_rational(e);
    const auto exact =
        reference::count_collisions(magicmass::MassRatio(1.0), exact_e);
    const Outcome end = run(1, reference::nearest<double>(exact_e), 1000);
    std::printf("  %s | %lld | %s\n", e,
                static_cast<long long>(end.counts.N_A + end.counts.N_B),
                reference::to_text(exact->N_A + exact->N_B).c_str());
  }
  const double below = 0.05;
  std::printf("below: %g\n", below);
  std::printf("collapse:\n  collisions so far | time\n");
  for (const std::int64_t most : {2, 4, 6, 8, 10, 12}) {
    const Outcome end = run(1, below, most);
    std::printf("  %lld | %.6f\n", static_cast<long long>(most), end.time);
  }
  std::printf("collapse_time: %.6f\n", magicmass::fast::collapse_time(1, below));
}
