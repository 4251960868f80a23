// SPDX-License-Identifier: GPL-2.0-or-later
// Eigen's matrices of exact rationals: alpha the square of one, so that the root is rational.
#include <ostream>
#include <random>

#include <catch2/catch.hpp>
#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/eigen.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"

using namespace magicmass;

namespace {

/// A rational that Eigen can hold; its root exists or the test is wrong.
struct Rational {
  cln::cl_RA value = 0;
  Rational() = default;
  Rational(int x) : value(x) {}
  explicit Rational(const cln::cl_RA& x) : value(x) {}
  friend Rational operator+(const Rational& x, const Rational& y) {
    return Rational(x.value + y.value);
  }
  friend Rational operator-(const Rational& x, const Rational& y) {
    return Rational(x.value - y.value);
  }
  friend Rational operator*(const Rational& x, const Rational& y) {
    return Rational(x.value * y.value);
  }
  friend Rational operator/(const Rational& x, const Rational& y) {
    return Rational(x.value / y.value);
  }
  friend Rational operator-(const Rational& x) { return Rational(-x.value); }
  Rational& operator+=(const Rational& x) { return *this = *this + x; }
  friend bool operator==(const Rational& x, const Rational& y) { return x.value == y.value; }
  friend std::ostream& operator<<(std::ostream& text, const Rational& x) {
    return text << reference::to_text(x.value);
  }
  friend Rational sqrt(const Rational& x) {
    cln::cl_RA root;
    REQUIRE(cln::sqrtp(x.value, &root));
    return Rational(root);
  }
};

}  // namespace

template <>
struct Eigen::NumTraits<Rational> : Eigen::GenericNumTraits<Rational> {
  using Real = Rational;
  using NonInteger = Rational;
  using Nested = Rational;
  static int digits10() { return 0; }  // all of them are printed
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 10,
    AddCost = 100,
    MulCost = 100
  };
};

TEST_CASE("powers of Lambda give the vectors of the collision law, exactly", "[check]") {
  std::mt19937_64 random(9);
  for (int i = 0; i < 30; ++i) {
    const Rational root(cln::cl_RA(static_cast<long>(random() % 9 + 1)) /
                        static_cast<long>(random() % 30 + 1));
    const Rational alpha = root * root;
    const Matrix3<Rational> cycle = Lambda(alpha);
    const Matrix3<Rational> square = cycle.transpose() * cycle;
    CHECK(square == Matrix3<Rational>(Matrix3<Rational>::Identity()));
    Vector3<Rational> V = V_n(alpha, 0);
    CHECK(V == Vector3<Rational>(1, 0, 0));
    for (int n = 1; n <= 8; ++n) {
      const Vector3<Rational> turned = cycle * V;
      V = V_n(alpha, n);
      CHECK(turned == V);
      // the oracle knows the collision law alone
      const auto expected = reference::exact_velocities(alpha.value, cln::cl_I(n));
      CHECK(V(0).value == expected.a);
      CHECK(V(1).value == expected.b);
      CHECK(V(2).value == root.value * expected.c_prime);
    }
  }
}
