// SPDX-License-Identifier: GPL-2.0-or-later
// The mass ratio as somebody writes it.
#include "notation/alpha.hpp"

#include "catch.hpp"

using namespace notation;

TEST_CASE("decimals and hex floats are the nearest double, p/q is exact") {
  for (const auto& [words, value] : {std::pair{"0.1", 0.1},
                                     {"1e-9", 1e-9},
                                     {"0x1.8p-3", 0.1875},
                                     {".5", 0.5},
                                     {"017", 17},
                                     {"0x10", 16}})
    CHECK(std::get<double>(read_alpha(words)) == value);
  CHECK(std::get<double>(read_alpha("5e-324")) > 0);
  CHECK(std::get<cln::cl_RA>(read_alpha("02/14")) == cln::cl_RA("1/7"));
  const auto third = std::get<Threshold>(read_alpha("magic:3"));
  CHECK((third.is_magic && third.k == 3));
  CHECK_FALSE(std::get<Threshold>(read_alpha("deficient:1000000000000000000")).is_magic);
  for (std::string words : {"0.1", "1/7", "3/1", "magic:3", "deficient:2", "1e-09", "5e-324"})
    CHECK(text(read_alpha(words)) == words);
}

TEST_CASE("what is no positive finite number is refused") {
  for (const auto& [words, because] : std::vector<std::pair<std::string, std::string>>{
           {"", "not a number"},
           {"0.0e5", "positive finite"},
           {"-1/2", "positive finite"},
           {"0/5", "positive finite"},
           {"nan", "not a number"},
           {"0xinfp1", "not a number"},
           {"+1", "not a number"},
           {" 1", "not a number"},
           {"1 ", "not a number"},
           {"1,5", "not a number"},
           {"1e", "not a number"},
           {"\x1b[2J", "not a number: \"?[2J\""},
           {"1/0x3", "not a fraction"},
           {"1/2/3", "not a fraction"},
           {"1/-2", "not a fraction"},
           {"1/0", "divides by 0"},
           {"1e999999", "does not fit a double"},
           {"0x1p-2000", "does not fit a double"},
           {"1e-999999", "does not fit a double"},
           {"magic:1000000000000000001", "from 1 to 10^18"},
           {"magic:", "from 1 to 10^18"},
           {std::string(4097, '1'), "4097 characters long"}}) {
    INFO(words.substr(0, 50));
    CHECK_THROWS_WITH(read_alpha(words), ContainsSubstring(because));
  }
  CHECK(std::get<cln::cl_RA>(read_alpha("1/" + std::string(4094, '1'))) > 0);
}
