#include "equality/roots.hpp"

namespace equality {
namespace {
constexpr int highest_order = 24;
constexpr std::size_t most_bounds = 6;  // that are multiplied by one another

int order(Expr root) { return is_call(root, "abs") ? 2 : order_of(root); }
Expr by_facts(Expr e, const Theorems& facts) {
  e = kernel::canonical(e);
  for (auto is = facts.rbegin(); is != facts.rend(); ++is)  // outer roots first
    if (is->conclusion().op() == Op::Eq)
      e = kernel::canonical(
          kernel::replace(e, kernel::canonical(algebra::left(*is)), algebra::right(*is)));
  return e;
}
/// less < more or less <= more, from their squares.
std::optional<Theorem> is_less(Expr less, Expr more, const Theorems& facts) {
  for (auto is : {kernel::lt, kernel::le}) try {
      const Expr squares = is(kernel::power(less, 2), kernel::power(more, 2));
      const Theorems signs{algebra::not_negative(less, facts), algebra::not_negative(more, facts)};
      return algebra::by_powers(is(less, more), 2,
                                signs + Theorems{algebra::linear(squares, facts)});
    } catch (const kernel::Refused&) {
    }
  return {};
}
// Products of others would take long.
bool is_polynomial_bound(const Theorem& t) {
  const auto is_function = [](Expr e) { return e.op() == Op::Fun && !is_constant(e); };
  return is_bound(t) && std::ranges::none_of(parts_of(t.conclusion()), is_function);
}
// 0 < e or 0 <= e, of two terms by their squares, of a quadratic polynomial by others in it.
std::optional<Theorem> by_squares(Expr e, const Theorems& facts, const Theorems& of_constants) {
  for (bool strict : {true, false})
    if (const auto sign = algebra::sign_of(e, facts, strict)) return sign;
  for (Expr more : e.op() == Op::Add && e.size() == 2 ? e.args() : Exprs())
    if (const auto order = is_less(kernel::canonical(more - e), more, facts)) return order;
  Theorems bounds;
  std::ranges::copy_if(facts, std::back_inserter(bounds), is_polynomial_bound);
  const std::size_t count = bounds.size();
  for (std::size_t i = 0; i < count && count <= most_bounds; ++i)
    for (std::size_t k = 0; k < i; ++k) bounds.push_back(algebra::times(bounds[i], bounds[k]));
  if (count <= most_bounds)
    if (const auto sign = algebra::linear_if(kernel::le(0, e), bounds + of_constants)) return sign;
  for (Expr x : kernel::free_variables(e)) {
    const auto [a, b, c] = quadratic_in(e, x);
    const auto top = notation::rational_value(kernel::canonical(a));
    if (!top || *top <= 0) continue;
    const Expr square = kernel::power(x + Expr(1 / (2 * *top)) * b, 2);
    const Expr others = kernel::canonical(e - Expr(*top) * square);
    if (kernel::free_variables(others).contains(x)) continue;
    const auto rest = by_squares(others, {}, of_constants);
    if (!rest) continue;
    const bool is_strict = rest->conclusion().op() == Op::Lt;
    return algebra::linear(is_strict ? kernel::lt(0, e) : kernel::le(0, e),
                           {*rest, *algebra::sign_of(square, {}, false)});
  }
  return {};
}
/// x^(k/n) is the r with r^n = x^k and, if n is even, 0 <= r; abs(x) is (x^2)^(1/2).
Exprs definition(Expr root) {
  const int n = order(root), k = is_call(root, "abs") ? 2 : whole(*root_exponent(root));
  const Expr x = kernel::power(root.arg(0), std::abs(k));
  Exprs out{kernel::eq(kernel::power(root, n), k < 0 ? 1 / x : x)};
  if (n % 2 == 0) out.push_back(kernel::le(0, root));
  return out;
}
Theorem root_is(Expr root, Expr t, const Theorems& facts,
                const std::function<Theorem(Expr)>& rest = {}) {
  const Theorems is = algebra::assumed(definition(root));
  const Theorem power = algebra::cancel(
      kernel::eq(kernel::power(t, order(root)), algebra::right(is[0])), {}, facts, {}, rest);
  if (is_call(root, "sqrt")) return algebra::root_of(power, algebra::not_negative(t, facts));
  Theorems signs(is.begin() + 1, is.end());
  if (!signs.empty()) signs.push_back(algebra::not_negative(t, facts));
  return algebra::same_root(algebra::chain(is[0], algebra::turned(power)), signs);
}
}  // namespace

bool is_root(Expr e) {
  return is_call(e, "abs") || (root_exponent(e) && order_of(e) <= highest_order);
}
bool is_algebraic_term(Expr e) {
  if (e.op() == Op::Num || e.op() == Op::Var) return true;
  if (is_sine(e)) return multiple_of_pi(e.arg(0)).has_value();
  if (e.op() == Op::Fun && e.name() != "inv" && !is_root(e)) return false;
  return e.size() > 0 && std::ranges::all_of(e.args(), is_algebraic_term);
}

void Roots::add_factors(const Theorem& given) {
  const Expr is = given.conclusion(), t = is_bound(given) ? is.arg(1) : is.arg(0).arg(0);
  const Expr product = algebra::simplified(t);
  for (Expr f : product.op() == Op::Mul ? product.args() : Exprs{product})
    is_proved([&] {
      if (is_call(f, "inv")) f = f.arg(0);
      const int k = f.op() == Op::Pow ? f.exponent() : 1;
      if (f.op() == Op::Pow) f = f.arg(0);
      if (is_constant(f) || kernel::canonical(f) == kernel::canonical(t)) return false;
      const Expr rest = algebra::simplified(product / kernel::power(f, k));
      const Theorem same = algebra::equation(t, rest * kernel::power(f, k), facts);
      if (is_bound(given) && k % 2 != 0)
        if (const auto positive = algebra::sign_of(rest, facts)) {
          const Theorems factors(std::size_t(k), kernel::assume(kernel::lt(f, 0)));
          const Theorem less = algebra::product_of(factors + Theorems{*positive});
          facts.push_back(algebra::otherwise(kernel::le(0, f), {less, given, same}));
        }
      if (is.op() == Op::Le) return true;
      const Theorem is_0 = kernel::assume(kernel::eq(f, 0));
      const Expr cofactor = algebra::simplified(product / f);
      const Theorem zero =
          algebra::certified(kernel::eq(t, 0), {.equations = {{1, same}, {cofactor, is_0}}});
      facts.push_back(
          algebra::follows(kernel::neq(f, 0), {kernel::discharge(is_0.conclusion(), zero), given}));
      return true;
    });
}
Expr Roots::least_root(Expr x, int n) {
  if (n == 1) return x;
  const bool is_root = n % 2 != 0 && !algebra::sign_of(kernel::canonical(x), certain, false);
  return is_root ? notation::root(n, x) : forms.expression(atom(x, exponent(cln::cl_RA(1) / n)));
}
bool Roots::has_value(Expr root) const {
  const Expr x = root.arg(0);
  if (is_call(root, "abs") || is_call(x, "abs") || typed.contains(root)) return true;
  if (is_call(root, "root") && order(root) % 2 != 0) return true;
  return algebra::sign_of(kernel::canonical(x), certain, false).has_value();
}
void Roots::see(Expr e) {
  for (Expr part : e.args()) see(part);
  if (!is_root(e)) return;
  for (const auto& [product, q] : forms.of(e))
    for (const auto& [factor, power] : product) {
      cln::cl_I& order = orders.try_emplace(factor, 1).first->second;
      order = cln::lcm(order, cln::denominator(number_of(power).value_or(1)));
    }
}
std::optional<Expr> Roots::by_factors(Expr root) {
  const Sum sum = forms.of(root);
  if (sum.empty()) return Expr(0);
  if (sum.size() != 1) return {};
  Expr out = sum.begin()->second;
  for (const auto& [factor, power] : sum.begin()->first) {
    const auto e = number_of(power);
    const cln::cl_I order = orders[factor];
    if (!e || order == 0 || order > highest_order) return {};
    const int n = cln::cl_I_to_int(order), k = whole(*e * order);
    const bool is_abs = is_call(factor, "abs");
    if (is_abs && n % 2 != 0 && k % 2 == 0) {
      out = out * kernel::power(notation::root(n, factor.arg(0)), k);
      continue;
    }
    const Expr whole = kernel::power(least_root(factor, n), std::abs(k));
    out = k > 0 ? out * whole : out / whole;
  }
  return is_algebraic_term(out) ? std::optional(out) : std::nullopt;
}
// sqrt(a + b) and sqrt(a - b) are sqrt((a + d)/2) plus or minus sqrt((a - d)/2), d^2 = a^2 - b^2.
std::optional<Expr> Roots::of_sum(Expr root) {
  if (!is_call(root, "sqrt")) return {};
  const auto has_root = [](const auto& power) { return !whole_number(power.second); };
  Sum first, second;  // b is one root, or a multiple of it
  for (const auto& term : forms.of(root.arg(0)))
    (std::ranges::any_of(term.first, has_root) ? second : first).insert(term);
  if (first.empty() || second.size() != 1) return {};
  const Expr a = forms.expression(first), b = forms.expression(second);
  Expr d = forms.expression(forms.of(kernel::sqrt(kernel::power(a, 2) - kernel::power(b, 2))));
  for (Expr part : parts_of(d)) {
    if (is_call(part, "abs")) d = kernel::replace(d, part, part.arg(0));
    if (is_call(part, "sqrt")) return {};
  }
  const auto half = [&](Expr e) { return kernel::sqrt(kernel::canonical((a + e) / 2)); };
  const Expr more = half(d), less = half(-d);
  if (second.begin()->second > 0) return more + less;
  if (const auto falls = is_less(less, more, facts)) facts.push_back(*falls);
  return more - less;
}
std::optional<Expr> Roots::of_signed(Expr root) {
  if (!is_call(root, "abs")) return {};
  const Expr x = root.arg(0), product = algebra::simplified(x);
  add_sign(kernel::canonical(x));
  for (Expr t : {x, -x, product, -product})
    if (algebra::sign_of(kernel::canonical(t), facts, false) || algebra::sign_of(t, facts, false))
      return t;
  return {};
}
/// By roots of factors, as the n-th root of x^n is x or |x|.
std::optional<Expr> Roots::of_product(Expr root) {
  const Expr x = root.arg(0), product = algebra::simplified(x);
  const bool is_even = !is_call(root, "abs") && order(root) % 2 == 0;
  Expr out = 1;
  for (Expr f : product.op() == Op::Mul ? product.args() : Exprs{product}) {
    const bool is_inverse = is_call(f, "inv");
    if (is_inverse) f = f.arg(0);
    const int k = f.op() == Op::Pow ? f.exponent() : 1;
    if (k > 1) f = f.arg(0);
    if (k == 1 && !is_inverse && notation::rational_value(algebra::simplified(product / f)))
      return {};
    if (is_even && k % 2 == 0) f = absolute(f);
    if (is_even && k % 2 != 0 && !algebra::sign_of(kernel::canonical(f), facts, false)) return {};
    const bool is_odd = !is_even && !is_call(root, "abs");
    const Expr one = is_odd ? notation::root(order(root), f) : kernel::replace(root, x, f);
    const Expr part =
        kernel::power(one, is_odd ? k * whole(*root_exponent(root) * order(root)) : k);
    out = is_inverse ? out / part : out * part;
  }
  return out;
}
/// Bounds of a root of a number, and its equation.
void Roots::enclose(Expr root) {
  const Exprs defined = definition(root);
  const Expr base = defined[0].arg(1), plain = algebra::reduced(base, facts);
  if (plain == Expr(0)) return facts.push_back(root_is(root, 0, facts));
  const Theorem same = algebra::equation(base, plain, facts);
  Theorems is = algebra::assumed(defined);
  if (is_call(root, "sqrt")) {
    const Theorem above = algebra::linear(kernel::le(0, base), {same, bounds.of(plain).above});
    is = {algebra::root_squared(above),
          algebra::at("root not negative", {{kernel::real("x"), base}}, {above})};
  }
  is[0] = algebra::chain(is[0], same);
  bounds.add_root(is[0], Theorems(is.begin() + 1, is.end()));
  facts.push_back(is[0]);
  const Expr canonical = kernel::canonical(root);
  if (const auto sign = algebra::sign_of(canonical, {bounds.of(canonical).above}))
    facts.push_back(*sign);
}
void Roots::add(Expr e) {
  for (Expr part : e.args()) add(part);
  for (Expr sum : e.op() == Op::Fun ? parts_of(e) : Exprs()) add_sum(sum);
  if (!is_root(e) || !seen.insert(kernel::canonical(e)).second) return;
  const Exprs is = definition(e);
  if (!is_call(e, "sqrt") && has_value(e)) definitions.insert(is.begin(), is.end());
  for (auto simpler : {&Roots::of_signed, &Roots::of_sum, &Roots::by_factors, &Roots::of_product})
    if (!is_plain && is_proved([&] {
          const auto t = (this->*simpler)(e);
          if (!t || kernel::replace(*t, e, 0) != *t) return false;
          see(*t);
          add(*t);
          add_sign(*t);
          facts.push_back(root_is(e, *t, facts));
          if (const auto sign = algebra::sign_of(kernel::canonical(*t), facts))
            facts.push_back(algebra::linear(kernel::lt(0, e), {*sign, facts.back()}));
          return true;
        }))
      return add_sign_of(e);
  others.push_back(e);
  if (is_constant(e) && is_proved([&] { return enclose(e), true; })) return;
  if (is_call(e, "sqrt")) return;
  Theorems known = algebra::assumed(is);
  for (bool strict : {false, true})
    if (const auto sign = algebra::sign_of(is[0].arg(1), facts, strict)) {
      const Expr goal = strict ? kernel::lt(0, e) : kernel::le(0, e);
      known.push_back(algebra::by_powers(goal, order(e), known + Theorems{*sign}));
    }
  facts = facts + known;
  const Theorem base = algebra::turned(known[0]);
  is_proved([&] { return facts.push_back(algebra::positive(base, facts)), true; });
}
void Roots::add_sum(Expr sum) {
  if (sum.op() != Op::Add || is_constant(sum) || !seen.insert(sum).second) return;
  Theorems of_constants;
  for (Expr part : parts_of(sum))
    is_proved([&] {
      if (!is_constant(part) || part.op() != Op::Fun) return false;
      const Expr plain = algebra::reduced(part, facts);
      const Theorem same = algebra::equation(part, plain, facts);
      const auto& near = bounds.of(plain);
      return of_constants = of_constants + Theorems{same, near.above, near.below}, true;
    });
  for (Expr side : {sum, kernel::canonical(-sum)})
    if (const auto sign = by_squares(side, signs, of_constants)) {
      signs.push_back(*sign);
      facts.push_back(*sign);
    }
}
void Roots::add_sign_of(Expr root) {  // by that of its base
  const Theorems is = algebra::assumed(definition(root));
  if (is_call(root, "sqrt")) return;
  if (is.size() > 1) return facts.push_back(is[1]);
  for (Expr side : {root, -root})
    is_proved([&] {
      const Expr base = side == root ? algebra::right(is[0]) : -algebra::right(is[0]);
      const Theorems known{is[0], algebra::not_negative(base, facts)};
      return facts.push_back(algebra::by_powers(kernel::le(0, side), order(root), known)), true;
    });
}
bool Roots::add_sign(Expr constant) {
  return is_constant(constant) &&
         is_proved([&] { return facts.push_back(bounds.sign(constant)), true; });
}
bool Roots::solve_for_one(Expr goal, const std::function<Theorem(Expr)>& rest) {
  const Expr equation = kernel::eq(by_facts(goal.arg(0) - goal.arg(1), facts), 0);
  const auto is_solved = [&](Expr root) {
    const Expr unknown = by_facts(root, facts);
    const Expr value = algebra::solve({equation}, {unknown})[0];
    if (kernel::replace(value, unknown, 0) != value) return false;
    add_sign(value);
    facts.push_back(root_is(root, value, facts, rest));
    return true;
  };
  return std::any_of(others.rbegin(), others.rend(),
                     [&](Expr root) { return is_proved([&] { return is_solved(root); }); });
}
}  // namespace equality
