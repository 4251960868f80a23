// SPDX-License-Identifier: GPL-2.0-or-later
// Whatever is called equal agrees at random points, far from those that were tried to decide it.
#include <algorithm>
#include <cstdlib>
#include <random>

#include "catch.hpp"
#include "equality/decide.hpp"

using namespace equality;

namespace {

class Writer {
public:
  explicit Writer(unsigned seed) : random(seed) {}
  int below(int n) { return int(random() % unsigned(n)); }
  template <class T>
  T one_of(const std::vector<T>& all) {
    return all[std::size_t(below(int(all.size())))];
  }
  /// Of the symbols x and n.
  std::string term(int depth) {
    if (depth == 0) return one_of<std::string>({"x", "n", "2", "3", "1/2", "pi", "x", "n"});
    const std::string a = term(depth - 1), b = term(depth - 1);
    return one_of<std::string>({"(" + a + "+" + b + ")", "(" + a + "-" + b + ")", a + "*" + b,
                                "(" + a + ")/(" + b + ")", "(" + a + ")^2", "sqrt(" + a + ")",
                                "abs(" + a + ")", "exp(-(" + a + "))", "log(" + a + ")",
                                "atan(" + a + ")", "sin(" + a + ")", "cos(" + a + ")"});
  }
  std::mt19937 random;
};

/// Where the values certainly differ; "" at a point where they agree or one has none.
bool is_apart(Expr left, Expr right, const Point& point) {
  const auto a = value_at(point, left).ball, b = value_at(point, right).ball;
  return a && b && (a->high() < b->low() || b->high() < a->low());
}

}  // namespace

TEST_CASE("What is called equal agrees at random points") {
  const char* const longer = std::getenv("MAGICMASS_PAIRS");
  const int pairs = longer == nullptr ? 600 : std::atoi(longer);
  Writer writer(20261125);
  int equal = 0;
  for (int i = 0; i < pairs; ++i) {
    const std::string f = writer.term(2), g = writer.term(1);
    const auto [one, other] = writer.one_of<std::pair<std::string, std::string>>(
        {{"abs(" + f + ")", f},
         {"sqrt(x-3)*abs(" + f + ")", "sqrt(x-3)*(" + f + ")"},
         {"sqrt((" + f + ")^2)", f},
         {"log((" + f + ")^2)", "2*log(" + f + ")"},
         {"sqrt((" + f + ")*(" + g + "))", "sqrt(" + f + ")*sqrt(" + g + ")"},
         {"(" + f + ")^(" + g + ")*(" + f + ")^2", "(" + f + ")^(2+" + g + ")"},
         {"atan(tan(" + f + "))", f},
         {"abs(" + f + ")*abs(" + g + ")", "(" + f + ")*(" + g + ")"},
         {"sqrt((" + f + ")*(" + g + "))^2", "abs(" + f + ")*abs(" + g + ")"},
         {"sqrt((" + f + ")*(" + g + "))^3/sqrt((" + f + ")*(" + g + "))", f + "*(" + g + ")"},
         {"((" + f + ")^(1/(" + g + ")))^(" + g + ")", f},
         {"(-2)^(" + f + ")*(-3)^(" + f + ")", "6^(" + f + ")"},
         {"(-1)^(" + f + ")", "cos(pi*(" + f + "))"},
         {"(2-sqrt(3))^(" + f + ")*(sqrt(2)+1)^(" + g + ")",
          "(2+sqrt(3))^(-(" + f + "))/(sqrt(2)-1)^(" + g + ")"}});
    const auto domain = writer.one_of<std::string>(
        {"", "0 < x < 1", "x >= 2, n integer, n >= 1", "n integer, 0 <= x < 1.571"});
    CAPTURE(i, one, other, domain);
    Expr left, right;
    Domain where;
    Verdict verdict;
    try {
      left = notation::read_typed(one).term;
      right = notation::read_typed(other).term;
      std::vector<std::string> unused;
      where = read_domain(domain, notation::symbols_of(eq(left, right)), unused);
      verdict = decide(left, right, where);
    } catch (const kernel::Refused&) {
      continue;
    }
    if (verdict.answer != Answer::Equal) continue;
    ++equal;
    const bool at_whole = std::ranges::any_of(verdict.conditions, [](const std::string& condition) {
      return condition.ends_with(" integer");
    });
    for (int k = 0; k < 40; ++k) {
      Point point;
      for (const auto& [symbol, range] : where.ranges) {
        const int scale = writer.one_of<int>({1, 7, 1000});
        cln::cl_RA value = cln::cl_RA(writer.below(9000) - 3000) / scale;
        if (range.is_integer || at_whole) value = cln::floor1(value);
        if (range.contains(value)) point[symbol] = value;
      }
      if (point.size() == where.ranges.size()) CHECK_FALSE(is_apart(left, right, point));
    }
  }
  CHECK(equal > pairs / 10);
}
