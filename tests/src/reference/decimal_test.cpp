// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/decimal.hpp"

#include <cstdlib>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using namespace magicmass::reference;
using cln::cl_RA;

TEST_CASE("decimals by hand", "[exam]") {
  CHECK(to_decimal(cl_RA(1) / 3, 5) == "0.33333");
  CHECK(to_decimal(cl_RA(-2) / 3, 5) == "-0.66667");
  CHECK(to_decimal(cl_RA(1), 4) == "1.000");
  CHECK(to_decimal(cl_RA(1), 1) == "1");
  CHECK(to_decimal(cl_RA(9999), 3) == "1.00e4");
  CHECK(to_decimal(cl_RA(9996) / 10, 3) == "1.00e3");
  CHECK(to_decimal(cl_RA(99949) / 100, 3) == "999");
  CHECK(to_decimal(cl_RA(1234), 6) == "1234.00");
  CHECK(to_decimal(cl_RA(12), 1) == "1e1");
  CHECK(to_decimal(parse_rational("1/100000"), 2) == "0.000010");
  CHECK(to_decimal(parse_rational("1/1000000"), 2) == "1.0e-6");
  CHECK(to_decimal(cl_RA(0), 7) == "0");
  CHECK_THROWS_AS(to_decimal(cl_RA(1), 0), InvalidInput);
}

TEST_CASE("decimal ties go to even", "[exam]") {
  CHECK(to_decimal(cl_RA(1) / 8, 2) == "0.12");
  CHECK(to_decimal(cl_RA(3) / 8, 2) == "0.38");
  CHECK(to_decimal(parse_rational("1250000000000000000000001/10000000000000000000000000"), 2) ==
        "0.13");
  CHECK(to_decimal(cl_RA(995) / 1000, 2) == "1.0");
}

TEST_CASE("seventeen digits bring every double back", "[check]") {
  testing::Generator generator(14);
  for (int i = 0; i < 5000; ++i) {
    const double x = testing::log_uniform(generator, 1e-300, 1e300);
    REQUIRE(std::strtod(to_decimal(exact(x), 17).c_str(), nullptr) == x);
  }
}
