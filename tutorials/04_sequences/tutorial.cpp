// All velocities in closed form: exact fractions by formula and by stepping; then a leap.
#include <bit>
#include <cstdint>
#include <cstdio>

#include <cln/rational.h>

#include "kernel/expr.hpp"
#include "magicmass/exact/exact.hpp"
#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/counts.hpp"
#include "magicmass/simulator/three_bodies.hpp"

using cln::cl_RA;

int main() {
  const cl_RA alpha = cl_RA(1) / 7;
  std::printf("alpha: %s\n", kernel::digits(alpha).c_str());
  // Velocities as fractions by the exact form, and whether stepping gives the same ones.
  std::printf("fractions:\n  n | a_n | b_n | c_n | c'_n | stepping agrees\n");
  magicmass::simulator::ThreeBodies<cl_RA> motion(alpha);
  for (std::int64_t n = 1; motion.step(); ++n) {
    const cl_RA c = motion.bodies()[1].velocity;
    if (!motion.step()) break;
    const auto v = magicmass::generated::velocities_exact(alpha, n);
    const auto& bodies = motion.bodies();
    const bool same = v.a == bodies[0].velocity && v.b == bodies[2].velocity && v.c == c &&
                      v.c_prime == bodies[1].velocity;
    std::printf("  %lld", static_cast<long long>(n));
    for (const cl_RA& number : {v.a, v.b, v.c, v.c_prime})
      std::printf(" | %s", kernel::digits(number).c_str());
    std::printf(" | %s\n", same ? "yes" : "no");
  }
  // A leap into the middle of a long story: no step before it has to be taken.
  const double feather = 1e-20;
  const std::int64_t middle = magicmass::count_collisions(feather)->N_B / 2;
  const auto v = magicmass::accurate::velocities(feather, middle);
  std::printf("feather: %g\nmiddle: %lld\ndoublings: %d\n", feather, static_cast<long long>(middle),
              int(std::bit_width(std::uint64_t(middle))));
  std::printf("leap:\n  a_n | b_n | c_n | c'_n\n  %.6g | %.6g | %.6g | %.6g\n", v.a, v.b, v.c,
              v.c_prime);
}
