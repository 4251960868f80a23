// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/portable_random.hpp"

#include <catch2/catch.hpp>

using magicmass::report::PortableRandom;

TEST_CASE("the stream is SplitMix64's, as published with it", "[exam]") {
  PortableRandom random(1234567);
  CHECK(random.next() == 6457827717110365317U);
  CHECK(random.next() == 3203168211198807973U);
  CHECK(random.next() == 9817491932198370423U);
}

TEST_CASE("what is drawn stays in its range and reaches its ends", "[exam]") {
  PortableRandom random(1);
  bool low = false, high = false, one_bit = false, many_bits = false;
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t n = random.whole(3, 9);
    REQUIRE(n >= 3);
    REQUIRE(n <= 9);
    low = low || n == 3;
    high = high || n == 9;
    const std::int64_t m = random.log_whole(1000000);
    REQUIRE(m >= 1);
    REQUIRE(m <= 1000000);
    one_bit = one_bit || m == 1;
    many_bits = many_bits || m > 900000;
    const double x = random.log_uniform(1e-300, 1e-30);
    REQUIRE(x >= 1e-300);
    REQUIRE(x <= 1e-30);
    const double y = random.ordinal(5e-324, 1.0);
    REQUIRE(y >= 5e-324);
    REQUIRE(y <= 1.0);
  }
  CHECK((low && high && one_bit && many_bits));
}

TEST_CASE("a log-uniform number has each decade as often as the next", "[exam]") {
  PortableRandom random(2);
  int below = 0;
  for (int i = 0; i < 10000; ++i) below += random.log_uniform(1e-10, 1e10) < 1.0 ? 1 : 0;
  CHECK(below > 4800);  // binomial: 4 standard deviations are 200
  CHECK(below < 5200);
}
