// SPDX-License-Identifier: GPL-2.0-or-later
// Verdicts on pairs that fell elsewhere, each family with a wrong neighbour.
#include "equality/decide.hpp"

#include <array>
#include <fstream>
#include <sstream>

#include "catch.hpp"
#include "equality/constant.hpp"

using namespace equality;

namespace {
/// Left, right, domain, verdict.
using Pair = std::array<std::string, 4>;
std::vector<Pair> pairs_of(const std::string& file) {
  std::ifstream in(std::string(MAGICMASS_TEST_FOLDER) + "/" + file);
  std::vector<Pair> out;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    for (std::string& field : out.emplace_back()) std::getline(fields, field, '\t');
  }
  return out;
}
Verdict verdict_of(const std::string& left, const std::string& right, const std::string& domain) {
  const Expr l = notation::read_typed(left).term;
  const Expr r = notation::read_typed(right).term;
  std::vector<std::string> unused;
  return decide(l, r, read_domain(domain, notation::symbols_of(eq(l, r)), unused));
}
std::string word_of(const std::string& left, const std::string& right, const std::string& domain) {
  try {
    return word(verdict_of(left, right, domain).answer);
  } catch (const kernel::Refused&) {
    return "no point";
  }
}
}  // namespace

TEST_CASE("Pairs have the verdict that mathematics gives them, on either side") {
  const std::vector<Pair> all = pairs_of("pairs.tsv");
  REQUIRE(all.size() > 60);
  for (const auto& [left, right, domain, verdict] : all) {
    CAPTURE(left, right, domain);
    CHECK(word_of(left, right, domain) == verdict);
    CHECK(word_of(right, left, domain) == verdict);
  }
}

TEST_CASE("A counterexample says by how little its sides are apart") {
  const Verdict close = verdict_of("x+10^-400", "x", "");
  REQUIRE(close.counterexample);
  CHECK(close.counterexample->difference == "1.000000000000000e-400");
}

TEST_CASE("Where the domains differ, a point is named; conditions say where both have a value") {
  const Verdict v = verdict_of("(x^3-1)/(x-1)", "x^2+x+1", "");
  CHECK(v.answer == Answer::Equal);
  CHECK(v.notes ==
        std::vector<std::string>{"the left side alone has no value at x = 1: division by zero"});
  CHECK(v.conditions == std::vector<std::string>{"x - 1 != 0"});
  CHECK(v.theorem == "x - 1 != 0 |- (x^3 - 1)/(x - 1) = x^2 + x + 1");
  CHECK(verdict_of("1/(1+alpha)", "1/(1+alpha)", "").conditions.empty());
  CHECK(verdict_of("0^n", "0", "n >= 0").conditions == std::vector<std::string>{"n > 0"});
  CHECK(verdict_of("(y-y)^x", "0", "").conditions == std::vector<std::string>{"x > 0"});
  CHECK(verdict_of("1/(2-x)", "1/(2-x)", "0 <= x <= 2").conditions ==
        std::vector<std::string>{"2 - x != 0"});
}

TEST_CASE("What is algebraic has a theorem of the kernel, what is not has none") {
  const auto [left, right, theorem] = GENERATE(table<std::string, std::string, std::string>({
      {"1/sqrt(2)", "sqrt(2)/2", "sqrt(2) != 0 |- 1/sqrt(2) = sqrt(2)/2"},
      {"sqrt(x)^2", "x", "x >= 0 |- sqrt(x)^2 = x"},
      {"(1+a)^1000/(1+a)^1001", "1/(1+a)", "1 + a != 0 |- (1 + a)^1000/(1 + a)^1001 = 1/(1 + a)"},
      {"sqrt(x^2)", "abs(x)", ""},
  }));
  CHECK(verdict_of(left, right, "").theorem == theorem);
}

TEST_CASE("Domains: what is usual, what is said, what is absent or empty") {
  std::vector<std::string> unused;
  const auto said = [&](const std::string& text, const std::set<std::string>& symbols) {
    return texts(read_domain(text, symbols, unused));
  };
  CHECK(said("", {"alpha", "n"}) == std::vector<std::string>{"alpha > 0", "n integer, n >= 1"});
  CHECK(said("alpha <= 1", {"alpha"}) == std::vector<std::string>{"0 < alpha <= 1"});
  CHECK(said("alpha real", {"alpha"}) == std::vector<std::string>{"alpha real"});
  CHECK(said("x < 2, x < 1", {"x"}) == std::vector<std::string>{"x < 1"});
  CHECK(said("e = 1", {"e"}) == std::vector<std::string>{"e = 1"});
  CHECK(said("2^3 > x, x <= 2^3", {"x"}) == std::vector<std::string>{"x < 8"});
  CHECK(unused.empty());
  said("beta > 0", {"alpha"});
  CHECK(unused == std::vector<std::string>{"\"beta > 0\": beta is in neither expression"});
  CHECK_THROWS_WITH(said("x < 0, x > 0", {"x"}), ContainsSubstring("no value of x satisfies"));
  CHECK_THROWS_WITH(said("n > 1, n < 2", {"n"}), ContainsSubstring("no value of n satisfies"));
  CHECK_THROWS_WITH(said("x > 0,", {"x"}), ContainsSubstring("an empty condition"));
  CHECK_THROWS_WITH(said("x > 1 or x > 2", {"x"}), ContainsSubstring("must hold together"));
  CHECK_THROWS_WITH(said("y < 0, x < y, x > 0", {"x"}), ContainsSubstring("no value of x"));
}

TEST_CASE("Signs of constants are exact, or not known") {
  const auto sign = [](const std::string& typed) {
    return exact_sign(notation::read_typed(typed).term);
  };
  CHECK(sign("sqrt(2)+sqrt(3)-sqrt(5+2*sqrt(6))") == 0);
  CHECK(sign("sqrt(2)+sqrt(3)-sqrt(5+2*sqrt(6))+10^-90") == 1);
  CHECK(sign("sqrt(2)+sqrt(3)-sqrt(5+2*sqrt(6))-10^-90") == -1);
  CHECK(sign("log(6)-log(2)-log(3)") == 0);
  CHECK(sign("exp(1)*exp(-1)-1") == 0);
  CHECK(sign("log(6)-log(2)-log(3)+10^-60") == 1);
  CHECK(sign("asin(sin(2))+2-pi") == std::nullopt);
  CHECK_THROWS_AS(sign("1/(sqrt(8)-2*sqrt(2))"), NotDefined);
  CHECK_THROWS_AS(sign("sqrt(2-sqrt(5))"), NotDefined);
}
