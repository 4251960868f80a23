// SPDX-License-Identifier: GPL-2.0-or-later
// One cycle as a matrix: derived, then applied again and again.
#include <array>
#include <cstdio>

#include "derivation/book.hpp"
#include "kernel/print.hpp"
#include "magicmass/plain/matrices.hpp"

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

Vector operator*(const Matrix& m, const Vector& v) {
  Vector out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i] += m[i][j] * v[j];
  return out;
}

int main() {
  for (const char* id : {"cycle.Lambda_product", "cycle.Lambda_orthogonal", "cycle.recurrence"})
    std::printf("%s\n", kernel::text(derivation::the_book()[id].conclusion()).c_str());

  // The mass ratio is a square, so that its root is a fraction and all numbers are short.
  const double alpha = 0.25;
  const Matrix Lambda = magicmass::generated::Lambda(alpha);
  std::printf("Lambda at alpha = %g:\n", alpha);
  for (const Vector& row : Lambda) std::printf("  %6.2f %6.2f %6.2f\n", row[0], row[1], row[2]);

  // V_n = Lambda^n V_0. Its third component is the ball's velocity times the root of alpha.
  Vector V_n{1, 0, 0};
  std::printf("n | a | b | third | sum of squares | does a collision follow?\n");
  for (int n = 0; n <= 4; ++n) {
    const double length = V_n[0] * V_n[0] + V_n[1] * V_n[1] + V_n[2] * V_n[2];
    const bool catches_up = V_n[0] > V_n[2] / 0.5;
    std::printf("%d | %.6f | %.6f | %.6f | %.6f | %s\n", n, V_n[0], V_n[1], V_n[2], length,
                catches_up ? "yes" : "no");
    V_n = Lambda * V_n;
  }
}
