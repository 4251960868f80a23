// SPDX-License-Identifier: MIT
// Exact velocities in any field: here, fractions of 64-bit integers.
#include "magicmass/exact/exact.hpp"

#include <cstdint>
#include <cstdio>
#include <numeric>

struct Fraction {
  std::int64_t over, under;
  Fraction(std::int64_t p, std::int64_t q = 1) : over(p), under(q) {
    const std::int64_t common = std::gcd(over, under) * (under < 0 ? -1 : 1);
    over /= common;
    under /= common;
  }
  friend Fraction operator+(Fraction x, Fraction y) {
    return {x.over * y.under + y.over * x.under, x.under * y.under};
  }
  friend Fraction operator-(Fraction x, Fraction y) { return x + Fraction(-y.over, y.under); }
  friend Fraction operator*(Fraction x, Fraction y) { return {x.over * y.over, x.under * y.under}; }
  friend Fraction operator/(Fraction x, Fraction y) { return {x.over * y.under, x.under * y.over}; }
};

int main() {
  const auto v = magicmass::generated::velocities_exact(Fraction(1, 7), 2);
  std::printf("a_2 = %lld/%lld V\n", static_cast<long long>(v.a.over),
              static_cast<long long>(v.a.under));
}
