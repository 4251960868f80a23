#include <algorithm>

#include "algebra/tactics.hpp"

namespace algebra {
namespace {
using Multiples = std::vector<cln::cl_RA>;

class AngleSums {
public:
  explicit AngleSums(const Exprs& angle_bases) : bases(angle_bases) {
    for (const Expr& b : bases) zeros.push_back(assume(eq(b, 0)));
  }

  /// The z of angle = sum of z b over the bases b, as angle = 0 follows from every b = 0.
  std::optional<Multiples> multiples_of(Expr angle) const {
    const auto sum = combination(eq(angle, 0), zeros);
    if (!sum) return {};
    const Certificate found = *sum->step().certificate;
    Multiples z(bases.size(), 0);
    for (const auto& [factor, zero] : found.equations) {
      const auto of = std::find(bases.begin(), bases.end(), left(zero));
      z[std::size_t(of - bases.begin())] = factor.value();
      if (cln::denominator(factor.value()) != 1) return {};
    }
    return z;
  }
  struct Pair {
    Theorem cosine, sine;
  };
  /// |- cos(sum of z b) = ..., |- sin(sum of z b) = ..., one base angle after the other.
  Pair pair(const Multiples& z) {
    if (const auto it = known.find(z); it != known.end()) return it->second;
    std::size_t i = 0;
    while (i < z.size() && z[i] == 0) ++i;
    if (i == z.size()) return {axiom("cos 0"), axiom("sin 0")};
    const bool plus = z[i] > 0;
    Multiples rest_of = z;
    rest_of[i] = rest_of[i] + (plus ? -1 : 1);
    const Expr b = bases[i], step = plus ? b : -b;
    Expr rest = 0;
    for (std::size_t j = 0; j < z.size(); ++j) rest = rest + Expr(rest_of[j]) * bases[j];
    const Pair before = pair(rest_of);
    const Substitution terms{{real("x"), rest}, {real("y"), step}};
    const Theorems rules{at("cos sum", terms),
                         at("sin sum", terms),
                         at("cos minus", {{real("x"), b}}),
                         at("sin minus", {{real("x"), b}}),
                         before.cosine,
                         before.sine};
    const Expr c = right(before.cosine), s = right(before.sine);
    const Expr sin_step = plus ? sin(b) : -sin(b);
    const auto expanded = [](Expr e) { return expression(polynomial(e)); };
    const Pair result{equation(cos(rest + step), expanded(c * cos(b) - s * sin_step), rules),
                      equation(sin(rest + step), expanded(s * cos(b) + c * sin_step), rules)};
    known.emplace(z, result);
    return result;
  }

private:
  Exprs bases;
  Theorems zeros;  ///< b = 0 |- b = 0
  std::map<Multiples, Pair> known;
};
}  // namespace

Theorems angles(const Exprs& terms, const Exprs& bases, bool circle) {
  AngleSums sums(bases);
  Exprs canonical_bases;
  for (const Expr& b : bases) canonical_bases.push_back(canonical(b));
  std::set<Expr> atoms;
  for (const Expr& t : terms)
    for (const auto& [monomial, q] : polynomial(t))
      for (const auto& [a, k] : monomial)
        if (is_call(a, "cos") || is_call(a, "sin")) atoms.insert(a);
  Theorems rules;
  for (const Expr& a : atoms) {
    if (is_among(a.arg(0), canonical_bases)) continue;
    const auto multiples = sums.multiples_of(a.arg(0));
    if (!multiples) continue;
    const auto pair = sums.pair(*multiples);
    const Theorem& t = a.name() == "cos" ? pair.cosine : pair.sine;
    rules.push_back(restate(eq(a, right(t)), t));
  }
  if (!circle) return rules;
  for (const Expr& b : bases)
    rules.push_back(arithmetic(eq(power(sin(b), 2), 1 - power(cos(b), 2)),
                               {.equations = {{1, at("circle", {{real("x"), b}})}}}));
  return rules;
}
Theorem same_angle(const Theorem& cosines, const Theorems& facts) {
  const Expr p = left(cosines).arg(0), q = right(cosines).arg(0);
  const auto not_above = [&](Expr l, Expr r) {
    return otherwise(le(l, r), {cosine_falls(assume(lt(r, l)), facts), cosines});
  };
  return linear(eq(p, q), {not_above(p, q), not_above(q, p)});
}

Theorem cosine_falls(const Theorem& less, const Theorems& facts) {
  const Expr p = left(less), q = right(less);
  const Theorem from = linear(le(0, p), facts), to = linear(le(q, pi()), facts);
  const auto falls = [&](const Theorem& below) {
    return at("cos falls", {{real("x"), p}, {real("y"), q}}, {from, below, to});
  };
  if (less.conclusion().op() == Op::Lt) return falls(less);
  const Expr goal = le(cos(q), cos(p));
  const auto below = [&](const Theorem& t) { return linear(goal, {falls(t)}); };
  return follows(
      goal, {given(lt(p, q), below), where_equal(p, q, goal, linear(le(cos(q), cos(q)))), less});
}
Theorem sine_not_negative(Expr t, const Theorems& facts) {
  const Expr goal = le(0, sin(t));
  const auto at_end = [&](Expr end) { return where_equal(t, end, goal, linear(le(0, sin(end)))); };
  const Theorem inside = given(logic_and({lt(0, t), lt(t, pi())}),
                               [&](const Theorem& where) { return not_negative(sin(t), {where}); });
  return follows(
      goal, {linear(logic_and({le(0, t), le(t, pi())}), facts), at_end(0), at_end(pi()), inside});
}
}  // namespace algebra
