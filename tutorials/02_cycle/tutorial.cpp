// One cycle as a matrix: two mirrors, applied one after the other, again and again.
#include <array>
#include <cmath>
#include <cstdio>

#include "magicmass/plain/matrices.hpp"

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

double dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
Vector operator*(const Matrix& m, const Vector& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}
Matrix operator*(const Matrix& x, const Matrix& y) {
  Matrix out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = dot(x[i], {y[0][j], y[1][j], y[2][j]});
  return out;
}

void print_matrix(const char* name, const Matrix& m) {
  std::printf("%s:\n  column 1 | column 2 | column 3\n", name);
  for (const Vector& row : m) std::printf("  %.2f | %.2f | %.2f\n", row[0], row[1], row[2]);
}

int main() {
  const double alpha = 0.25;  // with which all entries are short decimals
  const Matrix Gamma_A = magicmass::generated::Gamma_A(alpha);
  const Matrix Gamma_B = magicmass::generated::Gamma_B(alpha);
  const Matrix Lambda = magicmass::generated::Lambda(alpha);
  std::printf("alpha: %g\n", alpha);
  print_matrix("Lambda", Lambda);
  print_matrix("mirror_twice", Gamma_A * Gamma_A);
  print_matrix("other_order", Gamma_A * Gamma_B);

  // V_n = Lambda^n V_0. Its third component is the ball's velocity times the root of alpha.
  Vector V_n{1, 0, 0};
  std::printf("cycles:\n  n | a_n | b_n | third | sum of squares | does a collision follow?\n");
  for (int n = 0; n <= 4; ++n) {
    const bool catches_up = V_n[0] > V_n[2] / std::sqrt(alpha);
    std::printf("  %d | %.8g | %.8g | %.8g | %.8g | %s\n", n, V_n[0], V_n[1], V_n[2], dot(V_n, V_n),
                catches_up ? "yes" : "no");
    V_n = Lambda * V_n;
  }
}
