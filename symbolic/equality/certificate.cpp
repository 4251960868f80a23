// What the kernel proves again: equations of terms of +, *, /, roots and sines of parts of pi.
#include "equality/roots.hpp"

namespace equality {
namespace {
constexpr std::size_t heaviest = 400;
constexpr int most_multiplied_out = 24;
constexpr int most_of_pi = 64, most_of_odd = 36;  // powers of primes d of pi/d
constexpr int most_work = 100;

Expr formula(const Requirement& r) {
  return r.kind == Need::NotZero       ? kernel::neq(r.term, 0)
         : r.kind == Need::NotNegative ? kernel::le(0, r.term)
                                       : kernel::lt(0, r.term);
}
Theorems assumptions(const std::vector<Requirement>& needs) {
  Theorems out;
  for (const Requirement& r : needs) out.push_back(kernel::assume(formula(r)));
  return out;
}
std::string shown(Expr f) {
  if (f.op() == Op::Eq) return notation::typed_text(f);
  if (f.op() == Op::Not) return notation::typed_text(f.arg(0).arg(0)) + " != 0";
  return notation::typed_text(f.arg(1)) + (f.op() == Op::Le ? " >= 0" : " > 0");
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
// cos(t)^n, t = pi/d, in lower powers: sin(nt) = sin((n + 1)t), by sin(t) polynomials in cos(t).
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
// l = r, added to the facts, from n-th powers of both and their signs.
bool is_same_by_powers(Expr l, Expr r, Theorems& facts) {
  const auto is_by = [&](int n) {
    Theorems signs;
    if (n % 2 == 0) signs = {algebra::not_negative(l, facts), algebra::not_negative(r, facts)};
    const Expr powers = kernel::eq(kernel::power(l, n), kernel::power(r, n));
    return facts.push_back(algebra::same_root(algebra::cancel(powers, {}, facts), signs)), true;
  };
  const auto orders = {2, 3, 4, 6, 12};
  return std::ranges::any_of(orders, [&](int n) { return is_proved([&] { return is_by(n); }); });
}
// The same of terms of l - r that have one form, but for a factor.
void add_terms(Expr difference, Roots& roots) {
  Exprs units;
  for (const auto& [monomial, q] : kernel::Polynomial(kernel::polynomial(difference)))
    units.push_back(kernel::expression({{monomial, 1}}));
  for (std::size_t i = 0; i < units.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      is_proved([&] {
        const Sum a = roots.forms.of(units[i]), b = roots.forms.of(units[k]);
        if (a.empty() || b.empty()) return false;
        const cln::cl_RA q = a.begin()->second / b.begin()->second;
        return scaled(b, q) == a && is_same_by_powers(units[i], Expr(q) * units[k], roots.facts);
      });
}
// What `needs` and roots prove, if found; `by_terms`: also from powers of sides and of terms.
std::optional<Theorem> proof(Expr goal, const std::vector<Requirement>& needs,
                             const Theorems& outside, const Domain& domain, bool by_terms = false) {
  std::optional<Theorem> found;
  is_proved([&] {
    const Expr both = goal.arg(0) - goal.arg(1);
    Roots roots(Forms(narrowed(domain, needs)), parts_of(both), outside, by_terms);
    Theorems& facts = roots.facts;
    for (int pass = 0; pass < 2; ++pass)  // a sign found late names earlier terms anew
      for (const Requirement& r : needs) is_proved([&] { return roots.forms.assume(r), true; });
    for (const Requirement& r : needs)
      if (!is_constant(r.term)) facts.push_back(kernel::assume(formula(r)));
    for (bool is_of_bounds : {false, true})
      for (const Theorem& is : Theorems(facts))
        if (is_bound(is) == is_of_bounds) is_proved([&] { return roots.add_factors(is), true; });
    roots.signs = facts;
    is_proved([&] { return roots.see(both), true; });
    add_sines(both, roots);
    for (const Requirement& r : needs) {
      roots.add(r.term);
      if (!is_constant(r.term)) continue;
      const bool is_sure = roots.add_sign(r.term);
      if (!is_sure || r.kind != Need::NotZero) facts.push_back(kernel::assume(formula(r)));
    }
    roots.add(both);
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
    if (by_terms && is_same_by_powers(goal.arg(0), goal.arg(1), facts)) found = facts.back();
    if (by_terms && !found) add_terms(both, roots);
    if (!found && !is_found({}) && (by_terms || !is_found(by_powers))) return false;
    for (Expr h : found->hypotheses())  // not one that nobody is told of
      if (std::ranges::find(needs, h, formula) == needs.end() && !roots.definitions.contains(h))
        found.reset();
    return true;
  });
  return found;
}
// The same, or where e >= 0 and where e <= 0.
std::optional<Theorem> proof_by_cases(Expr goal, const std::vector<Requirement>& needs,
                                      const Domain& domain) {
  const Theorems outside = assumptions(needs);
  if (const auto found = proof(goal, needs, outside, domain)) return found;
  Expr terms = goal.arg(0) - goal.arg(1);
  for (const Requirement& r : needs) terms = terms + r.term;
  for (Expr e : turns(terms)) {
    Theorems cases;
    for (auto [side, is] : {std::pair(e, kernel::le(0, e)), {-e, kernel::le(e, 0)}}) {
      auto there = needs;
      there.push_back({Need::NotNegative, side});
      const auto found = proof(goal, there, outside, domain);
      if (!found) break;
      const Theorem assumed = algebra::linear(kernel::le(0, side), {kernel::assume(is)});
      cases.push_back(kernel::discharge(is, algebra::cut(assumed, *found)));
    }
    if (cases.size() == 2) return algebra::follows(goal, cases);
  }
  return proof(goal, needs, outside, domain, true);
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
  const Expr goal = kernel::eq(named(left), named(right));
  const auto found = proof_by_cases(goal, needs, domain);
  if (!found) kernel::refuse("found no proof");
  std::string theorem;
  is_proved([&] {
    Theorem proved = *found;
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
