// SPDX-License-Identifier: GPL-2.0-or-later
// Random constants whose values an independent oracle knows: exact arithmetic in Q(sqrt 2, sqrt 3), written by hand.
#include <array>
#include <random>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "algebraic/constant.hpp"
#include "constants.hpp"

using namespace magicmass::algebraic;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

/// a + b sqrt 2 + c sqrt 3 + d sqrt 6
struct Oracle {
  std::array<numeric, 4> c;

  friend Oracle operator+(const Oracle& x, const Oracle& y) {
    return {x.c[0] + y.c[0], x.c[1] + y.c[1], x.c[2] + y.c[2], x.c[3] + y.c[3]};
  }
  friend Oracle operator*(const Oracle& x, const Oracle& y) {
    const auto& a = x.c;
    const auto& b = y.c;
    return {a[0] * b[0] + 2 * a[1] * b[1] + 3 * a[2] * b[2] + 6 * a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + 3 * (a[2] * b[3] + a[3] * b[2]),
            a[0] * b[2] + a[2] * b[0] + 2 * (a[1] * b[3] + a[3] * b[1]),
            a[0] * b[3] + a[3] * b[0] + a[1] * b[2] + a[2] * b[1]};
  }
  bool is_zero() const {
    return c[0].is_zero() && c[1].is_zero() && c[2].is_zero() && c[3].is_zero();
  }
  /// The product of the three other conjugates over the norm.
  Oracle inverse() const {
    const Oracle first = {c[0], -c[1], c[2], -c[3]};
    const Oracle second = {c[0], c[1], -c[2], -c[3]};
    const Oracle third = {c[0], -c[1], -c[2], c[3]};
    const Oracle others = first * second * third;
    const numeric norm = (*this * others).c[0];
    return {others.c[0] / norm, others.c[1] / norm, others.c[2] / norm, others.c[3] / norm};
  }
  ex written() const { return c[0] + c[1] * root(2) + c[2] * root(3) + c[3] * root(6); }
};

struct Sample {
  ex tree;
  Oracle value;
};

class RandomConstants {
public:
  explicit RandomConstants(unsigned seed) : generator_(seed) {}

  long number(long low, long high) {
    return std::uniform_int_distribution<long>(low, high)(generator_);
  }

  Sample operator()(int depth) {
    if (depth == 0) return leaf();
    const Sample x = (*this)(depth - 1);
    const Sample y = (*this)(static_cast<int>(number(0, depth - 1)));
    switch (number(0, 4)) {
      case 0:
        return {x.tree + y.tree, x.value + y.value};
      case 1:
        return {x.tree - y.tree, x.value + Oracle{-1, 0, 0, 0} * y.value};
      case 2:
        return {x.tree * y.tree, x.value * y.value};
      case 3:
        if (y.value.is_zero()) return x;
        return {x.tree / y.tree, x.value * y.value.inverse()};
      default: {
        // sqrt(x^2), the square written out, is x or -x
        const int sign = x.value.written().evalf() > 0 ? 1 : -1;
        return {root((x.value * x.value).written()), Oracle{sign, 0, 0, 0} * x.value};
      }
    }
  }

private:
  Sample leaf() {
    const numeric rational(number(-9, 9), number(1, 9));
    switch (number(0, 4)) {
      case 0:
        return {root(2), {0, 1, 0, 0}};
      case 1:
        return {root(3), {0, 0, 1, 0}};
      case 2:
        return {root(5 + 2 * root(6)), {0, 1, 1, 0}};
      case 3:
        return {GiNaC::cos(GiNaC::Pi / 12) * 4, {0, 1, 0, 1}};
      default:
        return {rational, {rational, 0, 0, 0}};
    }
  }

  std::mt19937 generator_;
};

}  // namespace

TEST_CASE("random expressions are equal to their normal forms, and to nothing near", "[check]") {
  const numeric tiny = numeric(10).power(-60);
  for (unsigned seed = 1; seed <= 150; ++seed) {
    RandomConstants random(seed);
    const Sample sample = random(4);
    const ex zero = sample.tree - sample.value.written();
    INFO("seed " << seed << ": " << sample.tree);
    const Decision decision = sign_of(zero);
    INFO(decision.method);
    CHECK(decision.sign == 0);
    CHECK(sign_of(zero + tiny).sign == 1);
    CHECK(sign_of(zero - tiny).sign == -1);
    CHECK(sign_of(sample.tree).sign == sign_of(sample.value.written()).sign);
    CHECK((sign_of(sample.tree).sign == 0) == sample.value.is_zero());
  }
}

TEST_CASE("cosine sums vanish exactly when numerics at 60 digits say so", "[check]") {
  GiNaC::Digits = 60;
  std::mt19937 generator(7);
  const auto number = [&](long low, long high) {
    return std::uniform_int_distribution<long>(low, high)(generator);
  };
  int zeros = 0;
  for (int round = 0; round < 200; ++round) {
    const long m = number(3, 60);
    ex sum = 0;
    // Sums over cosets of a subgroup, which vanish, and now and then a stray term.
    for (int part = 0; part < 3; ++part) {
      const long start = number(0, m - 1);
      for (long divisor = 2; divisor <= m; ++divisor)
        if (m % divisor == 0 && number(0, 1) == 1) {
          const long factor = number(-3, 3);
          for (long i = 0; i < divisor; ++i)
            sum += factor * GiNaC::cos(2 * GiNaC::Pi * numeric(start + i * (m / divisor), m));
        }
    }
    if (number(0, 3) == 0) sum += number(1, 2) * GiNaC::sin(GiNaC::Pi * numeric(number(1, m), m));
    const bool vanishes = abs(GiNaC::ex_to<numeric>(sum.evalf())) < numeric(10).power(-50);
    zeros += vanishes ? 1 : 0;
    INFO(sum);
    CHECK((sign_of(sum).sign == 0) == vanishes);
  }
  CHECK(zeros > 50);
  CHECK(zeros < 195);
  GiNaC::Digits = 17;
}
