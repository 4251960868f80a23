// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/typed_text.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "equality/parse.hpp"
#include "equality/tokens.hpp"

using namespace magicmass::equality;
using Catch::Contains;

namespace {

std::string read(const std::string& typed) { return to_text(parse(plain_text(typed))); }

}  // namespace

TEST_CASE("LaTeX is read as what it shows", "[exam]") {
  CHECK(read(R"(\frac{a}{b})") == "a/b");
  CHECK(read(R"(\frac12 x)") == "x/2");
  CHECK(read(R"(\dfrac{1}{1+\alpha}V)") == "1/(alpha + 1)*V");
  CHECK(read(R"(\sqrt{2+\alpha})") == "sqrt(alpha + 2)");
  CHECK(read(R"(\sqrt[3]{x})") == "cbrt(x)");
  CHECK(read(R"($\cos^2\theta$)") == "cos(theta)^2");
  CHECK(read(R"(\left(1+\alpha\right)\cdot V)") == "(alpha + 1)*V");
  CHECK(read(R"(c'_{n})") == "c_prime_n");
  CHECK(read(R"(V_{\rm CM})") == "V_CM");
  CHECK(read(R"(\arctan\sqrt{\frac{m}{M_A}})") == "atan(sqrt(m/M_A))");
  CHECK(read(R"(2\alpha\,\sin\psi)") == "2*alpha*sin(psi)");
  CHECK(read("½x") == "x/2");
}

TEST_CASE("what people type without LaTeX stays as it is", "[exam]") {
  CHECK(read("2alpha") == "2*alpha");
  CHECK(read("αV") == "alpha*V");
  CHECK(read("√(2+α)") == "sqrt(alpha + 2)");
  CHECK(read("a^2 − b²") == "a^2 - b^2");
  CHECK(read("cosψ sinψ") == "cos(psi)*sin(psi)");
}

TEST_CASE("LaTeX that cannot be read is refused by name", "[exam]") {
  CHECK_THROWS_WITH(plain_text(R"(\foo{x})"), Contains("unknown command \\foo"));
  CHECK_THROWS_WITH(plain_text(R"(\frac{a)"), Contains("the } for a { is missing"));
  CHECK_THROWS_WITH(plain_text("a}"), Contains("} without {"));
  CHECK_THROWS_WITH(plain_text(R"(\frac)"), Contains("an argument is missing"));
  CHECK_THROWS_WITH(plain_text("x\\"), Contains("a backslash at the end"));
  CHECK_THROWS_AS(plain_text(std::string(300, '{')), NotAnExpression);
  CHECK_THROWS_AS(plain_text(std::string(30000, 'x')), NotAnExpression);
}

TEST_CASE("a matrix may be typed in several ways", "[exam]") {
  using Entries = std::vector<std::vector<std::string>>;
  const Entries plain{{"a", " b"}, {" c", " d"}};
  CHECK(matrix_entries("a, b; c, d") == plain);
  CHECK(matrix_entries("[[a, b], [c, d]]") == Entries{{"a", " b"}, {"c", " d"}});
  CHECK(matrix_entries("[[f(a, b)], [c]]").size() == 2);
  const Entries latex =
      matrix_entries(R"(\begin{pmatrix} \frac{1}{2} & 0 \\ 0 & \alpha \end{pmatrix})");
  REQUIRE(latex.size() == 2);
  CHECK(to_text(parse(latex[0][0])) == "1/2");
  CHECK(to_text(parse(latex[1][1])) == "alpha");
  CHECK_THROWS_WITH(matrix_entries("[[a, b], [c]]"), Contains("row 2 has 1 entries, row 1 has 2"));
  CHECK_THROWS_AS(matrix_entries(""), NotAnExpression);
  CHECK_THROWS_AS(matrix_entries("[[a, b], c]"), NotAnExpression);
}
