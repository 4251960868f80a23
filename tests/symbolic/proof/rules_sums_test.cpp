// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/finite_sums.hpp"
#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/normal_form.hpp"
#include "proof/text.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

const ex n = symbol("n"), x = symbol("x"), y = symbol("y"), k = summation_index();
const std::map<std::string, long> from_zero{{"n", 0}}, from_one{{"n", 1}};

// Terms of (x + y)^n.
ex binomial_sum(const ex& order) {
  return finite_sum(
      factorial(order) / (factorial(k) * factorial(order - k)) * pow(x, k) * pow(y, order - k), 0,
      floor(order));
}
ex even_sum(const ex& order, const ex& upper) {
  return finite_sum(pow(ex(-1), k) * factorial(order) /
                        (factorial(2 * k) * factorial(order - 2 * k)) * pow(x, 2 * k) *
                        pow(y, order - 2 * k),
                    0, upper);
}
ex odd_sum(const ex& order) {
  return finite_sum(pow(ex(-1), k) * factorial(order) /
                        (factorial(2 * k + 1) * factorial(order - 2 * k - 1)) * pow(x, 2 * k + 1) *
                        pow(y, order - 2 * k - 1),
                    0, floor((order - 1) / 2));
}
ex total(const Kernel::SumTerms& terms) {
  ex sum = 0;
  for (const auto& [coefficient, part, shift] : terms) sum += coefficient * part;
  return sum;
}

}  // namespace

TEST_CASE("a sum is written out once its bounds are numbers", "[exam]") {
  CHECK((binomial_sum(n).subs(n == 3) - pow(x + y, 3)).expand().is_zero());
  CHECK(odd_sum(n).subs(n == 0).is_zero());
  CHECK(even_sum(n, floor(n / 2)).subs(n == 0).is_equal(1));
  CHECK((even_sum(n, floor(n / 2)).subs(n == 4) - (pow(y, 4) - 6 * pow(x * y, 2) + pow(x, 4)))
            .expand()
            .is_zero());
}

TEST_CASE("only sums whose bounds are where their terms stop are understood", "[exam]") {
  CHECK(finite_sum_of(even_sum(n, floor(n / 2))));
  CHECK_FALSE(finite_sum_of(even_sum(n, floor((n - 1) / 2))));
  CHECK_FALSE(finite_sum_of(even_sum(n, floor(n / 2) + 1)));
  CHECK_FALSE(finite_sum_of(even_sum(n, n)));
  CHECK_FALSE(finite_sum_of(finite_sum(pow(x, k), 0, n)));
  CHECK_FALSE(finite_sum_of(finite_sum(1 / (k - 3), 0, n)));
  CHECK_FALSE(finite_sum_of(
      finite_sum(pow(x, k) / (factorial(k) * factorial(n - k)) * pow(y, -k), 0, floor(n))));
  CHECK_FALSE(
      finite_sum_of(finite_sum(k * pow(x, k) / (factorial(k) * factorial(n - k)), 0, floor(n))));
  CHECK_FALSE(
      finite_sum_of(finite_sum(pow(x, k) / (factorial(k + n) * factorial(n - k)), 0, floor(n))));
}

TEST_CASE("Pascal's rule is proved, with its index", "[exam]") {
  Kernel kernel({});
  const Kernel::SumTerms terms{{y, binomial_sum(n - 1), 0}, {x, binomial_sum(n - 1), -1}};
  const Theorem next = kernel.sum_recurrence(
      {.id = "a", .statement = {binomial_sum(n), total(terms)}, .indices = from_one}, terms);
  CHECK(next.step().conditions == std::vector<std::string>{"n integer, n >= 1"});
}

TEST_CASE("no false recurrence of sums is proved", "[exam]") {
  Kernel kernel({});
  int number = 0;
  const auto refused = [&](const ex& lhs, const Kernel::SumTerms& terms,
                           const std::map<std::string, long>& indices = from_one) {
    CHECK_THROWS_AS(kernel.sum_recurrence({.id = "r" + std::to_string(++number),
                                           .statement = {lhs, total(terms)},
                                           .indices = indices},
                                          terms),
                    NotProved);
  };
  const ex before = binomial_sum(n - 1), whole = binomial_sum(n);
  refused(whole, {{y, before, 0}, {x, before, -1}}, from_zero);  // (n - 1)! at n = 0
  refused(whole, {{y, before, 0}, {x, before, -1}}, {});         // n need not be an integer
  refused(whole, {{y, before, 0}, {x, before, 0}});              // not so shifted
  refused(whole, {{y, before, 0}, {x, before, 1}});
  refused(whole, {{y, before, 0}, {-x, before, -1}});
  refused(whole, {{y, before, 0}});
  refused(whole, {{2 * y, before, 0}, {x, before, -1}});
  refused(whole, {{y + 1, before, 0}, {x, before, -1}});
  refused(whole, {{x / y, before, -1}, {y, before, 0}});
  refused(2 * whole, {{2 * y, before, 0}, {2 * x, before, -1}});  // not a sum
  refused(before, {{1 / y, whole, 0}});                           // downwards: 1/y, and y may be 0
  const ex half = floor(n / 2), even = even_sum(n, half);
  const ex even_before = even_sum(n - 1, floor((n - 1) / 2)), odd_before = odd_sum(n - 1);
  CHECK_NOTHROW(kernel.sum_recurrence(
      {.id = "fine",
       .statement = {even, total({{y, even_before, 0}, {-x, odd_before, -1}})},
       .indices = from_one},
      {{y, even_before, 0}, {-x, odd_before, -1}}));
  refused(even, {{y, even_before, 0}, {x, odd_before, -1}});  // the sign of (-1)^k under the shift
  refused(even, {{y, even_before, 0}, {-x, odd_before, 0}});
  refused(even_sum(n, floor((n - 1) / 2)), {{y, even_before, 0}, {-x, odd_before, -1}});
  refused(even, {{y, even_sum(n - 1, floor(n / 2)), 0}, {-x, odd_before, -1}});
}

TEST_CASE("a recurrence's right side is the combination that is shown to hold", "[exam]") {
  Kernel kernel({});
  const Kernel::SumTerms terms{{y, binomial_sum(n - 1), 0}, {x, binomial_sum(n - 1), -1}};
  CHECK_THROWS_AS(
      kernel.sum_recurrence(
          {.id = "a", .statement = {binomial_sum(n), total(terms) + 1}, .indices = from_one},
          terms),
      NotProved);
}

TEST_CASE("the index of a sum is nothing outside it", "[exam]") {
  Kernel kernel({});
  CHECK_THROWS(kernel.identity({.id = "a", .statement = {k, k}}));
  CHECK_THROWS(kernel.hypothesis({.id = "b", .statement = {x, k}}));
  CHECK_THROWS(symbol("k'"));
  CHECK(to_text(k) == "k'");
  NormalForm form(Domain{.positive = {}, .integer = {{"n", 0}}}, {});
  CHECK(form.is_zero(binomial_sum(n) - binomial_sum(n)));
  CHECK_FALSE(form.is_zero(binomial_sum(n) - binomial_sum(n + 1)));
  CHECK_THROWS_AS(form.is_zero(1 + finite_sum(1 / (k - x), 0, n)), NotInClass);
  CHECK_THROWS_AS(form.is_zero(1 + binomial_sum(n - 1)), NotInClass);  // (n - 1)! at n = 0
  CHECK_THROWS_AS(form.is_zero(1 + binomial_sum(symbol("z"))), NotInClass);
}
