// SPDX-License-Identifier: GPL-2.0-or-later
// All velocities in closed form: exact fractions from the formula and from
// contact after contact; a plot; a leap.
#include <cstdint>
#include <cstdio>
#include <string>

#include <cln/rational.h>

#include "magicmass/accurate.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/velocity_stepping.hpp"
#include "magicmass/velocities_exact.hpp"

using magicmass::Body;
using magicmass::reference::to_text;

// Velocities as fractions by the rational form, and whether stepping contact by
// contact gives the same ones.
void print_fractions(const cln::cl_RA& alpha) {
  std::printf("fractions:\n  n | a(n) | b(n) | c(n) | c'(n) | stepping agrees\n");
  cln::cl_RA c = 0;  // of the ball after the last P
  magicmass::step_velocities<cln::cl_RA>(alpha, 1, 1000, [&](const auto& event) {
    if (event.body == Body::A) {
      c = event.after.c;
      return;
    }
    const auto v =
        magicmass::generated::velocities_exact<cln::cl_RA>(alpha, event.n);
    const bool same = v.a == event.after.a && v.b == event.after.b && v.c == c &&
                      v.c_prime == event.after.c;
    std::printf("  %lld | %s | %s | %s | %s | %s\n",
                static_cast<long long>(event.n), to_text(v.a).c_str(),
                to_text(v.b).c_str(), to_text(v.c).c_str(),
                to_text(v.c_prime).c_str(), same ? "yes" : "no");
  });
}

int main() {
  const std::string alpha_text = "1/7";
  std::printf("alpha: %s\n", alpha_text.c_str());
  print_fractions(magicmass::reference::parse_rational(alpha_text));

  // A light ball: many cycles, so that one sees the curves on which the
  // velocities lie.
  const double light = 0.001;
  const std::int64_t cycles = magicmass::count_collisions(light)->N_B;
  std::printf("light: %g\n", light);
  std::printf("curves:\n  n | a | b | c | c'\n");
  for (std::int64_t n = 1; n <= cycles; ++n) {
    const auto v = magicmass::accurate::velocities(light, n);
    std::printf("  %lld | %.4f | %.4f | %.4f | %.4f\n", static_cast<long long>(n),
                v.a, v.b, v.c, v.c_prime);
  }

  // A leap into the middle of a long story: no step before it has to be taken.
  const double feather = 1e-20;
  const std::int64_t middle = magicmass::count_collisions(feather)->N_B / 2;
  const auto v = magicmass::accurate::velocities(feather, middle);
  std::printf("feather: %g\nmiddle: %lld\n", feather,
              static_cast<long long>(middle));
  std::printf("leap:\n  a | b | c | c'\n  %.6g | %.6g | %.6g | %.6g\n", v.a, v.b,
              v.c, v.c_prime);
}
