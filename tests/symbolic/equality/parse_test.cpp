// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/parse.hpp"

#include <string>

#include <catch2/catch.hpp>

using namespace magicmass::equality;

namespace {

std::string read(const std::string& typed) { return to_text(parse(typed)); }

}  // namespace

TEST_CASE("what people type is read as they mean it", "[exam]") {
  CHECK(read("1/3+1/6") == "1/2");
  CHECK(read("0.1") == "1/10");
  CHECK(read("1.5E-3") == "3/2000");
  CHECK(read("-2^2") == "-4");
  CHECK(read("2^3^2") == "512");
  CHECK(read("2^-3") == "1/8");
  CHECK(read("x**2") == read("x^2"));
  CHECK(read("2(2 + alpha)") == "2*(alpha + 2)");
  CHECK(read("alpha/(2(2+alpha))") == "alpha/(2*(alpha + 2))");
  CHECK(read("4+2 alpha") == "2*alpha + 4");
  CHECK(read("x - -1") == "x + 1");
  CHECK(read("sin^2(x)") == read("sin(x)^2"));
  CHECK(read("2 atan sqrt(alpha)") == read("2*atan(sqrt(alpha))"));
  CHECK(read("arcsin(x)") == "asin(x)");
  CHECK(read("x^2/2 - 1/2*x") == "x^2/2 - x/2");
  CHECK(read("1 - 2e") == read("1 - 2*e"));
}

TEST_CASE("pasted signs are understood", "[exam]") {
  CHECK(read("√(α·(2+α))") == read("sqrt(alpha*(2+alpha))"));
  CHECK(read("√2") == "sqrt(2)");
  CHECK(read("2π − 1") == read("2*pi-1"));
  CHECK(read("ψ²×3") == read("psi^2*3"));
  CHECK(read("x⁻²") == read("x^(-2)"));
  CHECK(read("α_k") == "alpha_k");
  CHECK(read("c'_n") == "c_prime_n");
  CHECK(read("∛8") == read("cbrt(8)"));
}

TEST_CASE("a refusal names the column and the reason", "[exam]") {
  using Catch::Contains;
  CHECK_THROWS_WITH(parse("1 + foo(2)"), Contains("column 5: unknown function foo"));
  CHECK_THROWS_WITH(parse("(1+2"), Contains("column 1: the ) for this ( is missing"));
  CHECK_THROWS_WITH(parse("1+2)"), Contains("column 4: a ( is missing"));
  CHECK_THROWS_WITH(parse("2+"), Contains("column 3: the expression ends too early"));
  CHECK_THROWS_WITH(parse("2 3"), Contains("column 3: an operator is missing"));
  CHECK(read("sin x cos y") == "sin(x)*cos(y)");
  CHECK_THROWS_WITH(parse("sin x y"), Contains("column 7: does y belong to what sin is taken of?"));
  CHECK_THROWS_WITH(parse("sin 2x"), Contains("column 5: a ( is missing after sin"));
  CHECK_THROWS_WITH(parse("x = 1"), Contains("without ="));
  CHECK_THROWS_WITH(parse("0,5"), Contains("decimals are written 0.5"));
  CHECK_THROWS_WITH(parse("a(n)"), Contains("write a_n"));
  CHECK_THROWS_WITH(parse("x $ 2"), Contains("column 3: unexpected character $"));
  CHECK_THROWS_WITH(parse(std::string("x\0", 2)), Contains("U+0000"));
  CHECK_THROWS_WITH(parse("x\xff"), Contains("column 2: not valid UTF-8"));
  CHECK_THROWS_WITH(parse("\xc0\xaf"), Contains("not valid UTF-8"));
  CHECK_THROWS_WITH(parse("\xed\xa0\x80"), Contains("not valid UTF-8"));
  CHECK_THROWS_WITH(parse(""), Contains("empty"));
  CHECK_THROWS_WITH(parse("  "), Contains("empty"));
}

TEST_CASE("what has two readings is refused", "[exam]") {
  CHECK_THROWS_AS(parse("1/2 alpha"), NotAnExpression);
  CHECK_THROWS_AS(parse("1/2(1+alpha)"), NotAnExpression);
  CHECK_THROWS_AS(parse("e^2-2e+1"), NotAnExpression);  // 2 e + 1, not 20
  CHECK_THROWS_AS(parse("sin^-1(x)"), NotAnExpression);
}

TEST_CASE("sizes are known before anything is computed", "[exam]") {
  for (const char* large :
       {"9^9^9^9", "2^(10^9)", "(1+alpha)^100000", "10^-99999999", "1E999999", "(9^9999)^9999",
        "9^9999*9^9999*9^9999*9^9999", "alpha^(1/99999)", "root(2, 101)"})
    CHECK_THROWS_AS(parse(large), NotAnExpression);
  CHECK_THROWS_WITH(parse("0^0"), Catch::Contains("0^0"));
  CHECK_THROWS_WITH(parse("1/0"), Catch::Contains("division by zero"));
  CHECK_THROWS_WITH(parse("1/(1/2-0.5)"), Catch::Contains("division by zero"));
  CHECK_THROWS_WITH(parse("0^-1"), Catch::Contains("division by zero"));
  CHECK_THROWS_WITH(parse(std::string(1000, '(')), Catch::Contains("nested"));
  CHECK_THROWS_WITH(parse(std::string(30000, '1')), Catch::Contains("longer than 20000"));
  std::string deep = "2";
  for (int i = 0; i < 1000; ++i) deep = "sqrt(" + deep + ")";
  CHECK_THROWS_WITH(parse(deep), Catch::Contains("nested"));
  CHECK(to_text(parse(std::string(15000, '-') + "1")) == "1");
}

TEST_CASE("what is printed reads back", "[exam]") {
  for (const char* typed :
       {"(x+1)*(x-1)/(2*x)", "-x^2", "(-x)^2", "x^(n+1)", "2^(1/2)", "(1/2)^n", "1 - e", "-(x+y)",
        "x/(y/z)", "x/y/z", "sqrt(x)^3", "root(x, 5)", "(x^2)^3", "-3*x", "-x*y"}) {
    INFO(typed << " printed as " << read(typed));
    CHECK(read(read(typed)) == read(typed));
  }
}
