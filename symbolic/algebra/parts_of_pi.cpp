// The cosine and the sine of pi/d in square roots, for d = 1, 3, 5, 15 and halves of these angles.
#include "algebra/tactics.hpp"

namespace algebra {
namespace {
const Expr x = real("x"), y = real("y");

/// |- sqrt(square) = t, and 0 < square among the signs.
Theorem root(const Theorem& square, Expr t, Theorems& signs) {
  const Theorem is = chain(square, equation(right(square), simplified(right(square)), signs));
  signs.push_back(linear(lt(0, right(is)), {is, positive(left(is))}));
  return root_of(is, positive(t));
}
/// With the sine: n sin(t) is the root of n^2 (1 - cos(t)^2).
PartOfPi with_sine(Expr t, int n, const Theorem& cosine) {
  const Theorem square = equation(power(n * sin(t), 2), n * n * (1 - power(right(cosine), 2)),
                                  angles({}, {t}) + Theorems{cosine});
  Theorems signs;
  const Theorem is = root(square, n * sin(t), signs);
  return {cosine, linear(eq(sin(t), left(is) / n), {is}), signs};
}
/// |- sin(l t) = sin(i t), where both angles together are pi.
Theorem mirrored(Expr t, int l, int i) {
  const Theorem mirror = equation(sin(pi() - x), sin(x), {}, {pi(), x});
  return restate(eq(sin(l * t), sin(i * t)), at(mirror, {{x, i * t}}));
}
PartOfPi third() {
  const Expr t = pi() / 3;
  const Theorem is = equation(sin(2 * t), 2 * sin(t) * cos(t), {}, {t});
  return with_sine(
      t, 2,
      certified(eq(cos(t), Expr(1) / 2), {.equations = {{1, mirrored(t, 2, 1)}, {-1, is}},
                                          .multipliers = {positive(2 * sin(t))}}));
}
PartOfPi fifth() {
  const Expr t = pi() / 5, c = cos(t);
  const Theorem is =
      equation(sin(3 * t) - sin(2 * t), sin(t) * (4 * power(c, 2) - 2 * c - 1), {}, {t});
  const Theorem square = certified(
      eq(power(4 * c - 1, 2), 5),
      {.equations = {{4, mirrored(t, 3, 2)}, {-4, is}}, .multipliers = {positive(sin(t))}});
  const Theorem less =
      linear(lt(0, 4 * c - 1), {cosine_falls(linear(lt(t, pi() / 3))), third().cosine});
  return with_sine(t, 4, linear(eq(c, (1 + sqrt(Expr(5))) / 4), {root_of(square, less)}));
}
/// 2 pi/5 - pi/3
PartOfPi fifteenth() {
  const PartOfPi a = fifth(), b = third();
  const Expr p = 2 * pi() / 5, q = pi() / 3, t = pi() / 15;
  const Theorems twice = angles({cos(p), sin(p)}, {pi() / 5}, false);
  const auto is = [&](Expr part, Expr of_difference, Expr in_both) {
    Theorem sum = at(equation(of_difference, in_both, {}, {x, y}), {{x, p}, {y, q}});
    for (const Theorem& rule : twice + Theorems{a.cosine, a.sine, b.cosine, b.sine})
      sum = rewrite(rule, sum);
    return restate(eq(part, right(sum)), sum);
  };
  const Theorem cosine = is(cos(t), cos(x - y), cos(x) * cos(y) + sin(x) * sin(y));
  const Theorem sine = is(sin(t), sin(x - y), sin(x) * cos(y) - cos(x) * sin(y));
  const Theorems signs = a.signs + b.signs;
  const Expr five = sqrt(Expr(5)), inner = 30 + 6 * five;
  const Theorem root = root_is(inner, 4 * sqrt(Expr(3)) * five / sqrt(10 - 2 * five), signs);
  const Theorem simpler =
      equation(right(cosine), (five - 1 + sqrt(inner)) / 8, signs + Theorems{root});
  return {chain(cosine, simpler), sine, signs};
}
/// 2 cos(t) is the root of 2 + 2 cos(2t), sin(t) is sin(2t)/(2 cos(t)).
PartOfPi halved(Expr t, const PartOfPi& twice) {
  const Theorem cosine_of_2t = restate(eq(cos(2 * t), right(twice.cosine)), twice.cosine);
  const Theorem sine_of_2t = restate(eq(sin(2 * t), right(twice.sine)), twice.sine);
  const Theorem square = equation(power(2 * cos(t), 2), 2 + 2 * cos(2 * t), {}, {t});
  Theorems signs = twice.signs;
  const Theorem is = root(rewrite(cosine_of_2t, square), 2 * cos(t), signs);
  const Theorem cosine = linear(eq(cos(t), left(is) / 2), {is});
  const Theorem product = equation(sin(2 * t), 2 * cos(t) * sin(t), {}, {t});
  const Theorem sine = certified(eq(sin(t), right(twice.sine) / (2 * cos(t))),
                                 {.equations = {{-1, product}, {1, sine_of_2t}},
                                  .multipliers = {positive(2 * cos(t))},
                                  .nonzero = {positive(cos(t))}});
  return {cosine, rewrite(cosine, sine), signs};
}
}  // namespace

std::optional<PartOfPi> part_of_pi(int d) {
  if (d == 1) return PartOfPi{axiom("cos pi"), axiom("sin pi"), {}};
  if (d == 2) return PartOfPi{axiom("cos pi/2"), axiom("sin pi/2"), {}};
  if (d == 3) return third();
  if (d == 5) return fifth();
  if (d == 15) return fifteenth();
  if (d < 2 || d % 2 != 0) return {};
  const auto twice = part_of_pi(d / 2);
  return twice ? halved(pi() / d, *twice) : twice;
}
}  // namespace algebra
