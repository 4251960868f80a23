// SPDX-License-Identifier: GPL-2.0-or-later
// The first ratios in square roots: sums of cosines of 2 k pi/p, p = 5 and 17, solve quadratic
// equations (Gauss' periods); halves and a difference of angles give the others.
#include <algorithm>

#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr angle_of(int d) { return pi() / d; }

/// 0 < x, x < pi |- cos(x/2) = sqrt((1 + cos(x))/2)
Theorem halving(Book& book) {
  const Known range({assume(lt(0, x)), assume(lt(x, pi()))});
  const Expr half = (1 + cos(x)) / 2;
  const Theorem square = equation(power(cos(x / 2), 2), half, angles({cos(x)}, {x / 2}));
  know(linear(le(0, half), {square, not_negative(power(cos(x / 2), 2))}));
  return book.show("halving", "Half of an angle between 0 and pi:",
                   turned(root_of(square, positive(cos(x / 2)))));
}
/// u and v from u + v = s, (u - v)^2 = d and v < u.
struct Quadratic {
  Quadratic(const Theorem& sum, const Theorem& square, const Theorem& less)
      : root(root_of(square, linear(lt(0, left(square).arg(0)), {less}))),
        greater(solved(sum, right(less), left(root) / 2)),
        smaller(solved(sum, left(less), -left(root) / 2)) {
    know(linear(le(0, right(square)), {square, not_negative(left(square))}));
  }
  Theorem solved(const Theorem& sum, Expr which, Expr half_gap) const {
    return linear(eq(which, right(sum) / 2 + half_gap), {sum, root});
  }
  Theorem root, greater, smaller;
};

/// The cosines of 2 k pi/p for a prime p, k = 1, ..., (p - 1)/2.
class Periods {
public:
  explicit Periods(int prime) : p(prime) {
    const Theorem product = equation(cos(x) * cos(y), (cos(x + y) + cos(x - y)) / 2, {}, {x, y});
    const Theorem step = equation(2 * cos(x) * sin(y), sin(x + y) - sin(x - y), {}, {x, y});
    const Expr unit = pi() / p;
    Certificate c;  // sin(unit) (1 + 2 sum of cosines) = sin(pi), as a telescope
    c.multipliers = {positive(sin(unit))};
    c.equations = {{1, restate(eq(sin(Expr(p) * unit), 0), axiom("sin pi"))}};
    Expr sum = 0;
    for (int i = 1; 2 * i < p; ++i) {
      sum = sum + 2 * cosine(i);
      c.equations.push_back({1, at(step, {{x, angle(i)}, {y, unit}})});
      for (int l = 1; l <= i; ++l) {
        const Theorem t = at(product, {{x, angle(i)}, {y, angle(l)}});
        const Expr found = (cos(angle(i + l)) + cos(angle(i - l))) / 2;
        Theorems folding{restate(eq(cosine(i) * cosine(l), found), t),
                         restate(eq(cos(angle(0)), 1), axiom("cos 0"))};
        if (2 * (i + l) > p) folding.push_back(fold(i + l));
        rules.push_back(equation(cosine(i) * cosine(l), period({i + l, i - l}) / 4, folding));
      }
    }
    rules.push_back(arithmetic(eq(sum, -1), c));
  }
  Expr angle(int i) const { return Expr(2 * i) * pi() / p; }
  Expr cosine(int i) const {
    const int least = std::min(i % p, p - i % p);
    return least == 0 ? Expr(1) : cos(angle(least));
  }
  /// 2 cos of each, added.
  Expr period(const std::vector<int>& of) const {
    Expr sum = 0;
    for (const int i : of) sum = sum + 2 * cosine(i);
    return sum;
  }
  /// |- cos(2 l pi/p) < cos(2 i pi/p)
  Theorem falls(int i, int l) const { return falls(angle(i), angle(l)); }
  static Theorem falls(Expr smaller, Expr larger) {
    return cosine_falls(linear(lt(smaller, larger)));
  }
  /// A linear relation of periods of the second degree.
  Theorem known(Expr goal) const { return linear(goal, rules); }
  int p;
  Theorems rules;  ///< products of two cosines as sums; the sum of all

private:
  Theorem fold(int i) const {
    const Theorem back = equation(cos(2 * pi() - x), cos(x), {}, {pi(), x});
    return restate(eq(cos(angle(i)), cos(angle(p - i))), at(back, {{x, angle(p - i)}}));
  }
};
/// |- cos(pi/p) = -cos(2 h pi/p), h = (p - 1)/2
Theorem opposite(const Periods& of) {
  const Expr t = pi() / of.p;
  const Theorem back = at(equation(cos(pi() - x), -cos(x), {}, {pi(), x}), {{x, t}});
  return linear(eq(cos(t), -of.cosine(of.p / 2)), {back});
}
/// |- cos(pi/5) = (1 + sqrt(5))/4, and what the cosine of 2 pi/5 is
struct Fifth {
  Theorem cosine, twice;
};
Fifth fifth(Book& book) {
  const Periods of(5);
  const Expr u = of.period({1}), v = of.period({2});
  const Quadratic q(of.known(eq(u + v, -1)), of.known(eq(power(u - v, 2), 5)),
                    linear(lt(v, u), {of.falls(1, 2)}));
  const Expr s = sqrt(Expr(5));
  return {book.show("fifth", "The cosine of a fifth of pi:",
                    linear(eq(cos(pi() / 5), (1 + s) / 4), {opposite(of), q.smaller})),
          linear(eq(of.cosine(1), (s - 1) / 4), {q.greater})};
}
/// |- cos(pi/15), from 2 pi/5 - pi/3
Theorem fifteenth(const Theorem& cos_fifth, const Theorem& cos_third) {
  const Expr twice = 2 * pi() / 5, third = pi() / 3, s = sqrt(Expr(5));
  const auto sine = [&](Expr t, Expr squared, const Theorem& cosine) {
    return turned(root_is(squared, sin(t), angles({}, {t}) + Theorems{cosine}));
  };
  const Theorem cosine = restate(eq(cos(twice), (s - 1) / 4), cos_fifth);
  const Theorem difference = equation(cos(x - y), cos(x) * cos(y) + sin(x) * sin(y), {}, {x, y});
  const Theorem is = at(difference, {{x, twice}, {y, third}});
  return equation(cos(pi() / 15), (s - 1) / 8 + sqrt((5 + s) / 8) * sqrt(rational(3, 4)),
                  {restate(eq(cos(pi() / 15), right(is)), is), cosine, cos_third,
                   sine(twice, (5 + s) / 8, cosine), sine(third, rational(3, 4), cos_third)});
}
/// |- cos(pi/17), by four quadratic equations
Theorem seventeenth(Book& book) {
  const Periods of(17);
  const auto period = [&](const std::vector<int>& which) { return of.period(which); };
  const Expr E = period({1, 2, 4, 8}), F = period({3, 5, 6, 7});
  const Expr a = period({1, 4}), b = period({2, 8}), c = period({3, 5}), d = period({6, 7});
  const Theorem half = book["ratios.third"];
  const Theorem E_positive =
      linear(lt(0, E), {of.falls(of.angle(1), pi() / 3), of.falls(of.angle(2), pi() / 3), half,
                        of.falls(of.angle(4), pi() / 2), of.falls(of.angle(8), pi())});
  const Theorem whole = of.known(eq(E + F, -1));
  const Quadratic first(whole, of.known(eq(power(E - F, 2), 17)),
                        linear(lt(F, E), {E_positive, whole}));
  const auto halves = [&](Expr u, Expr v, const Theorem& sum, const Theorem& less) {
    const Expr s = left(sum);  // (u - v)^2 = s^2 + 4
    const Theorem square = rewrite(sum, of.known(eq(power(u - v, 2), power(s, 2) + 4)));
    const Expr value = right(square), simple = simplified(value);
    return Quadratic(linear(eq(u + v, right(sum)), {sum}), rewrite(equation(value, simple), square),
                     less);
  };
  const Quadratic of_E =
      halves(a, b, first.greater, linear(lt(b, a), {of.falls(1, 2), of.falls(4, 8)}));
  const Quadratic of_F =
      halves(c, d, first.smaller, linear(lt(d, c), {of.falls(3, 6), of.falls(5, 7)}));
  const Expr u = period({2}), v = period({8});
  const Theorem square = of.known(eq(power(u - v, 2), power(b, 2) - 4 * d));
  const Quadratic last(linear(eq(u + v, right(of_E.smaller)), {of_E.smaller}),
                       rewrite(of_F.smaller, rewrite(of_E.smaller, square)),
                       linear(lt(v, u), {of.falls(2, 8)}));
  const Theorem is = opposite(of);
  const Expr b_value = right(of_E.smaller), root = left(last.root);
  return linear(eq(left(is), (root - b_value) / 4), {is, last.smaller});
}
}  // namespace

void radicals(Book& book) {
  book.chapter("radicals", "The first ratios in square roots", {});
  const Known in_this_chapter;
  const Theorem half_of = halving(book);
  std::map<int, Theorem> cosines;
  cosines.emplace(2, axiom("cos pi/2"));
  cosines.emplace(3, restate(eq(cos(angle_of(3)), rational(1, 2)), book["ratios.third"]));
  const Fifth of_5 = fifth(book);
  cosines.emplace(5, of_5.cosine);
  cosines.emplace(15, fifteenth(of_5.twice, cosines.at(3)));
  cosines.emplace(17, seventeenth(book));
  for (const int d : {4, 6, 8, 10, 12, 16, 20}) {
    const Theorem value = rewrite(cosines.at(d / 2), at(half_of, {{x, angle_of(d / 2)}}));
    const Expr under_root = simplified(right(value).arg(0));
    const Theorem simpler = rewrite(equation(right(value).arg(0), under_root), value);
    cosines.emplace(d, restate(eq(cos(angle_of(d)), sqrt(under_root)), simpler));
  }
  const Expr two = sqrt(Expr(2)), three = sqrt(Expr(3));
  const std::map<int, std::pair<Expr, Theorems>> forms{
      // no root of a fraction
      {4, {two - 1, {root_is(rational(1, 2), 1 / two)}}},
      {5, {sqrt(Expr(5)) - 2, {}}},
      {6, {2 / three - 1, {root_is(rational(3, 4), three / 2)}}},
      {17, {4 / right(cosines.at(17)).arg(1) - 1, {}}}};  // its cosine is (...)/4
  for (const int d : {4, 5, 6, 8, 10, 12, 15, 16, 17, 20}) {
    const bool magic = d % 2 == 1;
    const int index = magic ? (d - 1) / 2 : d / 2 - 1;
    const std::string name = magic ? "alpha_" : "beta_";
    const Theorem definition = at(book["ratios." + name + "k_paper"], {{k, index}});
    const Expr angle = right(definition).arg(1).arg(0).arg(0);
    const Theorem cosine = restate(eq(cos(angle), right(cosines.at(d))), cosines.at(d));
    know(linear(lt(0, right(cosine)), {cosine, Periods::falls(angle, pi() / 2)}));
    Theorem value = rewrite(cosine, definition);
    if (const auto form = forms.find(d); form != forms.end())
      value = chain(value, equation(right(value), form->second.first, form->second.second));
    book.show(name + std::to_string(index), "The ratio of pi/" + std::to_string(d) + ":", value);
  }
}
}  // namespace derivation
