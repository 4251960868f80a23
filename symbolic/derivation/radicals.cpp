// The first ratios in square roots; for pi/17, sums of cosines solve four quadratics (Gauss).
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
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

/// The cosines of 2 k pi/p for p = 17, a prime, k = 1, ..., (p - 1)/2.
class Periods {
public:
  Periods() {
    const Theorem product = equation(cos(x) * cos(y), (cos(x + y) + cos(x - y)) / 2, {}, {x, y});
    const Theorem step = equation(2 * cos(x) * sin(y), sin(x + y) - sin(x - y), {}, {x, y});
    const Theorem back = equation(cos(2 * pi() - x), cos(x), {}, {pi(), x});
    const Expr unit = pi() / p;
    Certificate c;  // sin(unit) (1 + 2 sum of cosines) = sin(pi), as a telescope
    c.multipliers = {positive(sin(unit))};
    c.equations = {{1, restate(eq(sin(Expr(p) * unit), 0), axiom("sin pi"))}};
    Expr sum = 0;
    for (int i = 1; 2 * i < p; ++i) {
      sum = sum + 2 * cosine(i);
      c.equations.push_back({1, at(step, {{x, angle(i)}, {y, unit}})});
      rules.push_back(restate(eq(cosine(p - i), cosine(i)), at(back, {{x, angle(i)}})));
      for (int l = 1; l <= i; ++l)
        rules.push_back(restate(eq(cosine(i) * cosine(l), period({i + l, i - l}) / 4),
                                at(product, {{x, angle(i)}, {y, angle(l)}})));
    }
    rules.push_back(arithmetic(eq(sum, -1), c));
  }
  Expr angle(int i) const { return Expr(2 * i) * pi() / p; }
  Expr cosine(int i) const { return cos(angle(i)); }
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
  static constexpr int p = 17;
  Theorems rules;  ///< products of two cosines as sums; which ones are equal; the sum of all
};
/// |- cos(pi/17), by four quadratic equations
Theorem seventeenth(Book& book) {
  const Periods of;
  const Expr E = of.period({1, 2, 4, 8}), F = of.period({3, 5, 6, 7}), a = of.period({1, 4}),
             b = of.period({2, 8}), c = of.period({3, 5}), d = of.period({6, 7});
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
  const Expr u = of.period({2}), v = of.period({8});
  const Theorem square = of.known(eq(power(u - v, 2), power(b, 2) - 4 * d));
  const Quadratic last(linear(eq(u + v, right(of_E.smaller)), {of_E.smaller}),
                       rewrite(of_F.smaller, rewrite(of_E.smaller, square)),
                       linear(lt(v, u), {of.falls(2, 8)}));
  const Expr t = pi() / of.p, b_value = right(of_E.smaller), root = left(last.root);
  const Theorem opposite = at(equation(cos(pi() - x), -cos(x), {}, {pi(), x}), {{x, t}});
  return linear(eq(cos(t), (root - b_value) / 4), {opposite, last.smaller});
}
}  // namespace

void radicals(Book& book) {
  book.chapter("radicals", "The first ratios in square roots", {});
  const Known in_this_chapter;
  std::map<int, Theorem> cosines{{17, seventeenth(book)}};
  for (const int d : {4, 5, 6, 8, 10, 12, 15, 16, 20}) cosines.emplace(d, part_of_pi(d)->cosine);
  book.show("fifth", "The cosine of a fifth of pi:", cosines.at(5));
  const std::map<int, Expr> forms{{4, sqrt(Expr(2)) - 1}, {5, sqrt(Expr(5)) - 2}};
  for (const auto& [d, cosine_of] : cosines) {
    const bool magic = d % 2 == 1;
    const int index = magic ? (d - 1) / 2 : d / 2 - 1;
    const std::string name = magic ? "alpha_" : "beta_";
    const Theorem definition = at(book["ratios." + name + "k_paper"], {{k, index}});
    const Expr angle = right(definition).arg(1).arg(0).arg(0);
    const Theorem cosine = restate(eq(cos(angle), right(cosine_of)), cosine_of);
    know(linear(lt(0, right(cosine)), {cosine, Periods::falls(angle, pi() / 2)}));
    const Theorem value = rewrite(cosine, definition);
    const auto form = forms.find(d);
    const Expr quotient = right(cosine);  // a number times a sum of roots
    const Expr ratio =
        form == forms.end() ? 1 / quotient.arg(0) / quotient.arg(1) - 1 : form->second;
    book.show(name + std::to_string(index), "The ratio of pi/" + std::to_string(d) + ":",
              chain(value, equation(right(value), ratio)));
  }
}
}  // namespace derivation
