// The axis and the angle of one cycle, and the vector of velocities on its circle.
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/counts.hpp"
#include "magicmass/plain/matrices.hpp"

using Vector = std::array<double, 3>;

double dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
double degrees(double angle) { return 180 / std::numbers::pi * angle; }

// The angle between what is left of two vectors without their parts along the axis.
double angle_about(const Vector& axis, const Vector& x, const Vector& y) {
  const double x_along = dot(x, axis), y_along = dot(y, axis);
  const double across = dot(x, y) - x_along * y_along;
  return std::acos(across /
                   std::sqrt((dot(x, x) - x_along * x_along) * (dot(y, y) - y_along * y_along)));
}

int main() {
  std::printf("angles:\n  alpha | psi in degrees | half of psi | cycles in a full turn\n");
  for (const double alpha : {1e9, 10.0, 1.0, 0.5, 0.1, 0.01, 0.0001}) {
    const double psi = magicmass::accurate::angle(alpha);
    std::printf("  %g | %.4f | %.4f | %.4f\n", alpha, degrees(psi), degrees(psi / 2),
                2 * std::numbers::pi / psi);
  }
  const double alpha = 0.1;
  const auto R = magicmass::generated::R(alpha);
  const Vector e_3{R[0][2], R[1][2], R[2][2]};  // its third column: Lambda leaves it alone
  std::printf("chosen_alpha: %g\nchosen_angle: %.4f\n", alpha,
              degrees(magicmass::accurate::angle(alpha)));
  std::printf("turning:\n  n | a_n | b_n | along the axis | turned in degrees\n");
  Vector before{};
  for (int n = 0; n <= magicmass::count_collisions(alpha)->N_B; ++n) {
    const auto v = magicmass::accurate::velocities(alpha, n);
    const Vector V_n{v.a, v.b, std::sqrt(alpha) * v.c_prime};
    std::printf("  %d | %.6f | %.6f | %.6f | ", n, V_n[0], V_n[1], dot(V_n, e_3));
    if (n == 0)
      std::printf("start\n");
    else
      std::printf("%.4f\n", degrees(angle_about(e_3, before, V_n)));
    before = V_n;
  }
}
