// SPDX-License-Identifier: MIT
// Exact velocities in any field: here, fractions p/q of 64-bit integers.
#include "magicmass/exact/exact.hpp"

#include <cstdio>
#include <numeric>

struct Fraction {
  long long p, q;
  Fraction(long long over, long long under = 1) : p(over), q(under) {
    const long long common = std::gcd(p, q) * (q < 0 ? -1 : 1);
    p /= common;
    q /= common;
  }
  friend Fraction operator+(Fraction x, Fraction y) { return {x.p * y.q + y.p * x.q, x.q * y.q}; }
  friend Fraction operator-(Fraction x, Fraction y) { return {x.p * y.q - y.p * x.q, x.q * y.q}; }
  friend Fraction operator*(Fraction x, Fraction y) { return {x.p * y.p, x.q * y.q}; }
  friend Fraction operator/(Fraction x, Fraction y) { return {x.p * y.q, x.q * y.p}; }
};

int main() {
  const auto v = magicmass::generated::velocities_exact(Fraction(1, 7), 2);
  std::printf("a_2 = %lld/%lld V\n", v.a.p, v.a.q);
}
