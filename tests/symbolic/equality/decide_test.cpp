// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/decide.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "equality/bounded.hpp"

using namespace magicmass::equality;

namespace {

struct Pair {
  std::string lhs, rhs, domain = {};
};

Verdict verdict_on(const Pair& pair) {
  Question question{pair.lhs, pair.rhs, {}};
  if (!pair.domain.empty()) question.domain.push_back(pair.domain);
  return answer(question);
}

void check(Answer expected, const std::vector<Pair>& pairs) {
  for (const Pair& pair : pairs) {
    const Verdict verdict = verdict_on(pair);
    INFO(pair.lhs << " and " << pair.rhs << " on " << pair.domain << ": " << verdict.proof);
    CHECK(verdict.answer == expected);
    CHECK(verdict.counterexample.has_value() == (expected == Answer::different));
    CHECK_FALSE(verdict.proof.empty());
  }
}

}  // namespace

TEST_CASE("constants that are equal", "[exam]") {
  check(Answer::equal, {{"sec(pi/5)-1", "sqrt(5)-2"},
                        {"sec(pi/8)-1", "sqrt(4-2*sqrt(2))-1"},
                        {"sec(pi/12)-1", "sqrt(6)-sqrt(2)-1"},
                        {"cos(pi/7)+cos(3*pi/7)+cos(5*pi/7)", "1/2"},
                        {"sec(pi/7)-1", "tan(pi/7)*tan(pi/14)"},
                        {"sqrt(5+2*sqrt(6))", "sqrt(2)+sqrt(3)"},
                        {"4*atan(1/5)-atan(1/239)", "pi/4"},
                        {"cbrt(-8)", "-2"},
                        {"acos(1/3)+acos(-1/3)", "pi"},
                        {"2*asin(1/2)", "pi/3"},
                        {"sin(1)^2+cos(1)^2", "1"},
                        {"exp(2)*exp(-1)", "exp(1)"},
                        {"0.5", "1/2"}});
}

TEST_CASE("constants that are not equal, however close", "[exam]") {
  check(
      Answer::different,
      {{"sqrt(2)", "1.414213562373095048801688724209698078569671875"},
       {"sqrt(2)", "269812766699283348307203/190786436983767147107902"},  // a convergent
       {"sqrt(1+1E-45)", "1"},
       {"sqrt(1+10^-300)", "1"},
       {"pi", "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899"},
       {"exp(pi*sqrt(163))", "640320^3+744"},
       {"4*atan(1/5)-atan(1/239)", "pi/4+10^-60"},
       {"atan(1)+atan(2)+atan(3)", "0"},
       {"sqrt(5+2*sqrt(6))", "sqrt(2)-sqrt(3)"},
       {"asin(sin(2))", "2"}});
}

TEST_CASE("functions that are equal", "[exam]") {
  check(Answer::equal, {{"2*atan(sqrt(alpha*(2+alpha)))", "2*acos(1/(1+alpha))", "alpha>0"},
                        {"sqrt(alpha/(2(2+alpha)))", "sqrt(alpha)/sqrt(4+2 alpha)"},
                        {"psi", "4*atan(sqrt(alpha/(2+alpha)))"},
                        {"theta", "acos((1-alpha)/(1+alpha))"},
                        {"V_CM", "V/(2+alpha)"},
                        {"a_n", "2*V_CM*(1+alpha)*cos((n+1/2)*psi/2)*cos((n-1/2)*psi/2)"},
                        {"a_n + b_n + alpha*c_prime_n", "V"},
                        {"alpha_k", "tan(pi/(2*k+1))*tan(pi/(4*k+2))"},
                        {"cos(pi/5)*alpha", "(1+sqrt(5))/4*alpha"},
                        {"sin(x+pi/3)", "sin(x)/2+sqrt(3)/2*cos(x)"},
                        {"atan(alpha)+atan(1/alpha)", "pi/2"},
                        {"atan(x)+atan(1/x)", "-pi/2", "x<0"},
                        {"asin(x)+acos(x)", "pi/2", "-1<=x<=1"},
                        {"2*asin(sqrt(x))", "acos(1-2*x)", "0<=x<=1"},
                        {"asin(alpha/(1+alpha))", "acos(sqrt(1+2*alpha)/(1+alpha))"},
                        {"sin(n*pi)", "0"},
                        {"cos(n*pi)^2", "1"},
                        {"(-1)^n", "cos(n*pi)"},
                        {"sin(n*pi/2)^2", "(1-(-1)^n)/2"},
                        {"abs(x)", "sqrt(x^2)"},
                        {"sqrt(x^4)", "x^2"},
                        {"e^(n+1)", "e^n*e"},
                        {"(2*alpha)^n", "2^n*alpha^n"},
                        {"cbrt(alpha)*cbrt(alpha^2)", "alpha"},
                        {"sqrt(alpha+2*sqrt(alpha)+1)", "sqrt(alpha)+1"},
                        {"sqrt(1+sin(2*x))", "abs(sin(x)+cos(x))"},
                        {"sin(2*x)*log(x)", "2*sin(x)*cos(x)*log(x)", "x>0"},
                        {"sin(acos(1-2*x^2))^2", "1-cos(acos(1-2*x^2))^2", "-1<=x<=1"},
                        {"cos(2*n*acos(1/(1+alpha)))", "cos(n*psi)"},
                        {"sqrt(alpha_k/(2+alpha_k))", "tan(pi/(4*k+2))"},
                        {"exp(x+1)", "exp(x)*exp(1)"},
                        {"log(alpha^2)", "2*log(alpha)"}});
}

TEST_CASE("functions that differ at a point, or are not defined at the same points", "[exam]") {
  check(Answer::different, {{"sqrt(x^2)", "x"},
                            {"sqrt(alpha^2)", "alpha", "alpha real"},
                            {"(x^(1/2))^2", "x"},
                            {"sqrt(x)^2", "x"},
                            {"sqrt(x-1)*sqrt(x+1)", "sqrt(x^2-1)"},
                            {"asin(sin(x))", "x"},
                            {"acos(cos(x))", "x"},
                            {"atan(tan(x))", "x"},
                            {"atan(x)+atan(1/x)", "pi/2"},
                            {"sin(n*pi)", "0", "n real"},
                            {"cos(x*pi)^2", "1"},
                            {"(-1)^x", "cos(x*pi)"},
                            {"log(x^2)", "2*log(x)"},
                            {"x^(1/3)", "cbrt(x)"},
                            {"(sqrt(x^2)-x)/(sqrt(x^2)-x)", "1"},
                            {"sqrt(alpha+10^-50)", "sqrt(alpha)"},
                            {"x", "x+10^-400"},
                            {"atan(x)", "atan(x)+10^-200"},
                            {"sin(asin(x))", "x"},
                            {"n", "abs(n-1)+1", "n>=-2"}});
}

TEST_CASE("no name that can be typed has properties of its own", "[exam]") {
  check(Answer::different, {{"sqrt(constant_0^2)", "constant_0"},
                            {"sqrt(name_of_a_constant^2)+sqrt(5)*0", "name_of_a_constant"}});
  CHECK_THROWS_WITH(verdict_on({"sqrt(name_of_a_constant_or_power_that_nobody_typed_0^2)", "1"}),
                    Catch::Contains("more than 40 characters"));
}

TEST_CASE("proofs by derivative do not see through powers, and so do not use them", "[exam]") {
  check(Answer::different, {{"exp(x)", "1"},
                            {"alpha^n", "1"},
                            {"2^x+atan(x)", "atan(x)"},
                            {"log(alpha)", "0"},
                            {"log(alpha)+atan(x)", "atan(x)"}});
  check(Answer::undecided, {{"log(exp(x))+atan(x)", "atan(x)+x"}});
}

TEST_CASE("the counterexample is a simple point, with both values", "[exam]") {
  const Verdict verdict = verdict_on({"sqrt(alpha^2)", "alpha", "alpha real"});
  REQUIRE(verdict.counterexample);
  CHECK(verdict.counterexample->point.at("alpha") == "-1");
  CHECK(verdict.counterexample->left == "1");
  CHECK(verdict.counterexample->right == "-1");
  const Verdict undefined = verdict_on({"sqrt(x)^2", "x"});
  REQUIRE(undefined.counterexample);
  CHECK(undefined.counterexample->left.starts_with("not defined"));
}

TEST_CASE("zeros of denominators are conditions", "[exam]") {
  const auto conditions = [](const Pair& pair) {
    const Verdict verdict = verdict_on(pair);
    CHECK(verdict.answer == Answer::equal);
    std::string all;
    for (const std::string& condition : verdict.conditions) all += condition + "; ";
    return all;
  };
  CHECK(conditions({"(alpha^2-1)/(alpha-1)", "alpha+1"}) == "alpha - 1 != 0; ");
  CHECK(conditions({"x/x", "1"}) == "x != 0; ");
  CHECK(conditions({"(1-e^2)/(1-e)", "1+e"}) == "1 - e != 0; ");
  CHECK(conditions({"(1-e^2)/(1-e)", "1+e", "e<1"}).empty());
  CHECK(conditions({"tan(x)", "sin(x)/cos(x)"}) == "cos(x) != 0; ");
  CHECK(conditions({"sqrt(x)*sqrt(x)", "sqrt(x)^2"}) == "x >= 0; ");
  CHECK(conditions({"1/(1+1/alpha)", "alpha/(1+alpha)"}).empty());
}

TEST_CASE("what is not decided is said not to be, with the digits that agree", "[exam]") {
  for (const Pair& pair :
       std::vector<Pair>{{"acos(cos(x))", "x", "0<x<pi"}, {"log(exp(x))", "x"}}) {
    const Verdict verdict = verdict_on(pair);
    INFO(pair.lhs);
    CHECK(verdict.answer == Answer::undecided);
    CHECK(verdict.agreeing_digits > 60);
    CHECK(verdict.points > 0);
  }
}

TEST_CASE("questions without an answer are refused", "[exam]") {
  using Catch::Contains;
  CHECK_THROWS_WITH(verdict_on({"sqrt(-1)", "sqrt(-1)"}), Contains("left side has no value"));
  CHECK_THROWS_WITH(verdict_on({"1", "1/(sqrt(8)-2*sqrt(2))"}), Contains("right side"));
  CHECK_THROWS_WITH(verdict_on({"1/(x-x)", "1/(x-x)"}), Contains("both sides have a value"));
  CHECK_THROWS_WITH(verdict_on({"sqrt(-1-x^2)", "sqrt(-1-x^2)"}), Contains("both sides"));
  CHECK_THROWS_WITH(verdict_on({"x", "x", "x<y"}), Contains("in neither"));
  CHECK_THROWS_WITH(verdict_on({"x", "x", "x^2<0"}), Contains("no point of the domain"));
}

TEST_CASE("a misspelt name is a symbol, and that is said", "[exam]") {
  const Verdict verdict = verdict_on({"alhpa", "alpha"});
  CHECK(verdict.answer == Answer::different);
  CHECK(std::any_of(verdict.notes.begin(), verdict.notes.end(), [](const std::string& note) {
    return note.find("did you mean alpha") != std::string::npos;
  }));
}

TEST_CASE("poles are no counterexample where the sides agree between them", "[exam]") {
  const std::string product = "(n-1)*(n-2)*(n-3)";
  check(Answer::equal, {{"sin(4*pi*x)/(2*sin(2*pi*x))", "cos(2*pi*x)"},
                        {"cot(2*pi*x)*sin(2*pi*x)", "cos(2*pi*x)"},
                        {product + "/(" + product + ")", "1", "1 <= n <= 8"}});
  check(Answer::different, {{"1/(x-x)+x", "x"}, {"y*(sqrt(x^2)-x)/(sqrt(x^2)-x)", "y"}});
}

TEST_CASE("what is not known to be defined, or to be small, is not decided", "[exam]") {
  const std::string zero = "(exp(1)*exp(-1)-1)";
  check(Answer::undecided, {{"log" + zero + " - log" + zero + " + 1", "1"},
                            {"log" + zero + " - log" + zero + " + 1", "2"},
                            {"atan(1/" + zero + ") - atan(1/" + zero + ") + 1", "1"}});
  const std::string tiny = "(sqrt(2)+sqrt(3)-sqrt(5+2*sqrt(6)))";
  check(Answer::equal, {{"atan(10^90*" + tiny + ")", "0"}, {"atan(10^110*" + tiny + ")", "0"}});
  CHECK(verdict_on({"x+atan(10^150*" + tiny + ")", "x"}).answer != Answer::different);
}
