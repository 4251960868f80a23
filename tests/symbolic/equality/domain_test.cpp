// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/domain.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "equality/point.hpp"

using namespace magicmass::equality;

namespace {

std::string shown(const std::vector<std::string>& conditions,
                  const std::set<std::string>& symbols) {
  std::string all;
  for (const std::string& condition : to_texts(parse_domain(conditions, symbols)))
    all += (all.empty() ? "" : "; ") + condition;
  return all;
}

}  // namespace

TEST_CASE("the paper's symbols come with their usual domain", "[exam]") {
  CHECK(shown({}, {"alpha"}) == "alpha > 0");
  CHECK(shown({}, {"e"}) == "0 < e <= 1");
  CHECK(shown({}, {"n"}) == "n integer, n >= 1");
  CHECK(shown({}, {"x"}) == "x real");
}

TEST_CASE("conditions change one side, a kind replaces all", "[exam]") {
  CHECK(shown({"alpha < 1"}, {"alpha"}) == "0 < alpha < 1");
  CHECK(shown({"alpha > -1"}, {"alpha"}) == "alpha > -1");
  CHECK(shown({"0<=x<2"}, {"x"}) == "0 <= x < 2");
  CHECK(shown({"2>=x", "x>1, x>0"}, {"x"}) == "1 < x <= 2");
  CHECK(shown({"alpha real"}, {"alpha"}) == "alpha real");
  CHECK(shown({"n>=0, n integer"}, {"n"}) == "n integer, n >= 0");
  CHECK(shown({"n real"}, {"n"}) == "n real");
  CHECK(shown({"x < y"}, {"x", "y"}) == "x real; y real; x < y");
}

TEST_CASE("conditions that make no sense are refused", "[exam]") {
  using Catch::Contains;
  CHECK_THROWS_WITH(parse_domain({"beta > 0"}, {"x"}), Contains("in neither expression"));
  CHECK_THROWS_WITH(parse_domain({"psi > 0"}, {"alpha"}), Contains("defined by other symbols"));
  CHECK_THROWS_WITH(parse_domain({"x"}, {"x"}), Contains("a relation is missing"));
  CHECK_THROWS_WITH(parse_domain({""}, {"x"}), Contains("empty condition"));
  CHECK_THROWS_WITH(parse_domain({"x>1,x<0"}, {"x"}), Contains("no value of x"));
  CHECK_THROWS_WITH(parse_domain({"0<n<1"}, {"n"}), Contains("no value of n"));
  CHECK_THROWS_WITH(parse_domain({"2 integer"}, {"x"}), Contains("a symbol is expected"));
}

TEST_CASE("points lie in the domain, the simplest first", "[exam]") {
  const Domain domain = parse_domain({"0<x<1, n>=3, y<x"}, {"n", "x", "y"});
  const std::vector<Point> points = points_of(domain, 40, {});
  REQUIRE(points.size() == 40);
  for (const Point& point : points) {
    INFO(to_text(point));
    CHECK(domain.ranges.at("x").contains(point.at("x")));
    CHECK(domain.ranges.at("n").contains(point.at("n")));
    CHECK(point.at("y") < point.at("x"));
  }
  CHECK(points.front().at("n") == 3);
  CHECK(points.front().at("x") == cln::cl_RA(1) / 2);
  CHECK(simple_values(parse_domain({}, {"alpha"}).ranges.at("alpha"), 3) ==
        std::vector<cln::cl_RA>{1, 2, 3});
}
