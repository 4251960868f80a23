// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/root_sum.hpp"

#include <random>

#include <catch2/catch.hpp>

#include "algebraic/cosine_polynomial.hpp"

using namespace magicmass::algebraic;
using cln::cl_I;
using cln::cl_RA;

namespace {

/// The independent oracle: the remainder by the cyclotomic polynomial is 0.
bool is_multiple_of_cyclotomic(const RootSum& x, long m) {
  std::vector<cl_RA> rest(static_cast<std::size_t>(m));
  for (const auto& [exponent, value] : x) rest[static_cast<std::size_t>(exponent)] = value;
  const Polynomial phi = cyclotomic_polynomial(m);
  const auto degree = static_cast<std::size_t>(phi.degree());
  for (std::size_t i = rest.size(); i-- > degree;) {
    const cl_RA factor = rest[i];
    for (std::size_t j = 0; j <= degree; ++j)
      rest[i - degree + j] = rest[i - degree + j] - factor * phi.coefficients[j];
  }
  for (const cl_RA& value : rest)
    if (!cln::zerop(value)) return false;
  return true;
}

}  // namespace

TEST_CASE("sums of roots of unity vanish when the cyclotomic polynomial divides them", "[check]") {
  std::mt19937 generator(11);
  const auto number = [&](long low, long high) {
    return std::uniform_int_distribution<long>(low, high)(generator);
  };
  int zeros = 0;
  for (int round = 0; round < 3000; ++round) {
    const long m = number(1, 72);
    const RootsOfUnity roots(m);
    RootSum sum;
    for (int part = 0; part < 3; ++part) {
      const long start = number(0, m - 1);
      for (long p = 2; p <= m; ++p) {
        if (m % p != 0 || number(0, 1) == 0) continue;
        const long factor = number(1, 3);
        for (long i = 0; i < p; ++i)
          RootsOfUnity::add(sum, {{(start + i * (m / p)) % m, cl_RA(factor)}});
      }
    }
    if (number(0, 2) == 0) RootsOfUnity::add(sum, {{number(0, m - 1), cl_RA(-1)}});
    CHECK(roots.vanishes(sum) == is_multiple_of_cyclotomic(sum, m));
    zeros += roots.vanishes(sum) ? 1 : 0;
  }
  CHECK(zeros > 1000);
  CHECK(zeros < 2900);
}

TEST_CASE("large orders cost no more than the terms that are there", "[exam]") {
  const RootsOfUnity roots(4L * 1000003);
  const RootSum c = roots.cosine(cl_RA(1) / 1000003);
  RootSum identity = roots.product(c, c);  // cos^2 x = (1 + cos 2x)/2
  RootsOfUnity::add(identity, roots.product(roots.cosine(cl_RA(2) / 1000003),
                                            RootsOfUnity::number(cl_RA(-1) / 2)));
  CHECK_FALSE(roots.vanishes(identity));
  RootsOfUnity::add(identity, RootsOfUnity::number(cl_RA(-1) / 2));
  CHECK(roots.vanishes(identity));
  CHECK_FALSE(roots.vanishes(c));
}
