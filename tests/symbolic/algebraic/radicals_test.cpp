// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/radicals.hpp"

#include <numeric>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "algebraic/constant.hpp"
#include "magicmass/errors.hpp"

using namespace magicmass::algebraic;

namespace {

/// The text, read back by GiNaC's own parser.
GiNaC::ex read(const std::string& text) {
  GiNaC::parser reader;
  return reader(text);
}

bool is_power_of_two(long n) { return n > 0 && (n & (n - 1)) == 0; }

}  // namespace

TEST_CASE("ratios as a textbook writes them", "[exam]") {
  CHECK(magic_radicals(1) == "1");
  CHECK(magic_radicals(2) == "sqrt(5) - 2");
  CHECK(magic_radicals(7) == "1 + sqrt(15 - 6*sqrt(5)) - sqrt(5)");
  CHECK(deficient_radicals(1) == "sqrt(2) - 1");
  CHECK(deficient_radicals(2) == "2/sqrt(3) - 1");
  CHECK(deficient_radicals(3) == "sqrt(4 - 2*sqrt(2)) - 1");
  CHECK(deficient_radicals(4) == "sqrt(2 - 2/sqrt(5)) - 1");
  CHECK(deficient_radicals(5) == "sqrt(6) - sqrt(2) - 1");
  CHECK(deficient_radicals(7) == "2/sqrt(2 + sqrt(2 + sqrt(2))) - 1");
  CHECK(deficient_radicals(14) == "sqrt(3) - sqrt(5 - 2*sqrt(5)) - 1");
}

TEST_CASE("radicals exist for the constructible polygons alone", "[exam]") {
  for (long n = 3; n <= 1000; ++n) {
    long totient = 0;
    for (long j = 1; j <= 2 * n; ++j) totient += std::gcd(j, 2 * n) == 1 ? 1 : 0;
    INFO(n);
    CHECK(real_radicals_exist(n) == is_power_of_two(totient / 2));
    if (!real_radicals_exist(n)) CHECK_FALSE(secant_radicals(n).has_value());
  }
  CHECK_FALSE(magic_radicals(3).has_value());  // the heptagon's cubic: casus irreducibilis
  CHECK_THROWS_AS(secant_radicals(2), magicmass::InvalidInput);
  for (const long n : {-4L, 0L, 2L})
    CHECK_THROWS_AS(real_radicals_exist(n), magicmass::InvalidInput);
}

TEST_CASE("radicals, read back, are the ratios", "[exam]") {
  int found = 0;
  for (long n = 3; n <= 260; ++n) {
    const auto radicals = secant_radicals(n);
    if (!radicals) continue;
    ++found;
    INFO(n << ": " << *radicals);
    CHECK(radicals->size() <= longest_radicals);
    const GiNaC::ex ratio = 1 / GiNaC::cos(GiNaC::Pi / n) - 1;
    CHECK(sign_of(read(*radicals) - ratio).sign == 0);
    CHECK(sign_of(read(*radicals) - ratio - GiNaC::numeric(10).power(-40)).sign == -1);
  }
  CHECK(found >= 20);
  CHECK(secant_radicals(17).has_value());
}
