// Collisions that lose energy: what still arrives at B, and collisions that never end.
#include <cstdio>

#include <cln/cln.h>

#include "magicmass/exact/exact.hpp"
#include "magicmass/numbers/fast.hpp"
#include "magicmass/plain/restitution.hpp"
#include "magicmass/simulator/engine.hpp"

using magicmass::fast::terminal;

// Three equal masses, to be stepped in doubles.
magicmass::simulator::Engine<double> three_equal(double e) {
  return magicmass::simulator::Engine<double>({{1, 1, 1}, {0, 0, 1}, {1, 0, 0}, {}, {}, e});
}
// Where the collisions begin to end, by halving. Whether they end is decided exactly.
double border(double never, double ends, const auto& end_at) {
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = (never + ends) / 2;
    (end_at(middle) ? ends : never) = middle;
  }
  return ends;
}

int main() {
  const double alpha = 0.12;
  std::printf("alpha: %g\nlosses:\n", alpha);
  std::printf("  e | N_A | N_B | a_t | c_t | b_t | energy of B | energy of all\n");
  for (const double e : {1.0, 0.99, 0.95, 0.9, 0.8, 0.7, 0.6}) {
    const auto end = terminal(alpha, e).value();
    std::printf("  %g | %d | %d | %.4f | %.4f | %.4f | %.4f | %.4f\n", e, int(end.counts.N_A),
                int(end.counts.N_B), end.a_t, end.c_t, end.b_t, end.rho,
                end.a_t * end.a_t + alpha * end.c_t * end.c_t + end.rho);
  }
  std::printf("thresholds:\n  e | heaviest ball in collapse\n");
  for (const double e : {0.99, 0.9, 0.7, 0.5, 0.2, 0.1})
    std::printf("  %g | %.6f\n", e,
                border(1e-9, 10, [&](double ball) { return terminal(ball, e).has_value(); }));
  std::printf("equal_masses: %.6f\n",
              border(1e-3, 1, [](double e) { return terminal(1, e).has_value(); }));

  std::printf("towards_collapse:\n  e | simulated | close calls | exact\n");
  for (const double e : {1.0, 0.5, 0.2, 0.1, 0.08, 0.074, 0.072, 0.0719}) {
    auto motion = three_equal(e);
    std::int64_t simulated = 0;
    while (motion.next()) simulated = motion.step().number;
    const auto exact = terminal(1, e)->counts;
    std::printf("  %g | %d | %d | %d\n", e, int(simulated), int(motion.ties().near),
                int(exact.N_A + exact.N_B));
  }
  const double below = 0.05;
  std::printf("below: %g\ncollapse:\n  collisions so far | time\n", below);
  auto motion = three_equal(below);
  for (int j = 1; j <= 12; ++j) {
    const double time = motion.step().time;
    if (j % 2 == 0) std::printf("  %d | %.6f\n", j, time);
  }
  const double q_e = cln::double_approx(
      magicmass::generated::shape_exact<cln::cl_RA>(1, 1, 1, cln::rational(cln::cl_R(below))).q_e);
  std::printf("collapse_time: %.6f\n", magicmass::generated::collapse_restitution(
                                           1.0, 1.0, 1.0, below, q_e, 1.0, 0.0, 0.0, 1.0)
                                           .t_any);
}
