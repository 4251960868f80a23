#include <unordered_map>

#include "algebra/tactics.hpp"

namespace algebra {
namespace {
/// m (r - l) as it is rewritten, with what the certificate needs: each step keeps
/// remainder = multipliers (r - l) - sum of cofactors (rule's right - left).
struct Search {
  Polynomial remainder;
  Theorems multipliers;
  std::vector<Polynomial> cofactors;

  bool rewrite_once(const Theorem& rule, Polynomial& cofactor) {
    const Polynomial& before = polynomial(left(rule));
    if (before.size() != 1 || before.begin()->second != 1)
      refuse("a rule rewrites a monomial, not " + text(left(rule)));
    Polynomial quotient;
    std::erase_if(remainder, [&](const auto& term) {
      const auto rest = divided(term.first, before.begin()->first);
      return rest && quotient.emplace(*rest, term.second).second;
    });
    if (quotient.empty()) return false;
    remainder = std::move(remainder) + quotient * polynomial(right(rule));
    cofactor = std::move(cofactor) - quotient;
    return true;
  }
  /// Multiplies by d for the youngest inv(d), d in `nonzero`.
  bool clear_once(const std::map<Expr, const Theorem*>& nonzero) {
    const Expr inverse = youngest_inverse(remainder, [&](Expr d) { return nonzero.count(d) != 0; });
    if (!inverse) return false;
    const Theorem& why = *nonzero.at(inverse.arg(0));
    const Polynomial& divisor = polynomial(inverse.arg(0));
    const bool same_sign = canonical(gap(why)) == inverse.arg(0);
    Polynomial cleared;
    for (const auto& [monomial, coefficient] : remainder) {
      const auto rest = divided(monomial, {{inverse, 1}});
      cleared = std::move(cleared) + (rest ? Polynomial{{*rest, coefficient}}
                                           : Polynomial{{monomial, coefficient}} * divisor);
    }
    remainder = same_sign ? cleared : scaled(cleared, -1);
    multipliers.push_back(why);
    for (Polynomial& q : cofactors) q = q * polynomial(gap(why));
    return true;
  }
};
}  // namespace

std::optional<Monomial> divided(const Monomial& monomial, const Monomial& by) {
  for (const auto& [a, k] : by)
    if (degree(monomial, a) < k) return {};
  Monomial quotient;
  quotient.reserve(monomial.size());
  for (const auto& [a, k] : monomial)
    if (const int j = degree(by, a); k > j) quotient.emplace_back(a, k - j);
  return quotient;
}
Expr gap(Expr relation) {
  static std::unordered_map<std::size_t, Expr> known;  // by id
  if (relation.op() == Op::Not) return gap(relation.arg(0));
  Expr& is = known[relation.id()];
  return is ? is : is = relation.arg(1) - relation.arg(0);
}

namespace {
struct Given {
  Theorems rules, divisors;
};
std::optional<Theorem> rewritten_to_0(Expr goal, const Theorems& factors, const Given& given,
                                      Polynomial& left_over,
                                      const std::function<Theorem(Expr)>& rest = {}) {
  const auto& [rules, nonzero] = given;
  Search search{polynomial(gap(goal)), factors, std::vector<Polynomial>(rules.size())};
  for (const Theorem& t : factors) search.remainder = search.remainder * polynomial(gap(t));
  std::map<Expr, const Theorem*> divisors;
  for (const Theorem& t : nonzero) {
    if (t.conclusion().op() == Op::Le) continue;
    divisors.emplace(canonical(gap(t)), &t);
    divisors.emplace(canonical(-gap(t)), &t);
  }
  constexpr int most_rounds = 2400;
  bool changed = true;
  for (int round = 0; changed && round < most_rounds; ++round) {
    changed = false;
    for (std::size_t i = 0; i < rules.size(); ++i)
      changed = search.rewrite_once(rules[i], search.cofactors[i]) || changed;
    changed = search.clear_once(divisors) || changed;
  }
  left_over = search.remainder;
  Certificate certificate{.multipliers = search.multipliers};
  if (!left_over.empty() && !rest) return {};
  if (!left_over.empty()) certificate.equations.emplace_back(-1, rest(expression(left_over)));
  for (std::size_t i = 0; i < rules.size(); ++i)
    if (!search.cofactors[i].empty())
      certificate.equations.emplace_back(expression(search.cofactors[i]), rules[i]);
  return certified(goal, certificate);
}
/// Squares of the roots and divisors that are seen to be positive.
Given found_in(Expr goal, const Given& given) {
  Given out = given;
  std::set<Expr> seen;
  for (const Theorem& t : given.rules)
    if (const Expr is = canonical(left(t)); is.op() == Op::Pow) seen.insert(is.arg(0));
  for (const Theorem& t : given.divisors) seen.insert(canonical(1 / gap(t)));
  std::vector<Expr> to_see{goal.arg(0), goal.arg(1)};
  for (const Theorem& t : given.rules + given.divisors) to_see.push_back(gap(t));
  while (!to_see.empty()) {
    const Polynomial next = polynomial(to_see.back());
    to_see.pop_back();
    for (const auto& [monomial, q] : next)
      for (const auto& [a, k] : monomial) {
        const bool root = is_call(a, "sqrt");
        if ((!root && !is_call(a, "inv")) || !seen.insert(a).second) continue;
        to_see.push_back(a.arg(0));
        if (const auto s = sign_of(a.arg(0), given.divisors, !root))
          (root ? out.rules : out.divisors).push_back(root ? root_squared(*s) : *s);
      }
  }
  return out;
}
}  // namespace

Theorem cancel(Expr goal, const Theorems& factors, const Theorems& facts, const Exprs& bases,
               const std::function<Theorem(Expr)>& rest) {
  const auto prove = [&](Expr g) { return cancel(g, factors, facts, bases, rest); };
  if (const auto all = by_parts(goal, prove)) return *all;
  Given given;
  for (const Theorem& t : parts(facts))
    (t.conclusion().op() == Op::Eq ? given.rules : given.divisors).push_back(t);
  if (!bases.empty()) {
    Exprs terms{goal.arg(0), goal.arg(1)};
    for (const Theorem& t : given.rules) terms.push_back(right(t));
    given.rules = given.rules + angles(terms, bases);
    for (const char* name : {"sin 0", "cos 0", "sin pi", "cos pi", "sin pi/2", "cos pi/2"})
      given.rules.push_back(axiom(name));
  }
  Polynomial left_over;
  if (const auto t = rewritten_to_0(goal, factors, given, left_over)) return *t;
  if (const auto t = rewritten_to_0(goal, factors, found_in(goal, given), left_over, rest))
    return *t;
  refuse("no proof found of " + text(goal) + "; left over: " + text(expression(left_over)));
}
Expr reduced(Expr term, Theorems facts) {
  std::erase_if(facts, [](const Theorem& t) { return t.conclusion().op() != Op::Eq; });
  Polynomial out;
  rewritten_to_0(eq(0, term), {}, {facts, {}}, out);
  return expression(out);
}
Theorem equation(Expr goal, const Theorems& facts, const Exprs& bases) {
  return cancel(goal, {}, facts, bases);
}
Theorem equation(Expr l, Expr r, const Theorems& facts, const Exprs& bases) {
  return equation(eq(l, r), facts, bases);
}
Theorem certified(Expr goal, Certificate c) {
  c.nonzero = c.nonzero + c.multipliers;
  return arithmetic(goal, c);
}
Theorem solved_for(Expr x, const Theorem& equation) {
  const Polynomial is = polynomial(x), off = polynomial(gap(equation));
  const auto term = off.find(is.begin()->first);
  if (term == off.end()) refuse(text(x) + " is no term of " + text(equation));
  const cln::cl_RA by = -1 / term->second;
  return arithmetic(eq(x, expression(is + scaled(off, by))), {.equations = {{by, equation}}});
}
Theorem chain(const Theorem& a, const Theorem& b) {
  return arithmetic(eq(left(a), right(b)), {.equations = {{1, a}, {1, b}}});
}
Theorem turned(const Theorem& e) {
  return arithmetic(eq(right(e), left(e)), {.equations = {{-1, e}}});
}
Theorems entries(const Theorem& e) {
  return parts({restate(logic_and(entry_equations(e.conclusion())), e)});
}
Theorem root_squared(const Theorem& not_negative) {
  const Expr x = right(not_negative);
  return at("root squared", {{real("x"), x}}, {linear(le(0, x), {not_negative})});
}
// r^n - l^n is the sum over odd k of binomial(n, k) (r - l)^k (l + r)^(n - k)/2^(n - 1).
Theorem by_powers(Expr goal, int n, const Theorems& facts) {
  const bool is_strict = goal.op() == Op::Lt;
  const Expr l = goal.arg(1), r = goal.arg(0), both = l + r;  // of the contrary
  const Theorem contrary = assume(is_strict ? le(l, r) : lt(l, r));
  Theorems sum;
  if (n % 2 == 0) sum = {linear(is_strict ? le(0, both) : lt(0, both), facts + Theorems{contrary})};
  Certificate powers;
  for (int k = 1; k <= n; k += 2)
    powers.products.push_back(
        {cln::binomial(unsigned(n), unsigned(k)) / cln::expt(cln::cl_RA(2), n - 1),
         Theorems(std::size_t(k), contrary) + sum, Exprs(std::size_t(n - k) / 2, both)});
  const Expr a = power(l, n), b = power(r, n);
  return otherwise(goal, facts + Theorems{arithmetic(is_strict ? le(a, b) : lt(a, b), powers)});
}
Theorem same_root(const Theorem& powers, const Theorems& signs) {
  const Expr a = left(powers).arg(0), b = right(powers).arg(0);
  const auto not_above = [&](Expr l, Expr r) {
    return by_powers(le(l, r), left(powers).exponent(), signs + Theorems{powers});
  };
  return linear(eq(a, b), {not_above(a, b), not_above(b, a)});
}
Theorem root_of(const Theorem& square, const Theorem& t_sign) {
  const Expr t = left(square).arg(0), x = right(square);
  const Theorem not_negative =
      arithmetic(le(0, x), {.equations = {{1, square}}, .products = {{1, {}, {t}}}});
  const Theorem root_sign = at("root not negative", {{real("x"), x}}, {not_negative});
  return same_root(chain(root_squared(not_negative), turned(square)), {root_sign, t_sign});
}
Theorem root_is(Expr x, Expr t, const Theorems& facts) {
  return root_of(equation(power(t, 2), x, facts), not_negative(t, facts));
}
}  // namespace algebra
