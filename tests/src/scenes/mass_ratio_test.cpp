// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/mass_ratio.hpp"

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/scene.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

std::string refusal_of(std::string_view text) {
  try {
    parse_mass_ratio(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

double parsed_double(std::string_view text) { return std::get<double>(parse_mass_ratio(text)); }

const std::string allowed =
    "; allowed: a decimal like 0.1 or 1e-9, a hex float like 0x1.8p-3, a fraction like 1/7, "
    "magic:k or deficient:k";

}  // namespace

TEST_CASE("decimals and hex floats are the nearest double", "[exam]") {
  CHECK(parsed_double("0.1") == 0.1);
  CHECK(parsed_double("1e+5") == 1e5);
  CHECK(parsed_double("1.") == 1.0);
  CHECK(parsed_double(".5") == 0.5);
  CHECK(parsed_double("0x1p-3") == 0.125);
  CHECK(parsed_double("0X.8P1") == 1.0);
  CHECK(parsed_double("0x1e") == 30.0);
  CHECK(parsed_double("0x1.1c7397cb68b7ep-18") == 0x1.1c7397cb68b7ep-18);
  // ties to even, just above a tie, and far past the last bit
  CHECK(parsed_double("0x1.00000000000008p0") == 1.0);
  CHECK(parsed_double("0x1.00000000000018p0") == 0x1.0000000000002p0);
  CHECK(parsed_double("0x1.0000000000000800000000000000000000001p0") == 0x1.0000000000001p0);
  CHECK(parsed_double("0x1.8p-1075") == std::numeric_limits<double>::denorm_min());
  CHECK(parsed_double("1.00000000000000011102230246251565404236316680908203125") == 1.0);
  CHECK(parsed_double("1.00000000000000011102230246251565404236316680908203126") ==
        0x1.0000000000001p0);
  CHECK(parsed_double("5e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(parsed_double("1.7976931348623157e308") == std::numeric_limits<double>::max());
  CHECK(parsed_double(std::string(4095, '0') + "7") == 7.0);
}

TEST_CASE("fractions, magic and deficient ratios keep what was written", "[exam]") {
  CHECK(std::get<Fraction>(parse_mass_ratio("1/7")) == Fraction{"1", "7"});
  CHECK(std::get<Fraction>(parse_mass_ratio("007/0014")) == Fraction{"7", "14"});
  CHECK(std::get<Magic>(parse_mass_ratio("magic:3")) == Magic{3});
  CHECK(std::get<Deficient>(parse_mass_ratio("deficient:9223372036854775807")) ==
        Deficient{std::numeric_limits<std::int64_t>::max()});
}

TEST_CASE("each bad mass ratio is refused with its own line", "[exam]") {
  const std::string positive = "alpha must be a positive finite number, got ";
  const std::string no_number = "alpha is not a number: \"";
  const std::string no_fraction = "alpha is not a fraction: \"";
  const std::string whole_parts =
      "\"; numerator and denominator must be whole decimal numbers, like 1/7";
  const std::string no_double = "alpha does not fit a double: ";
  const std::string range = "; doubles reach from 5e-324 to 1.8e308: write it as a fraction p/q";
  const std::string index = "k needs a whole number k from 1 to 9223372036854775807, got ";
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"", "alpha is empty" + allowed},
      {"-0.1", positive + "-0.1"},
      {"0", positive + "0"},
      {"-0", positive + "-0"},
      {"0.00e7", positive + "0.00e7"},
      {"0x0p3", positive + "0x0p3"},
      {"nan", positive + "nan"},
      {"inf", positive + "inf"},
      {"-Infinity", positive + "-Infinity"},
      {"0/5", positive + "0/5"},
      {"-1/7", positive + "-1/7"},
      {"1/-7", positive + "1/-7"},
      {"1/0", "alpha divides by zero: 1/0"},
      {"0/0", "alpha divides by zero: 0/0"},
      {"1/", no_fraction + "1/" + whole_parts},
      {"/7", no_fraction + "/7" + whole_parts},
      {"1/2/3", no_fraction + "1/2/3" + whole_parts},
      {"0.5/3", no_fraction + "0.5/3" + whole_parts},
      {"0x", no_number + "0x\"" + allowed},
      {"0x1p", no_number + "0x1p\"" + allowed},
      {"0x-1", no_number + "0x-1\"" + allowed},
      {"0xinf", no_number + "0xinf\"" + allowed},
      {"0x.", no_number + "0x.\"" + allowed},
      {"0x0x1", no_number + "0x0x1\"" + allowed},
      {"--1", no_number + "--1\"" + allowed},
      {"+1", no_number + "+1\"" + allowed},
      {"0.1x", no_number + "0.1x\"" + allowed},
      {"0.1 ", no_number + "0.1 \"" + allowed},
      {"0,1", no_number + "0,1\"" + allowed},
      {"1e", no_number + "1e\"" + allowed},
      {".", no_number + ".\"" + allowed},
      {"nan(1)", no_number + "nan(1)\"" + allowed},
      {"sqrt(5)-2", no_number + "sqrt(5)-2\"" + allowed},
      {std::string("1\0", 2), no_number + "1\\x00\"" + allowed},
      {"1\n2", no_number + "1\\x0a2\"" + allowed},
      {"1e400", no_double + "1e400" + range},
      {"1e-400", no_double + "1e-400" + range},
      {"0x1p1024", no_double + "0x1p1024" + range},
      {"0x1p-1075", no_double + "0x1p-1075" + range},
      {"1e99999999999999999999", no_double + "1e99999999999999999999" + range},
      {"magic:0", "magic:" + index + "magic:0"},
      {"magic:", "magic:" + index + "magic:"},
      {"magic:-1", "magic:" + index + "magic:-1"},
      {"magic:1.5", "magic:" + index + "magic:1.5"},
      {"deficient:0", "deficient:" + index + "deficient:0"},
      {"deficient:9223372036854775808", "deficient:" + index + "deficient:9223372036854775808"},
      {std::string(4097, '1'), "alpha is 4097 characters long; allowed: up to 4096"},
  };
  for (const auto& [text, message] : refused) {
    CHECK(refusal_of(text) == message);
  }
}

TEST_CASE("a mass ratio reads back from its text", "[check]") {
  for (const char* text : {"1/7", "magic:3", "deficient:2", "0.1", "5e-324"}) {
    CHECK(to_text(parse_mass_ratio(text)) == text);
  }
  testing::Generator generator(1);
  for (int i = 0; i < 10000; ++i) {
    const MassRatio alpha = testing::log_uniform(generator, 1e-300, 1e300);
    REQUIRE(parse_mass_ratio(to_text(alpha)) == alpha);
  }
}

namespace {

/// 1.000,5 as in German.
class Comma : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

void check_numbers() {
  CHECK(parsed_double("0.1") == 0.1);
  CHECK(parsed_double("12345.5") == 12345.5);
  CHECK(to_text(MassRatio(12345.5)) == "12345.5");
  const Scene scene =
      parse_scene("kind = \"three-body\"\nalpha = 0.125\nV = \"2.5\"\n", "scene");
  CHECK(to_text(*scene.alpha) == "0.125");
  CHECK(to_text(scene.V) == "2.5");
}

}  // namespace

TEST_CASE("the locale does not matter", "[exam]") {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  std::ostringstream stream;
  stream << 12345.5;
  CHECK(stream.str() == "12.345,5");  // what could go wrong
  check_numbers();
  std::locale::global(before);
  const std::string name = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
    WARN("skipped: C's own decimal comma needs the locale de_DE.UTF-8");
  check_numbers();
  std::setlocale(LC_ALL, name.c_str());
}
