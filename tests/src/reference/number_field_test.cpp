// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/number_field.hpp"

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/reference/exact_line.hpp"
#include "magicmass/reference/exact_value.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"

using namespace magicmass;
using namespace magicmass::reference;

namespace {

ExactValue worth(const char* text) { return exact_value(parse_value(text)); }

std::string refusal_of(const char* text) {
  try {
    exact_line(parse_scene(text, "f.toml"));
  } catch (const InvalidInput& error) {
    const std::string what = error.what();
    return what.substr(0, what.find("; allowed"));
  }
  return "accepted";
}

}  // namespace

TEST_CASE("sqrt(5) - 2 is the second magic ratio, exactly", "[exam]") {
  const CommonField field = common_field({worth("magic:2")}, 12);
  const FieldNumber magic = in_field(worth("magic:2"), field);
  CHECK((magic + FieldNumber(2)) * (magic + FieldNumber(2)) == FieldNumber(5));
  CHECK(nearest_double(magic) == nearest_double(worth("sqrt(5)-2")));
  CHECK(magic.sign() == 1);
  CHECK((magic - magic).sign() == 0);
}

TEST_CASE("fields of cosines hold the ratios, and divide", "[check]") {
  for (std::int64_t k = 1; k < 12; ++k) {
    for (const Value& value : {Value(Magic{k}), Value(Deficient{k})}) {
      const ExactValue ratio = exact_value(value);
      const CommonField field = common_field({ratio}, 12);
      REQUIRE(field.exists);
      const FieldNumber alpha = in_field(ratio, field);
      const FieldNumber other = alpha * alpha - FieldNumber(3) * alpha + FieldNumber(1);
      CHECK(nearest_double(alpha) == nearest_double(ratio));
      CHECK(alpha / other * other == alpha);
      CHECK((FieldNumber(1) / alpha) * alpha == FieldNumber(1));
    }
  }
  CHECK(cosine_degree(5) == 2);
  CHECK(cosine_degree(7) == 3);
  CHECK(cosine_degree(9) == 3);
  CHECK_FALSE(common_field({worth("magic:1000")}, 12).exists);
  CHECK_FALSE(common_field({worth("sqrt(2)"), worth("sqrt(3)")}, 12).exists);
}

TEST_CASE("expressions are worth what they say", "[exam]") {
  CHECK(worth("100^6").rational == cln::cl_RA("1000000000000"));
  CHECK(worth("-(1/2 - 2)*4").rational == 6);
  CHECK(worth("(1+sqrt(5))*(1-sqrt(5))").rational == -4);
  CHECK(worth("1/(sqrt(5)+2)").rational == -2);
  CHECK(worth("sqrt(12)").root == 2);
  CHECK(worth("sqrt(49)").is_rational());
  CHECK(worth("0.1").rational == exact(0.1));
  CHECK_THROWS_AS(worth("1/(2-2)"), InvalidInput);
  CHECK_THROWS_AS(worth("sqrt(2)+sqrt(3)"), InvalidInput);
  CHECK_THROWS_AS(worth("10^999999"), InvalidInput);
}

TEST_CASE("scenes that make no sense are refused where they stand", "[exam]") {
  CHECK(refusal_of("alpha = 1\nV = 0") == "f.toml:2: V: got 0.0");
  CHECK(refusal_of("alpha = 1\nL = \"-1/2\"") == "f.toml:2: L: got -1/2");
  CHECK(refusal_of("masses = [1, -1, 1]") == "f.toml:1: masses: the mass of C is -1.0");
  CHECK(refusal_of("alpha = \"1-1\"") == "f.toml:1: alpha: alpha is not a number: \"1-1\"");
  CHECK(refusal_of("alpha = \"(1-1)\"") == "f.toml:1: alpha: the mass of C is (1-1)");
  CHECK(refusal_of("alpha = \"sqrt(2)+sqrt(3)\"") ==
        "f.toml:1: alpha: got \"sqrt(2)+sqrt(3)\": it has two different square roots");
  CHECK(refusal_of("alpha = 1\nrestitution = 0") == "f.toml:2: restitution: got 0.0");
  CHECK(refusal_of("alpha = 1\nrestitution = \"1.5\"") == "f.toml:2: restitution: got 1.5");
  CHECK(refusal_of("alpha = 1\npositions = [0, 2, 1]") ==
        "f.toml:2: positions: C at 2 is to the right of B at 1");
  CHECK(refusal_of("kind = \"wall\"\nmass_ratio = 4\npositions = [0, 2]\nwall = 1") ==
        "f.toml:4: wall: C at 2 is beyond the wall at 1");
  CHECK(refusal_of("kind = \"chain\"\nmasses = [1, 1]\npositions = [0, 1]\nleft_wall = \"1/2\"") ==
        "f.toml:4: left_wall: 1 at 0 is beyond the wall at 1/2");
  CHECK(refusal_of("alpha = 1\nV = \"sqrt(2)\"\nL = \"sqrt(3)\"") ==
        "f.toml:2: V: places, speeds and times have irrational parts of different kinds");
  CHECK(refusal_of("alpha = \"magic:1000000\"") == "accepted");
}
