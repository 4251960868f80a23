// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/radical_ring.hpp"

#include <catch2/catch.hpp>

using namespace magicmass::algebraic;
using Number = RadicalRing::Number;

namespace {

struct Fixture {
  Work work{{}};
  RadicalRing ring{60, work};

  Number root(const Number& radicand, long index = 2) {
    return RadicalRing::power_of_generator(ring.generator(index, radicand), 1, 1);
  }
  Number root(long radicand, long index = 2) { return root(RadicalRing::number(radicand), index); }
  Number minus(const Number& x, const Number& y) {
    return RadicalRing::sum(x, ring.product(y, RadicalRing::number(-1)));
  }
  Number plus(const Number& x, const Number& y) { return RadicalRing::sum(x, y); }
};

}  // namespace

TEST_CASE("conjugates of zero are not zero", "[exam]") {
  Fixture f;
  // sqrt(5 + 2 sqrt 6) - sqrt 2 - sqrt 3 = 0; squared, its conjugates look the same
  const Number s6 = f.ring.product(f.root(2), f.root(3));
  const Number five = RadicalRing::number(5);
  const Number nested = f.root(f.plus(five, f.plus(s6, s6)));
  CHECK(f.ring.is_zero(f.minus(nested, f.plus(f.root(2), f.root(3)))) == true);
  CHECK(f.ring.is_zero(f.plus(nested, f.plus(f.root(2), f.root(3)))) == false);
  const Number other = f.root(f.minus(five, f.plus(s6, s6)));
  CHECK(f.ring.is_zero(f.minus(other, f.minus(f.root(3), f.root(2)))) == true);
  CHECK(f.ring.is_zero(f.minus(other, f.minus(f.root(2), f.root(3)))) == false);
}

TEST_CASE("a radical that lies in the cyclotomic field is recognised with its sign", "[exam]") {
  Fixture f;
  const Number c = f.ring.cosine(cln::cl_RA(1) / 5);  // (sqrt 5 - 1)/4
  const Number four = f.ring.product(c, RadicalRing::number(4));
  const Number one = RadicalRing::number(1);
  CHECK(f.ring.is_zero(f.minus(f.plus(four, one), f.root(5))) == true);
  CHECK(f.ring.is_zero(f.plus(f.plus(four, one), f.root(5))) == false);
  const Number d = f.ring.product(f.ring.cosine(cln::cl_RA(2) / 5), RadicalRing::number(4));
  CHECK(f.ring.is_zero(f.plus(f.plus(d, one), f.root(5))) == true);
  CHECK(f.ring.is_zero(f.minus(f.plus(d, one), f.root(5))) == false);
}

TEST_CASE("roots of odd and even index", "[exam]") {
  Fixture f;
  const Number s5 = f.root(5);
  const Number phi =
      f.ring.product(f.plus(RadicalRing::number(1), s5), RadicalRing::number(cln::cl_RA(1) / 2));
  const Number cube = f.root(f.plus(RadicalRing::number(2), s5), 3);
  CHECK(f.ring.is_zero(f.minus(cube, phi)) == true);
  CHECK(f.ring.is_zero(f.plus(cube, phi)) == false);
  // phi^4 = (7 + 3 sqrt 5)/2
  const Number fourth = f.root(f.ring.power(phi, 4), 4);
  CHECK(f.ring.is_zero(f.minus(fourth, phi)) == true);
  CHECK(f.ring.is_zero(f.plus(fourth, phi)) == false);
  const Number squared = f.ring.power(fourth, 2);
  CHECK(f.ring.is_zero(f.minus(squared, f.ring.power(phi, 2))) == true);
  CHECK(f.ring.is_zero(f.plus(squared, f.ring.power(phi, 2))) == false);
  CHECK(f.ring.is_zero(f.minus(f.ring.power(fourth, 3), f.ring.power(phi, 2))) == false);
  // both parts are 0 without looking so
  const Number zero = f.minus(cube, phi);
  CHECK(f.ring.is_zero(f.plus(zero, f.ring.product(zero, f.root(7, 4)))) == true);
}

TEST_CASE("a sum in three powers of one root is left open", "[exam]") {
  Fixture f;
  const Number g = f.root(f.plus(RadicalRing::number(1), f.root(2)), 3);
  const Number sum = f.plus(f.plus(f.ring.power(g, 2), g), RadicalRing::number(1));
  CHECK_FALSE(f.ring.is_zero(sum).has_value());
}

TEST_CASE("an expansion stops at its budget", "[exam]") {
  const Work work({.terms = 1000});
  RadicalRing ring(1, work);
  Number sum = RadicalRing::number(1);
  for (const long prime : {2, 3, 5, 7, 11, 13})
    sum = RadicalRing::sum(
        sum, RadicalRing::power_of_generator(ring.generator(2, RadicalRing::number(prime)), 1, 1));
  CHECK_THROWS_AS(ring.power(sum, 20), BeyondBudget);
}
