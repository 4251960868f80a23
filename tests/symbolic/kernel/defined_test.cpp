// SPDX-License-Identifier: GPL-2.0-or-later
// What a formula needs to make sense.

#include "attack.hpp"

using namespace kernel;

namespace {
std::vector<std::string> words(const Exprs& conditions) {
  std::vector<std::string> out;
  for (Expr e : conditions) out.push_back(text(e));
  return out;
}
using Words = std::vector<std::string>;
}  // namespace

TEST_CASE("each division and root asks for its condition, under what is said before it") {
  real("any1");
  for (const auto& [formula, conditions] : std::vector<std::pair<Expr, Words>>{
           {eq(x, y), {}},
           {eq(1 / x, 1), {"x != 0"}},
           {eq(sqrt(1 / x), 1 / x), {"x != 0", "0 <= 1/x"}},
           {imp(lt(0, x), eq(1 / x, y)), {"0 < x implies x != 0"}},
           {imp(eq(1 / x, y), lt(0, x)), {"x != 0"}},
           {logic_and({lt(0, x), eq(1 / x, y)}), {"0 < x implies x != 0"}},
           {logic_or({eq(x, 0), eq(1 / x, y)}), {"x != 0"}},
           {logic_not(eq(1 / x, y)), {"x != 0"}},
           {imp(lt(0, real("any1")), all(x, imp(lt(x, 0), all(y, eq(1 / y, 1 / x))))),
            {"0 < any1 and any2 < 0 implies any3 != 0", "0 < any1 and any2 < 0 implies any2 != 0"}},
           {all(n, eq(1 / n, 0)), {"any_integer1 != 0"}},
           {eq(det(matrix(1, {1 / x})), 0), {"x != 0"}},
           {eq(det(power(matrix(1, {x}), n)), 1), {"0 <= n"}}}) {
    INFO(text(formula));
    CHECK(words(needs(formula)) == conditions);
  }
}

TEST_CASE("hypotheses are read, too, and predicates are unfolded") {
  define("inverse_of", {x, y}, eq(y, 1 / x));
  define("power_of", {x}, x + 1);
  restrict_domain("power_of", {y}, lt(0, y));
  CHECK(words(needs(assume(eq(1 / x, y)))) == Words{"x != 0", "1/x = y implies x != 0"});
  CHECK(words(needs(fun("inverse_of", {x + 1, 2}))) == Words{"x + 1 != 0"});
  CHECK(words(needs(eq(fun("power_of", {x / y}), 0))) == Words{"y != 0", "0 < x/y"});
}

TEST_CASE("a domain is a condition on the function's own parameters") {
  define("somewhere", {x, n}, x);
  const auto domain = [](const Exprs& params, Expr condition) {
    return [=] { restrict_domain("somewhere", params, condition); };
  };
  refused("of nothing", "no function", [] { restrict_domain("nowhere", {}, eq(0, 0)); });
  refused("one parameter", "another number", domain({x}, lt(0, x)));
  refused("one twice", "twice", domain({n, n}, lt(0, n)));
  refused("of another sort", "other sorts", domain({x, y}, lt(0, x)));
  refused("a term for a parameter", "must be a variable", domain({x, n + 1}, lt(0, x)));
  refused("a number", "must be a formula", domain({x, n}, x));
  refused("a free variable", "not a parameter", domain({x, n}, lt(y, x)));
  refused("of inv again", "a domain already", [] { restrict_domain("inv", {x}, lt(0, x)); });
  refused("of 2^20 nodes", "more than 200000 nodes", [] { needs(eq(doubled(20), 0)); });
  refused("of a number", "only a formula", [] { needs(x); });
}
