#include "algebra/tactics.hpp"

namespace algebra {
namespace {
/// 0 < t or 0 <= t, t being a sum of products.
Theorem shown(Expr t, bool strict, const std::vector<Certificate::Product>& products) {
  return arithmetic(strict ? lt(0, t) : le(0, t), {.products = products});
}
const Theorem& root_positive() {  // |- 0 < x implies 0 < sqrt(x)
  static const Theorem result = [] {
    const Expr x = real("x");
    const Theorem positive = assume(lt(0, x)), weak = linear(le(0, x), {positive});
    return discharge(
        lt(0, x), by_powers(lt(0, sqrt(x)), 2,
                            {positive, root_squared(weak), at("root not negative", {}, {weak})}));
  }();
  return result;
}

std::optional<Theorem> sign(Expr t, const Theorems& facts, bool strict);

std::optional<Theorem> sign_of_function(Expr t, const Theorems& facts, bool strict) {
  if (t.name() == "pi") return axiom("pi positive");
  if (t.size() != 1) return {};
  const Substitution of_t{{real("x"), t.arg(0)}};
  const bool inverse = t.name() == "inv", root = t.name() == "sqrt";
  if (inverse || root || (t.name() == "atan" && strict)) {
    const auto s = sign(t.arg(0), facts, strict || inverse);
    if (!s) return {};
    if (inverse) return certified(lt(0, t), {.products = {{1}}, .multipliers = {*s}});
    if (!root) return at("atan positive", of_t, {*s});
    return strict ? at(root_positive(), of_t, {*s}) : at("root not negative", of_t, {*s});
  }
  if (t.name() == "sin" || t.name() == "cos") {
    const Expr y = t.arg(0);
    const auto from = linear_if(lt(0, y), facts);
    if (!from) return {};
    const auto below = linear_if(lt(y, t.name() == "sin" ? pi() : pi() / 2), facts);
    if (!below) return {};
    const Theorem above = t.name() == "sin" ? at("sin positive", of_t, {*from, *below})
                                            : linear(lt(0, t), {cosine_falls(*below, {*from})});
    return strict ? above : linear(le(0, t), {above});
  }
  return {};
}
std::optional<Theorem> sign_of_sum(Expr t, const Theorems& facts, bool strict) {
  std::vector<Certificate::Product> products;
  bool some_strict = false;
  for (const Expr& a : t.args()) {
    auto s = strict && !some_strict ? sign(a, facts, true) : std::nullopt;
    some_strict = some_strict || s;
    if (!s) s = sign(a, facts, false);
    if (!s) return {};
    products.push_back({1, {*s}, {}});
  }
  if (strict && !some_strict) return {};
  return shown(t, strict, products);
}
std::optional<Theorem> sign_of_product(Expr t, const Exprs& of, const Theorems& facts,
                                       bool strict) {
  Theorems factors;
  cln::cl_RA coefficient = 1;
  for (const Expr& a : of) {
    if (a.op() == Op::Num && a.value() > 0) {
      coefficient = coefficient * a.value();
      continue;
    }
    const auto s = sign(a, facts, strict);
    if (!s) return {};
    factors.push_back(*s);
  }
  return shown(t, strict, {{coefficient, factors}});
}
std::optional<Theorem> sign_of_power(Expr t, const Theorems& facts, bool strict) {
  const auto count = static_cast<std::size_t>(t.exponent());
  if (!strict && count % 2 == 0) return shown(t, false, {{1, {}, Exprs(count / 2, t.arg(0))}});
  return sign_of_product(t, Exprs(count, t.arg(0)), facts, strict);
}
std::optional<Theorem> by_shape(Expr t, const Theorems& facts, bool strict) {
  switch (t.op()) {
    case Op::Num:
      if (t.value() < 0 || (strict && t.value() == 0)) return {};
      return shown(t, strict, {{t.value()}});
    case Op::Add:
      return sign_of_sum(t, facts, strict);
    case Op::Mul:
      return sign_of_product(t, t.args(), facts, strict);
    case Op::Pow:
      return sign_of_power(t, facts, strict);
    case Op::Fun:
      return sign_of_function(t, facts, strict);
    default:
      return {};
  }
}
std::optional<Theorem> sign(Expr t, const Theorems& facts, bool strict) {
  for (const Theorem& f : facts + known()) {
    const Op op = f.conclusion().op();
    if (strict && op == Op::Not && canonical(f.conclusion()) == canonical(neq(t, 0)))
      if (const auto weak = sign(t, facts, false)) return follows(lt(0, t), {f, *weak});
    if (op != Op::Lt && (strict || op != Op::Le)) continue;
    if (canonical(gap(f)) == canonical(t)) return shown(t, strict, {{1, {f}}});
  }
  if (auto s = by_shape(t, facts, strict)) return s;
  if (t.op() == Op::Num) return {};
  return linear_if(strict ? lt(0, t) : le(0, t), facts);
}
}  // namespace

std::optional<Theorem> sign_of(Expr t, const Theorems& facts, bool strict) {
  return sign(t, parts(facts), strict);
}
Theorem positive(Expr t, const Theorems& facts) {
  if (const auto s = sign_of(t, facts)) return *s;
  refuse("cannot see that 0 < " + text(t));
}
Theorem positive(const Theorem& is, const Theorems& facts) {
  return linear(lt(0, left(is)), {is, positive(right(is), facts)});
}
Theorem not_negative(Expr t, const Theorems& facts) {
  if (const auto s = sign_of(t, facts)) return linear(le(0, t), {*s});
  if (const auto s = sign_of(t, facts, false)) return linear(le(0, t), {*s});
  refuse("cannot see that 0 <= " + text(t));
}
Theorem product_of(const Theorems& factors) {
  Expr t = 1;
  bool strict = true;
  for (const Theorem& f : factors) {
    t = t * gap(f);
    strict = strict && f.conclusion().op() == Op::Lt;
  }
  return shown(t, strict, {{1, factors}});
}
Theorem times(const Theorem& a, const Theorem& b) { return product_of({a, b}); }
Theorem times(const Theorem& a, Expr positive_term) { return times(a, positive(positive_term)); }
}  // namespace algebra
