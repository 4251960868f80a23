// SPDX-License-Identifier: GPL-2.0-or-later
// The first ratios in square roots: from the cosines of pi/3 and pi/5, by halving angles.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr angle_of(int d) { return pi() / d; }

/// 0 < x, x < pi |- cos(x/2) = sqrt((1 + cos(x))/2)
Theorem halving(Book& book) {
  const Theorem above = assume(lt(0, x));
  const Theorem below = assume(lt(x, pi()));
  const Theorem cos_positive =
      cosine_positive(linear(lt(0, x / 2), {above}), linear(lt(x / 2, pi() / 2), {below}));
  const Theorem is = root_is((1 + cos(x)) / 2, cos(x / 2), cos_positive, angles({cos(x)}, {x / 2}));
  book.facts.push_back(
      linear(le(0, (1 + cos(x)) / 2),
             {equation((1 + cos(x)) / 2, power(cos(x / 2), 2), angles({cos(x)}, {x / 2})),
              not_negative(power(cos(x / 2), 2))}));
  return book.show("halving", "", "Half of an angle between 0 and pi:", turned(is));
}
/// |- cos(pi/5) = (1 + sqrt(Expr(5)))/4: cos(3x) = -cos(2x) there.
Theorem fifth(Book& book, const Theorem& c_positive) {
  const Expr t = angle_of(5), c = cos(t), s = sqrt(Expr(5));
  const Theorem opposite = [&] {  // cos(3x) = cos(pi - 2x)
    const Theorem sum = use("cos sum", {{x, pi()}, {y, -2 * t}});
    const Theorem even = use("cos minus", {{x, 2 * t}});
    return equation(cos(pi() - 2 * t), -cos(2 * t),
                    {restate(eq(cos(pi() - 2 * t), sum.conclusion().arg(1)), sum), axiom("cos pi"),
                     axiom("sin pi"), restate(eq(cos(-2 * t), cos(2 * t)), even)});
  }();
  const Theorem same = restate(eq(cos(3 * t), -cos(2 * t)), opposite);
  const Theorems multiples = angles({cos(3 * t), cos(2 * t)}, {t});
  const Theorem cubic = linear(eq(4 * power(c, 3) + 2 * power(c, 2) - 3 * c - 1, 0),
                               {same, equation(cos(3 * t), 4 * power(c, 3) - 3 * c, multiples),
                                equation(cos(2 * t), 2 * power(c, 2) - 1, multiples)});
  const Theorem five = root_squared(positive(5));
  const Theorem root_positive = positive(s);
  Certificate at_least_1;  // (s + 1)(s - 1) = 4
  at_least_1.multipliers = {linear(lt(0, s + 1), {root_positive})};
  at_least_1.equations = {{-1, five}};
  at_least_1.products = {{4, {}, {}}};
  const Theorem above_1 = arithmetic(lt(1, s), at_least_1);
  Certificate last;  // (c + 1)(4c - 1 + s)((1 + s)/4 - c) = -(4c^3 + 2c^2 - 3c - 1), as s^2 = 5
  last.multipliers = {linear(lt(0, c + 1), {c_positive}),
                      linear(lt(0, 4 * c - 1 + s), {c_positive, above_1})};
  last.equations = {{1, cubic}, {-(c + 1) / 4, five}};
  return book.show("fifth", "",
                   "The cosine of a fifth of pi:", arithmetic(eq(c, (1 + s) / 4), last));
}
}  // namespace

void radicals(Book& book) {
  book.chapter("radicals", "The first ratios in square roots", {});
  const Theorem half_of = halving(book);
  const auto cosine_positive = [&](int d) {
    const Expr t = angle_of(d);
    const Theorem falls =
        use("cos falls", {{x, t}, {y, pi() / 2}},
            {linear(le(0, t), {positive(t)}), linear(lt(t, pi() / 2), {positive(pi())}),
             linear(le(pi() / 2, pi()), {positive(pi())})});
    return linear(lt(0, cos(t)), {falls, axiom("cos pi/2")});
  };
  std::map<int, Theorem> cosines;
  cosines.emplace(2, axiom("cos pi/2"));
  cosines.emplace(3, restate(eq(cos(angle_of(3)), rational(1, 2)), book["ratios.third"]));
  cosines.emplace(5, fifth(book, cosine_positive(5)));
  for (const int d : {4, 6, 8, 10, 12, 16, 20}) {
    const Expr whole = angle_of(d / 2);
    const Theorem half = cut(positive(whole), cut(linear(lt(whole, pi()), {positive(pi())}),
                                                  instantiate(half_of, {{x, whole}})));
    const Theorem value = rewrite(cosines.at(d / 2), half);
    const Expr under_root = simplified(value.conclusion().arg(1).arg(0));
    const Theorem simpler = rewrite(equation(value.conclusion().arg(1).arg(0), under_root), value);
    cosines.emplace(d, restate(eq(cos(angle_of(d)), sqrt(under_root)), simpler));
  }
  for (const int d : {4, 5, 6, 8, 10, 12, 16, 20}) {
    const bool magic = d % 2 == 1;
    const int index = magic ? (d - 1) / 2 : d / 2 - 1;
    const std::string name = magic ? "alpha_" : "beta_";
    const Theorem definition = use(discharge(le(1, k), book["ratios." + name + "k_paper"]),
                                   {{k, index}}, {linear(le(1, index), {})});
    const Expr angle = definition.conclusion().arg(1).arg(1).arg(0).arg(0);
    const Theorem cosine =
        restate(eq(cos(angle), cosines.at(d).conclusion().arg(1)), cosines.at(d));
    Theorem value = rewrite(cosine, definition);
    if (d == 5) {  // the root out of the denominator
      const Expr r = value.conclusion().arg(1);
      value = chain(value, equation(r, simplified(r), {root_squared(positive(5))},
                                    {positive((1 + sqrt(Expr(5))) / 4)}));
    }
    book.show(name + std::to_string(index), "", "The ratio of pi/" + std::to_string(d) + ":",
              value);
  }
}
}  // namespace derivation
