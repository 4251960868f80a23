// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/evaluate.hpp"

#include <cmath>

#include <catch2/catch.hpp>
#include <cln/real.h>

#include "equality/constant.hpp"
#include "equality/parse.hpp"

using namespace magicmass::equality;

namespace {

std::string value(const std::string& typed, int digits = 30) {
  return shown(evaluate_to(parse(typed), digits + 30, exact_sign_or_nothing), digits);
}

}  // namespace

// Digits from published tables of constants.
TEST_CASE("values are enclosed", "[exam]") {
  CHECK(value("sqrt(2)") == "1.41421356237309504880168872421");
  CHECK(value("pi") == "3.14159265358979323846264338328");
  CHECK(value("exp(1)") == "2.71828182845904523536028747135");
  CHECK(value("log(2)") == "0.693147180559945309417232121458");
  CHECK(value("cbrt(-2)") == "-1.25992104989487316476721060728");
  CHECK(value("sin(1)", 20) == "0.84147098480789650665");
  CHECK(value("acos(0)", 20) == "1.5707963267948966192");
  CHECK(value("asin(1)", 20) == "1.5707963267948966192");
  CHECK(value("atan(1)", 20) == "0.78539816339744830962");
  CHECK(value("atan(sqrt(2)*10^200)", 20) ==
        "1.5707963267948966192");  // pi/2, though of sqrt(2) 10^200 no unit is known
  CHECK(value("10^30", 10) == "1.000000000e30");
}

TEST_CASE("the arctangent of a ball encloses those of its ends", "[exam]") {
  const BallArithmetic arithmetic(30);
  const auto at = [&](double x) { return cln::cl_float(x, cln::float_format(30)); };
  for (const double middle : {-40.0, -1.5, 0.0, 0.5, 1.25, 3.0, 10.0, 1e6, 1e300})
    for (const double part : {1e-3, 0.4, 0.49, 0.51, 2.0}) {
      const double radius = part * (middle == 0 ? 1 : std::fabs(middle));
      const Ball angle = arithmetic.arctangent({at(middle), at(radius)});
      for (const double end : {middle - radius, middle + radius}) {
        INFO(middle << " +- " << radius);
        const cln::cl_F there = cln::cl_float(cln::atan(at(end)), cln::float_format(30));
        CHECK(cln::abs(angle.middle - there) <= angle.radius);
      }
    }
}

TEST_CASE("digits that are not certain are not shown", "[exam]") {
  const BallArithmetic arithmetic(30);
  const Ball third = arithmetic.number(cln::cl_RA(1) / 3);
  CHECK(shown(third, 300).size() < 45);
}

TEST_CASE("what is not defined is known not to be", "[exam]") {
  const auto isolated = [](const std::string& typed) {
    try {
      evaluate_to(parse(typed), 60, exact_sign_or_nothing);
    } catch (const NotDefined& error) {
      return error.isolated ? "isolated" : "open";
    }
    return "defined";
  };
  CHECK(isolated("1/(sqrt(8)-2*sqrt(2))") == std::string("isolated"));
  CHECK(isolated("tan(pi/2)") == std::string("isolated"));
  CHECK(isolated("log(sin(pi))") == std::string("isolated"));
  CHECK(isolated("sqrt(-2)") == std::string("open"));
  CHECK(isolated("sqrt(sqrt(2)-3/2)") == std::string("open"));
  CHECK(isolated("acos(sqrt(2))") == std::string("open"));
  CHECK(isolated("log(-1)") == std::string("open"));
  CHECK(isolated("(-8)^(1/3)") == std::string("open"));
  CHECK(isolated("sqrt(sqrt(8)-2*sqrt(2))") == std::string("defined"));
  CHECK(isolated("acos(sqrt(2)*sin(pi/4))") == std::string("defined"));
}

TEST_CASE("signs of constants are exact", "[exam]") {
  const auto sign = [](const std::string& typed) { return exact_sign_or_nothing(parse(typed)); };
  CHECK(sign("sqrt(5+2*sqrt(6))-sqrt(2)-sqrt(3)") == 0);
  CHECK(sign("sqrt(5+2*sqrt(6))-sqrt(2)-sqrt(3)-10^-300") == -1);
  CHECK(sign("4*atan(1/5)-atan(1/239)-pi/4") == 0);
  CHECK(sign("4*atan(1/5)-atan(1/240)-pi/4") == 1);
  CHECK(sign("atan(1)+atan(2)+atan(3)") == 1);  // pi: their tangent is 0 all the same
  CHECK(sign("atan(1)+atan(2)+atan(3)-pi") == 0);
  CHECK(sign("acos(-1)-pi") == 0);
  CHECK(sign("asin(3/5)/2-atan(1/3)") == 0);
  CHECK(sign("pi*(1+sqrt(2))-pi-sqrt(2)*pi") == 0);
  CHECK(sign("pi^2-9.8696044") == 1);
  CHECK(sign("log(8)-3*log(2)") == 0);
  CHECK(sign("log(8)-3*log(2)+atan(1)") == std::nullopt);
  CHECK(sign("cos(2*atan(1/2))-3/5") == 0);
  CHECK(sign("cos(acos(1/3)/2)-sqrt(2/3)") == 0);
  CHECK(sign("sin(1)^2+cos(1)^2-1") == std::nullopt);
}
