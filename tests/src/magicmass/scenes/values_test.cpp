// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers as scenes write them.
#include <cmath>

#include "catch.hpp"
#include "magicmass/numbers/accurate.hpp"
#include "magicmass/scenes/trio.hpp"

using namespace magicmass::scenes;

TEST_CASE("values are kept as what they are", "[exam]") {
  const std::tuple<const char*, const char*, double> rows[] = {
      {"1/7", "1/7", 1.0 / 7},
      {"-1/4", "-1/4", -0.25},
      {"100^6", "1000000000000", 1e12},
      {"sqrt(5)-2", "-2+sqrt(5)", 0.2360679774997897},
      {"(sqrt(20)-4)/2", "-2+sqrt(5)", 0.2360679774997897},
      {"sqrt(9)", "3", 3},
      {"sqrt(1/2)", "1/2*sqrt(2)", 0.70710678118654757},
      {"-sqrt(8)", "-2*sqrt(2)", -2.8284271247461903},
      {"1/(1+sqrt(2))", "-1+sqrt(2)", 0.41421356237309503},
      {"2*(3-1/3)^2", "128/9", 128.0 / 9},
      {"0.5", "1/2", 0.5},
      {"-0.0", "0", 0},
      {"0x1.8p-3", "3/16", 0.1875},
      {"0x1.8", "3/2", 1.5},
      {"25e-2", "1/4", 0.25},
      {"0", "0", 0},
  };
  for (const auto& [text, exact, number] : rows) {
    INFO(text);
    const Value value = read_value(text);
    CHECK(value.text == text);
    REQUIRE(value.exact() != nullptr);
    CHECK(value.exact()->text() == exact);
    CHECK(value.to_double() == number);
  }
  CHECK(read_value("0.1").exact()->text() == "3602879701896397/36028797018963968");
  CHECK(read_value("magic:3").exact() == nullptr);
  CHECK_THAT(read_value("magic:2").to_double(), WithinULP(0.2360679774997897, 0));
  CHECK_THAT(read_value("deficient:1").to_double(), WithinULP(0.41421356237309503, 0));
  const std::string says = " does not fit a double; --exact may do";
  for (const std::string text : {"10^400", "1/10^400"})
    CHECK_THROWS_WITH(read_value(text).to_double(), text + says);
}

TEST_CASE("ratios of the paper in a quadratic field are exact, and are right", "[exam]") {
  for (const int k : {1, 2})
    for (const std::string name : {"magic:", "deficient:"}) {
      INFO(name << k);
      const Value value = read_value(name + std::to_string(k));
      REQUIRE(value.exact() != nullptr);
      const auto ratios = magicmass::accurate::ratios(k);
      CHECK(value.to_double() == (name == "magic:" ? ratios.magic : ratios.deficient));
      const bool is_magic = name == "magic:";
      const auto end = Trio::equal_blocks(value, 1).first_collisions();
      const auto& [A, C, B] = end.velocities;
      CHECK(end.collisions == 2 * k + (is_magic ? 0 : 1));
      CHECK((is_magic ? A == 0 && C == 0 && B == 1 : C == B));
    }
}

TEST_CASE("what is no value is refused", "[exam]") {
  const std::pair<const char*, const char*> rows[] = {
      {"", "expected"},
      {"1/0", "division by 0"},
      {"1/(2-2)", "division"},
      {"sqrt(1+sqrt(2))", "in a square root"},
      {"sqrt(-2)", "of a negative"},
      {"alpha", "not known"},
      {"x", "not a number"},
      {"pi", "only"},
      {"1 = 1", "only"},
      {"2^-1", "whole number"},
      {"9^9^9", "not expected"},
      {"inf", "not known"},
      {"1e999", "does not fit"},
      {"1e-999", "does not fit"},
      {"1.5.2", "not a number"},
      {"--1.5", "not a number"},
      {"0x", "not a number"},
      {"magic:x", "k must be"},
      {"magic:1125899906842625", "k above 2^50, for which there are counts alone"},
      {"deficient:1125899906842625", "k above 2^50, for which there are counts alone"},
      {"magic:9999999999999999999", "k must be"},
  };
  for (const auto& [text, part] : rows) {
    INFO(text);
    CHECK_THROWS_WITH(read_value(text), ContainsSubstring(part));
  }
  CHECK_NOTHROW(read_value("1/7 "));
  CHECK_NOTHROW(read_value("magic:1125899906842624"));
  CHECK_THROWS_WITH(read_value(std::string(5000, '1')), "5000 characters, at most 4096");
  CHECK_THROWS_WITH(value_of(INFINITY), "not a finite number");
}
