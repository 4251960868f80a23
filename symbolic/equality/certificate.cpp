// What the kernel proves again: equations of terms of +, *, /, roots and sines of parts of pi.
#include "equality/normal_form.hpp"

namespace equality {
using algebra::operator+;
using algebra::Theorem;
using algebra::Theorems;
namespace {
constexpr std::size_t heaviest = 400;
constexpr int highest_order = 24, most_multiplied_out = 24;
constexpr int most_of_pi = 64, most_of_odd = 36;  // powers of primes d of pi/d
constexpr int most_work = 100;

bool is_sine(Expr e) { return is_call(e, "sin") || is_call(e, "cos"); }
bool is_constant(Expr e) { return kernel::free_variables(e).empty(); }
int order(Expr root) { return is_call(root, "abs") ? 2 : order_of(root); }
bool is_root(Expr e) {
  return is_call(e, "abs") || (root_exponent(e) && order_of(e) <= highest_order);
}
bool is_algebraic_term(Expr e) {
  if (e.op() == Op::Num || e.op() == Op::Var) return true;
  if (is_sine(e)) return multiple_of_pi(e.arg(0)).has_value();
  if (e.op() == Op::Fun && e.name() != "inv" && !is_root(e)) return false;
  return e.size() > 0 && std::ranges::all_of(e.args(), is_algebraic_term);
}
Expr formula(const Requirement& r) {
  return r.kind == Need::NotZero       ? kernel::neq(r.term, 0)
         : r.kind == Need::NotNegative ? kernel::le(0, r.term)
                                       : kernel::lt(0, r.term);
}
std::string shown(Expr f) {
  if (f.op() == Op::Eq) return notation::typed_text(f);
  if (f.op() == Op::Not) return notation::typed_text(f.arg(0).arg(0)) + " != 0";
  return notation::typed_text(f.arg(1)) + (f.op() == Op::Le ? " >= 0" : " > 0");
}
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
/// Facts of the roots of both sides: of those of one factor by the least, as 4^(1/3) is 2^(1/3)^2.
struct Roots {
  Forms forms;
  std::map<Expr, cln::cl_I> orders = {};  // of each factor
  std::set<Expr> seen = {};
  Exprs others = {};  // that are not known by simpler ones
  std::set<Expr> definitions = {};
  Theorems facts = {};
  Enclosures bounds{facts};  // of roots of numbers and cosines

  void see(Expr e) {
    for (Expr part : e.args()) see(part);
    if (!is_root(e)) return;
    for (const auto& [product, q] : forms.of(e))
      for (const auto& [factor, power] : product) {
        cln::cl_I& order = orders.try_emplace(factor, 1).first->second;
        order = cln::lcm(order, cln::denominator(number_of(power).value_or(1)));
      }
  }
  std::optional<Expr> by_factors(Expr root) {
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
      const Expr other = kernel::canonical(-(is_abs ? factor.arg(0) : factor));
      const bool is_turned = (is_abs || n == 1) && algebra::sign_of(other, facts, false);
      const Expr of = is_turned ? other : factor;
      const Expr whole = kernel::power(least_root(of, n), std::abs(k));
      if (is_turned && !is_abs && k % 2 != 0) out = -out;
      out = k > 0 ? out * whole : out / whole;
    }
    return is_algebraic_term(out) ? std::optional(out) : std::nullopt;
  }
  // sqrt(a + b) and sqrt(a - b) are sqrt((a + d)/2) plus or minus sqrt((a - d)/2), d^2 = a^2 - b^2.
  std::optional<Expr> of_sum(Expr root) {
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
  Expr least_root(Expr x, int n) { return forms.expression(atom(x, exponent(cln::cl_RA(1) / n))); }
  /// Of a number, by roots of factors and, as the n-th root of x^n is x or -x, by bounds of x.
  Expr root_of(Expr x, int n) {
    const auto is_square = [](Expr f) { return f.op() == Op::Pow && f.exponent() % 2 == 0; };
    const bool is_abs = is_call(x, "abs");
    const Expr inside = is_abs ? x.arg(0) : x;
    if (is_call(x, "inv")) return 1 / root_of(x.arg(0), n);
    if (inside.op() == Op::Mul &&
        (n % 2 != 0 || is_abs || std::ranges::all_of(inside.args(), is_square))) {
      Expr out = 1;
      for (Expr f : inside.args()) out = out * root_of(is_abs ? absolute(f) : f, n);
      return out;
    }
    if (x.op() != Op::Pow || (n % 2 == 0 && x.exponent() % n != 0)) return least_root(x, n);
    const Expr t = x.arg(0);
    if (n % 2 != 0) return kernel::power(root_of(t, n), x.exponent());
    return kernel::power(bounds.sign(t).conclusion().arg(0) == t ? -t : t, x.exponent() / n);
  }
  std::optional<Expr> of_number(Expr root) {
    if (!is_constant(root)) return {};
    if (is_call(root, "abs")) return root_of(kernel::power(root.arg(0), 2), 2);
    const int n = order(root), k = whole(*root_exponent(root));
    const Expr t = kernel::power(root_of(root.arg(0), n), std::abs(k));
    return k > 0 ? t : 1 / t;
  }
  std::optional<Expr> of_signed(Expr root) {
    for (Expr t : is_call(root, "abs") ? Exprs{root.arg(0), -root.arg(0)} : Exprs())
      if (algebra::sign_of(kernel::canonical(t), facts, false)) return t;
    return {};
  }
  std::optional<Expr> of_inverse(Expr root) {  // sqrt(1/u) is 1/sqrt(u)
    const Expr x = kernel::canonical(root.arg(0));
    const Expr u = kernel::canonical(algebra::simplified(1 / x));
    const auto parts = parts_of(u);
    const bool has_inverse = std::ranges::any_of(parts, [](Expr e) { return is_call(e, "inv"); });
    if (!is_call(root, "sqrt") || has_inverse || u.weight() >= x.weight()) return {};
    const auto of = kernel::polynomial(u);
    const Expr q = of.size() == 1 ? Expr(cln::abs(of.begin()->second)) : Expr(1);
    return 1 / (kernel::sqrt(q) * kernel::sqrt(kernel::canonical(u / q)));
  }
  /// Bounds of a root of a number, and its equation.
  void enclose(Expr root) {
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
  void add(Expr e) {
    for (Expr part : e.args()) add(part);
    if (!is_root(e) || !seen.insert(kernel::canonical(e)).second) return;
    const Exprs is = definition(e);
    if (!is_call(e, "sqrt")) definitions.insert(is.begin(), is.end());
    for (auto simpler : {&Roots::of_number, &Roots::of_signed, &Roots::of_sum, &Roots::by_factors,
                         &Roots::of_inverse})
      if (is_proved([&] {
            const auto t = (this->*simpler)(e);
            if (!t || kernel::canonical(*t) == kernel::canonical(e)) return false;
            see(*t);
            add(*t);
            add_sign(*t);
            facts.push_back(root_is(e, *t, facts));
            return true;
          }))
        return;
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
  bool add_sign(Expr constant) {
    return is_constant(constant) &&
           is_proved([&] { return facts.push_back(bounds.sign(constant)), true; });
  }
  /// One root as both sides are equal, if it is that: two could be written by one another.
  bool solve_for_one(Expr goal, const std::function<Theorem(Expr)>& rest) {
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
};
// 0 < e or 0 <= e, of two terms by their squares, of a quadratic polynomial by others in it.
std::optional<Theorem> by_squares(Expr e, const Theorems& facts) {
  for (bool strict : {true, false})
    if (const auto sign = algebra::sign_of(e, facts, strict)) return sign;
  for (Expr more : e.op() == Op::Add && e.size() == 2 ? e.args() : Exprs())
    if (const auto order = is_less(kernel::canonical(more - e), more, facts)) return order;
  for (Expr x : kernel::free_variables(e)) {
    const auto [a, b, c] = quadratic_in(e, x);
    const auto top = notation::rational_value(kernel::canonical(a));
    if (!top || *top <= 0) continue;
    const Expr square = kernel::power(x + Expr(1 / (2 * *top)) * b, 2);
    const Expr others = kernel::canonical(e - Expr(*top) * square);
    if (kernel::free_variables(others).contains(x)) continue;
    const auto rest = by_squares(others, {});
    if (!rest) continue;
    const bool is_strict = rest->conclusion().op() == Op::Lt;
    return algebra::linear(is_strict ? kernel::lt(0, e) : kernel::le(0, e),
                           {*rest, *algebra::sign_of(square, {}, false)});
  }
  return {};
}
// How often q has 1/d for each power of a prime, of 2 the halves that are left: 9/20 = 1/4 + 1/5.
using Shares = std::map<int, cln::cl_RA>;
Shares shares(const cln::cl_RA& q) {
  Shares out;
  cln::cl_RA left = q;
  cln::cl_I others = cln::denominator(q);
  for (int p = 2; others > 1; ++p) {
    cln::cl_I d = 1;
    for (; cln::mod(others, p) == 0; d = d * p) others = cln::exquo(others, p);
    if (p > most_of_pi || d > most_of_pi) kernel::refuse("no parts of pi so small");
    if (d == 1) continue;
    const cln::cl_I rest = cln::exquo(cln::denominator(q), d), step = p == 2 ? cln::exquo(d, 2) : d;
    cln::cl_I a = 0;
    while (cln::mod(a * rest - cln::numerator(q), d) != 0) a = a + 1;
    a = a - cln::round1(a / cln::cl_RA(step)) * step;
    if (a != 0) out[cln::cl_I_to_int(d)] = a;
    left = left - a / cln::cl_RA(d);
  }
  if (cln::abs(left) > most_of_pi) kernel::refuse("too many turns");
  out[2] = cln::numerator(2 * left);
  return out;
}
// How much there is to multiply out of roots, and of sines of pi/d.
cln::cl_I work(Expr e) {
  if (is_root(e)) return 1;
  cln::cl_I sum = 0;
  if (is_sine(e)) {
    for (const auto& [d, a] : shares(*multiple_of_pi(e.arg(0))))
      sum = sum + (d == 2 ? cln::cl_I(0) : cln::numerator(cln::abs(a)));
    return sum;
  }
  for (Expr part : e.args()) sum = sum + work(part);
  return e.op() == Op::Pow ? sum * e.exponent() : sum;
}
// Sums to high powers are names, for they are not multiplied out; each as it came first.
void name_bases(Expr e, kernel::Substitution& names, Theorems& turned) {
  if (e.op() == Op::Pow && e.exponent() > most_multiplied_out && e.arg(0).op() == Op::Add &&
      e.arg(0).sort() == kernel::Sort::Real && !is_constant(e)) {
    for (const auto& [name, base] : names)
      for (Expr same : {base, -base})
        if (kernel::canonical(same) == kernel::canonical(e.arg(0)))
          return turned.push_back(algebra::linear(kernel::eq(same, e.arg(0))));
    names.emplace(kernel::real("base_" + std::to_string(names.size())), e.arg(0));
  }
  for (Expr part : e.args()) name_bases(part, names, turned);
}
// cos(t)^n in lower powers, t = pi/d: sin(nt) = sin((n + 1)t), and both are sin(t) times
// polynomials in cos(t).
Theorem power_of_cosine(int d) {
  const Expr x = kernel::real("x"), pi = kernel::pi(), t = pi / d, c = kernel::cos(t),
             s = kernel::sin(t);
  const int n = d / 2;
  Expr before = 0, u = 1;
  for (int k = 0; k < n; ++k) before = std::exchange(u, kernel::canonical(2 * c * u - before));
  const Theorem mirror = algebra::equation(kernel::sin(x), kernel::sin(pi - x), {}, {pi, x});
  const Theorem same = algebra::at(mirror, {{x, n * t}});
  const Theorem is = algebra::equation(algebra::gap(same), s * (u - before), {}, {t});
  const algebra::Certificate proof{.equations = {{-1, same}, {-1, is}},
                                   .multipliers = {algebra::positive(s)}};
  return algebra::solved_for(kernel::power(c, n),
                             algebra::certified(kernel::eq(u - before, 0), proof));
}
// A sine of q pi by those of pi/2 and of pi/d, its shares.
Theorem in_parts(Expr sine, const Shares& parts) {
  const Expr quarter = kernel::pi() / 2;
  Exprs bases{quarter};
  kernel::Substitution at;
  Expr angle = Expr(parts.at(2)) * quarter;
  for (const auto& [d, a] : parts) {
    if (d == 2) continue;
    const Expr x = bases.emplace_back(kernel::real("x_" + std::to_string(d)));
    at.emplace(x, kernel::pi() / d);
    angle = angle + Expr(a) * x;
  }
  const Expr by_names = kernel::replace(sine, sine.arg(0), angle);
  const Theorems rules = algebra::angles({by_names}, bases);
  if (rules.size() == bases.size()) kernel::refuse("is a base");
  const Theorem is =
      algebra::at(algebra::equation(by_names, algebra::reduced(by_names, rules), rules), at);
  return kernel::restate(kernel::eq(sine, algebra::right(is)), is);
}
void add_part(int d, Roots& roots) {
  const Expr t = kernel::pi() / d;
  if (d % 2 == 0 || d < 7) {
    const auto part = algebra::part_of_pi(d);
    const Expr both = algebra::right(part->cosine) + algebra::right(part->sine);
    roots.facts = roots.facts + Theorems{part->cosine, part->sine} + part->signs;
    roots.see(both);
    return roots.add(both);
  }
  const Theorem cosine = power_of_cosine(d), circle = algebra::angles({}, {t})[0];
  roots.facts = roots.facts + Theorems{cosine, circle};
  roots.bounds.add_cosine(d, cosine);
  roots.bounds.add_root(circle, {algebra::not_negative(kernel::sin(t))});
}
// Sines of multiples of pi by those of its parts, where they are not too much.
void add_sines(Expr e, Roots& roots) {
  Theorems turns{kernel::axiom("cos pi/2"), kernel::axiom("sin pi/2")};
  std::set<int> all;
  const bool is_long = !is_proved([&] { return work(e) <= most_work; });
  for (Expr sine : parts_of(e)) {
    if (!is_sine(sine) || !is_algebraic_term(sine)) continue;
    const bool is_in_parts = is_proved([&] {
      const Shares parts = shares(*multiple_of_pi(sine.arg(0)));
      if (is_long && work(sine) > 1) return false;
      for (const auto& [d, a] : parts)
        if (d != 2 && (d % 2 == 0 || d < most_of_odd)) all.insert(d);
      return turns.push_back(in_parts(sine, parts)), true;
    });
    if (!is_in_parts) turns = algebra::angles({}, {sine.arg(0)}) + turns;
  }
  for (int d : all) add_part(d, roots);
  roots.facts = roots.facts + turns;
}
}  // namespace

std::string text(const Requirement& r) { return shown(formula(r)); }
std::string certified(Expr asked, const Exprs& given, std::vector<Requirement> needs,
                      const Domain& domain) {
  Exprs goals{asked};
  for (Expr is : given) goals.push_back(kernel::substitute(goals.back(), {{is.arg(0), is.arg(1)}}));
  const Expr left = goals.back().arg(0), right = goals.back().arg(1);
  if (!is_algebraic_term(left - right))
    kernel::refuse("certifies +, *, quotients, roots and sines of parts of pi alone");
  if (left.weight() + right.weight() > heaviest) kernel::refuse("certifies no sides so long");
  kernel::Substitution bases;
  Theorems turned;
  name_bases(left - right, bases, turned);
  const auto named = [&](Expr e) {
    for (const Theorem& is : turned) e = kernel::replace(e, algebra::right(is), algebra::left(is));
    for (const auto& [name, base] : bases) e = kernel::replace(e, base, name);
    return e;
  };
  std::ranges::copy(conditions(domain), std::back_inserter(needs));
  for (const auto& [x, range] : domain.ranges)
    for (const auto& [end, side] : {std::pair(range.low, 1), {range.high, -1}})
      if (end)
        needs.push_back({end->is_inside ? Need::NotNegative : Need::Positive,
                         kernel::canonical(Expr(side) * (x - Expr(end->value)))});
  for (Requirement& r : needs) r.term = named(r.term);
  std::string theorem;
  is_proved([&] {
    const Expr goal = kernel::eq(named(left), named(right)), both = goal.arg(0) - goal.arg(1);
    Roots roots{Forms(narrowed(domain, needs))};
    Theorems& facts = roots.facts;
    for (int pass = 0; pass < 2; ++pass)  // a sign found late names earlier terms anew
      for (const Requirement& r : needs) is_proved([&] { return roots.forms.assume(r), true; });
    for (const Requirement& r : needs)
      if (!is_constant(r.term)) facts.push_back(kernel::assume(formula(r)));
    for (Expr e : parts_of(goal)) {
      if (e.op() != Op::Add || is_constant(e)) continue;
      for (Expr side : {e, kernel::canonical(-e)})
        if (const auto sign = by_squares(side, facts)) facts.push_back(*sign);
    }
    is_proved([&] { return roots.see(both), true; });
    add_sines(both, roots);
    roots.add(both);
    for (const Requirement& r : needs) {
      if (!is_constant(r.term)) continue;
      const bool is_sure = roots.add_sign(r.term);
      if (!is_sure || r.kind != Need::NotZero) facts.push_back(kernel::assume(formula(r)));
    }
    std::optional<Theorem> found;
    const auto is_found = [&](const std::function<Theorem(Expr)>& rest) {
      const auto find = [&] {
        return is_proved([&] { return found = algebra::cancel(goal, {}, facts, {}, rest), true; });
      };
      const Theorems before = facts;
      if (find() || (roots.solve_for_one(goal, rest) && find())) return true;
      facts = before;
      return false;
    };
    const auto by_powers = [&](Expr sum) { return vanishes(sum, facts, roots.bounds); };
    if (!is_found({}) && !is_found(by_powers)) return false;
    Theorem proved = *found;
    for (Expr h : proved.hypotheses())
      if (std::ranges::find(needs, h, formula) == needs.end() && !roots.definitions.contains(h))
        return false;  // a hypothesis that nobody is told of
    if (!bases.empty()) proved = kernel::instantiate(proved, bases);
    for (const Theorem& is : turned) proved = kernel::rewrite(is, proved);
    for (std::size_t i = given.size(); i-- > 0;)
      proved = kernel::tautology(
          goals[i], {kernel::assume(given[i]),
                     algebra::where_equal(given[i].arg(0), given[i].arg(1), goals[i], proved)});
    for (Expr h : proved.hypotheses()) theorem += (theorem.empty() ? "" : ", ") + shown(h);
    theorem += (theorem.empty() ? "" : " |- ") + notation::typed_text(asked);
    return true;
  });
  if (theorem.empty()) kernel::refuse("found no proof");
  return theorem;
}
}  // namespace equality
