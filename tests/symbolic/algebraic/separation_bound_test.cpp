// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/separation_bound.hpp"

#include <chrono>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "algebraic/decision.hpp"

using namespace magicmass::algebraic;
using cln::cl_RA;

TEST_CASE("numbers other than 0 are never below their bound", "[check]") {
  std::mt19937 generator(5);
  const auto number = [&](long low, long high) {
    return std::uniform_int_distribution<long>(low, high)(generator);
  };
  const Work work({.time = std::chrono::hours(1)});  // a slow machine is no fault
  double closest = 1e9;
  for (int round = 0; round < 3000; ++round) {
    Terms terms({});
    std::vector<std::size_t> parts;
    for (int i = 0; i < 4; ++i) {
      const cl_RA coefficient = cl_RA(number(0, 1) == 0 ? -1 : 1) / cln::cl_I(number(1, 3));
      const std::size_t radical =
          number(0, 3) == 0
              ? terms.cosine(cl_RA(number(1, 12)) / cln::cl_I(number(5, 12)))
              : terms.root(terms.rational(cl_RA(number(1, 60)) / cln::cl_I(number(1, 4))),
                           number(2, 3));
      parts.push_back(terms.product({radical, terms.rational(coefficient)}));
    }
    std::size_t term = terms.sum(parts);
    if (number(0, 2) == 0) {
      if (decide(terms, term, work).sign == 0) continue;
      term = terms.sum({terms.power(term, -1), terms.rational(number(-3, 3)), parts[0]});
    }
    if (decide(terms, term, work).sign == 0) continue;
    const double bits = separation_bound(terms, term, {}).value().bits;
    const Interval value = terms.enclosure(term, 200, work).magnitude();
    REQUIRE(value.low().sign() == 1);
    const double margin = bits + static_cast<double>(value.low().top());
    closest = std::min(closest, margin);
    CHECK(margin >= 0);
  }
  CHECK(closest < 10);  // the bound is not idle
}

TEST_CASE("the degree does not grow with the number of cosines or of products of primes",
          "[exam]") {
  Terms terms({});
  std::vector<std::size_t> cosines;
  for (long i = 1; i < 30; ++i) cosines.push_back(terms.cosine(cl_RA(i) / 60));
  CHECK(separation_bound(terms, terms.sum(cosines), {}).value().degree == 8);  // phi(60)/2
  std::vector<std::size_t> roots;
  for (const long n : {2, 3, 5, 6, 10, 15, 30}) roots.push_back(terms.root(terms.rational(n), 2));
  CHECK(separation_bound(terms, terms.sum(roots), {}).value().degree == 8);
}

TEST_CASE("Euler's function", "[exam]") {
  CHECK(totient_bound(1) == 1);
  CHECK(totient_bound(60) == 16);
  CHECK(totient_bound(97) == 96);
  CHECK(totient_bound(1000003) == 1000002);
  CHECK(totient_bound(cln::cl_I(1) << 50) >= std::exp2(49));
}
