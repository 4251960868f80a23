// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/formula.hpp"

#include <catch2/catch.hpp>

#include "whole_derivation.hpp"

using namespace magicmass;
using namespace magicmass::render;
using Kind = Formula::Kind;

TEST_CASE("every side of the derivation is read, and written back as it was", "[exam][shared]") {
  for (const proof::Theorem& theorem : whole_derivation().theorems) {
    const proof::Step& step = theorem.step();
    INFO(step.id);
    for (const std::string& side : {step.from, step.to}) {
      const auto read = read_formula(side);
      if (read)
        CHECK(source(*read) == side);
      else
        CHECK(step.statement.find(side) ==
              std::string::npos);  // words instead of what the kernel has
    }
    const auto statement = read_relation(step.statement);
    CHECK(statement.has_value());
    if (statement) CHECK(source(*statement) == step.statement);
  }
}

TEST_CASE("notation that no chapter has yet is read too", "[exam]") {
  for (const char* text : {"e^n",
                           "e^(n/2)",
                           "e^(-n)",
                           "(-1)^k*factorial(n)/(factorial(2*k)*factorial(n - 2*k))",
                           "sum(k, 0, floor(n/2), binomial(n, 2*k)*x^k)",
                           "Lambda_e",
                           "mu_A*c'(n)^2",
                           "sqrt(alpha)^3",
                           "O(alpha^(3/2))",
                           "|a_t|",
                           "((1 + e)/2)^n",
                           "lim(psi/alpha, alpha, 0)",
                           "[[e, 0], [0, 1]]",
                           "lambda_2(-theta) P_3",
                           "(Gamma_A Gamma_B)^n",
                           "cosh(eta)",
                           "sum((-1)^k'*sin(x)^(2*k'), 0, floor(n/2))",
                           "lim(v_A(n), n)",
                           "v_A(n; 1/2, 1, e)",
                           "h(1/2, e)",
                           "v_C'(n)",
                           "(sqrt(M_1), sqrt(M_2)) . (w_1', w_2')",
                           "n.w' - n.w",
                           "(n.w' - n.w)*n_1",
                           "d_A . n_B",
                           "n_A x n_B",
                           "(1 - 2 n n^T) [[sqrt(M_1)*u_1], [sqrt(M_2)*u_2]]",
                           "((1 - 2 n n^T) w)_1",
                           "(R R^T)_11",
                           "|(1 - 2 n n^T) w|^2",
                           "[[e_i . e_j]]",
                           "tr lambda_n",
                           "|e'_3|^2",
                           "[[e_i . e'_j]]",
                           "Gamma_A (d_B n_B)",
                           "cos(phi)*(x x^T + y y^T) + sin(phi)*(y x^T - x y^T) + z z^T",
                           "lambda(phi)^T lambda(phi)",
                           "[[sqrt(M)], [sqrt(alpha*M)]]/sqrt(2*M + alpha*M)",
                           "cosh(eta)",
                           "t(j + 1) - t(j)",
                           "0.5*x"}) {
    INFO(text);
    const auto read = read_formula(text);
    REQUIRE(read.has_value());
    CHECK(source(*read) == text);
  }
  for (const char* text : {"0 < psi < pi", "a <= b", "x != 0", "e >= 1/2", "a_t <= c_t <= b_t"}) {
    const auto read = read_relation(text);
    REQUIRE(read.has_value());
    CHECK(source(*read) == text);
  }
}

TEST_CASE("the tree is what the text says", "[exam]") {
  const Formula quotient = formula("-2*alpha*c'(n - 1)/(1 + alpha)");
  REQUIRE(quotient.kind == Kind::negative);
  REQUIRE(quotient.parts[0].kind == Kind::quotient);
  CHECK(quotient.parts[0].parts[0].kind == Kind::product);
  CHECK(quotient.parts[0].parts[0].parts[2].text == "c'");
  CHECK(formula("a/b/c") == formula("(a/b)/c"));
  CHECK(formula("a*b^2") != formula("(a*b)^2"));
  const Formula column = formula("[[a(n)], [b(n)]]");
  CHECK((column.kind == Kind::matrix && column.columns == 1 && column.parts.size() == 2));
  CHECK(is_element(formula("T(2*m + 1)")));
  CHECK(is_element(formula("a(N_A)")));
  CHECK_FALSE(is_element(formula("lambda_3(psi)")));
  CHECK_FALSE(is_element(formula("cos(n)")));
  CHECK_FALSE(is_element(formula("b_t(alpha_k)")));
}

TEST_CASE("what is no formula stays as it is, and nothing that is typed breaks the reader",
          "[exam]") {
  for (const std::string& text :
       {std::string("the objects do not pass"), std::string("a +"), std::string("[[a, b], [c]]"),
        std::string(""), std::string("x)"), std::string("(x"), std::string("a ** b"),
        std::string("\0", 1), std::string("α + 1"), std::string(100000, '('),
        std::string(100000, '-'), std::string("a = b")}) {
    CHECK_FALSE(read_formula(text).has_value());
    CHECK(formula(text).kind == Kind::verbatim);
    CHECK(source(formula(text)) == text);
  }
  CHECK_FALSE(read_relation("a(n)").has_value());
  std::string tower = "x";
  for (int i = 0; i < 100000; ++i) tower += "^x";
  CHECK_FALSE(read_formula(tower).has_value());
}
