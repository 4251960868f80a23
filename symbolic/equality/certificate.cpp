// SPDX-License-Identifier: GPL-2.0-or-later
// What the kernel proves again from its own rules: equations of terms built by +, *, /, roots, and
// sines of parts of pi.
#include "algebra/tactics.hpp"
#include "equality/normal_form.hpp"

namespace equality {
using algebra::operator+;
using algebra::Theorem;
using algebra::Theorems;
namespace {
constexpr std::size_t heaviest = 400;
constexpr int most_multiplied_out = 24;
constexpr int few_roots = 2, most_of_roots = 6;
constexpr int most_parts = 60;  // d of pi/d
constexpr int most_work = 10;
constexpr int most_work_of_15 = 3;  // whose sines are of more roots

bool is_sine(Expr e) { return is_call(e, "sin") || is_call(e, "cos"); }
bool is_constant(Expr e) { return kernel::free_variables(e).empty(); }
bool is_algebraic_term(Expr e) {
  if (e.op() == Op::Num || e.op() == Op::Var) return true;
  if (is_sine(e)) return multiple_of_pi(e.arg(0)).has_value();
  if (e.op() == Op::Fun && e.name() != "inv" && e.name() != "sqrt") return false;
  return e.size() > 0 && std::ranges::all_of(e.args(), is_algebraic_term);
}
Expr formula(const Requirement& r) {
  return r.kind == Need::NotZero       ? kernel::neq(r.term, 0)
         : r.kind == Need::NotNegative ? kernel::le(0, r.term)
                                       : kernel::lt(0, r.term);
}
// 0 < c or c < 0 from the signs of its parts or of its inverse, or not c = 0, as it has one.
Theorem not_zero(Expr c, const Theorems& facts) {
  for (Expr side : {c, kernel::canonical(-c)})
    if (const auto positive = algebra::sign_of(side)) return *positive;
  Expr value = kernel::canonical(c);
  for (const Theorem& is : facts)
    if (is.conclusion().op() == Op::Eq)
      value = kernel::canonical(
          kernel::replace(value, kernel::canonical(algebra::left(is)), algebra::right(is)));
  const Expr inverse = algebra::simplified(1 / value), zero = kernel::eq(c, 0);
  algebra::Certificate proof{.equations = {{-1, algebra::equation(c * inverse, 1, facts)}},
                             .products = {{1}}};
  const auto positive = algebra::sign_of(inverse);
  if (positive) proof.multipliers = {*positive};
  if (positive) return algebra::certified(kernel::lt(0, c), proof);
  proof.equations.emplace_back(inverse, kernel::assume(zero));
  return algebra::refute(zero, kernel::arithmetic(kernel::lt(0, 0), proof));
}
// sqrt(a + b) and sqrt(a - b) are sqrt((a + d)/2) and sqrt((a - d)/2), added or subtracted, where a
// is rational and the root of a rational is b; d^2 = a^2 - b^2.
std::optional<Expr> sum_of_roots(Expr x, Theorems& facts) {
  Forms forms({});
  const Sum sum = forms.of(x);
  const cln::cl_RA a = sum.contains({}) ? sum.at({}) : cln::cl_RA(0);
  const Sum rest = sum - number(a);
  const auto root_of = [&](const cln::cl_RA& q) {  // 2 sqrt(2) sqrt(3) of 24
    return forms.expression(forms.of(kernel::sqrt(Expr(q))));
  };
  if (rest.empty()) return root_of(a);
  const Sum squared = forms.of(kernel::power(forms.expression(rest), 2));
  const auto square = notation::rational_value(forms.expression(squared));
  cln::cl_RA d;
  if (!square || a * a < *square || !cln::sqrtp(a * a - *square, &d)) return {};
  const Expr more = root_of((a + d) / 2), less = root_of((a - d) / 2);
  if (rest.begin()->second > 0) return more + less;
  facts.push_back(not_zero(more - less, facts));
  return more - less;
}
// Facts of the roots of constants, by those that are no sums of simpler ones.
void add_roots(Expr e, Theorems& facts, Exprs& others) {
  for (Expr part : e.args()) add_roots(part, facts, others);
  if (!is_call(e, "sqrt")) return;
  const Expr x = e.arg(0);
  if (is_constant(x) && Forms({}).of(x).empty()) return;
  const bool is_sum = is_constant(x) && is_proved([&] {
                        const auto root = sum_of_roots(x, facts);
                        return root && (facts.push_back(algebra::root_is(x, *root, facts)), true);
                      });
  if (!is_sum) others.push_back(x);
}
// One root as both sides are equal, if it is that: two could be written by one another.
void solve_for_a_root(Expr equation, Theorems& facts, const Exprs& radicands) {
  for (Expr x : radicands)
    if (is_proved([&] {
          const Expr root = kernel::sqrt(x), value = algebra::solve({equation}, {root})[0];
          const bool is_other = kernel::replace(value, root, 0) == value;
          return is_other && (facts.push_back(algebra::root_is(x, value, facts)), true);
        }))
      return;
}
void collect_sines(Expr e, Exprs& sines) {
  if (is_sine(e)) sines.push_back(e);
  for (Expr part : e.args()) collect_sines(part, sines);
}
// How much there is to multiply out of roots, and of sine and cosine of pi/d.
cln::cl_I work(Expr e, const cln::cl_I& d) {
  if (is_sine(e)) return cln::numerator(cln::abs(d * *multiple_of_pi(e.arg(0))));
  if (is_call(e, "sqrt")) return 1;
  cln::cl_I sum = 0;
  for (Expr part : e.args()) sum = sum + work(part, d);
  return e.op() == Op::Pow ? sum * e.exponent() : sum;
}
// Sums to high powers, of a few roots sooner, are names, for they are not multiplied out.
void name_bases(Expr e, kernel::Substitution& names) {
  const auto most = [&] {
    return work(e.arg(0), 1) > few_roots ? most_of_roots : most_multiplied_out;
  };
  if (e.op() == Op::Pow && e.exponent() > most() && e.arg(0).op() == Op::Add &&
      names.size() < std::size_t(most_multiplied_out))
    names.emplace(kernel::real("base_" + std::to_string(names.size())), e.arg(0));
  for (Expr part : e.args()) name_bases(part, names);
}
// Sines of parts of pi by those of one part; false where they are too much.
bool add_sines(Expr e, Theorems& facts, Exprs& roots) {
  Exprs sines;
  collect_sines(e, sines);
  cln::cl_I d = 1;
  for (Expr of : sines) d = cln::lcm(d, cln::denominator(*multiple_of_pi(of.arg(0))));
  const int most = cln::mod(d, 15) == 0 ? most_work_of_15 : most_work;
  if (sines.empty()) return true;
  if (d > most_parts || work(e, d) > most) return false;
  const auto part = algebra::part_of_pi(cln::cl_I_to_int(d));
  if (!part) return false;
  const Expr angle = algebra::left(part->cosine).arg(0);
  facts = algebra::angles(sines, {angle}) + Theorems{part->cosine, part->sine} + part->signs;
  for (const auto& is : {part->cosine, part->sine}) add_roots(algebra::right(is), facts, roots);
  return true;
}
}  // namespace

std::string text(const Requirement& r) {
  return notation::typed_text(r.term) + (r.kind == Need::NotZero       ? " != 0"
                                         : r.kind == Need::NotNegative ? " >= 0"
                                                                       : " > 0");
}
std::string certified(Expr left, Expr right, const std::vector<Requirement>& needs) {
  if (!is_algebraic_term(left - right) || left.weight() + right.weight() > heaviest) return "";
  kernel::Substitution bases;
  name_bases(left - right, bases);
  const auto named = [&](Expr e) {
    for (const auto& [name, base] : bases) e = kernel::replace(e, base, name);
    return e;
  };
  std::string theorem;
  is_proved([&] {
    Theorems facts;
    Exprs roots;
    if (!add_sines(left - right, facts, roots)) return false;
    add_roots(left - right, facts, roots);
    for (const auto& [kind, e] : needs) {
      const Expr term = named(e);
      const bool is_seen = is_constant(term) &&
                           is_proved([&] { return facts.push_back(not_zero(term, facts)), true; });
      if (!is_seen || kind != Need::NotZero) facts.push_back(kernel::assume(formula({kind, term})));
    }
    const Expr goal = kernel::eq(named(left), named(right));
    if (!is_proved([&] { return algebra::equation(goal, facts), true; }))
      solve_for_a_root(goal, facts, roots);
    std::string hypotheses;
    const Theorem proved = algebra::equation(goal, facts);
    for (Expr h : kernel::instantiate(proved, bases).hypotheses()) {
      const auto r = std::ranges::find(needs, h, formula);
      if (r == needs.end()) return false;  // a hypothesis that nobody is told of
      hypotheses += (hypotheses.empty() ? "" : ", ") + text(*r);
    }
    theorem = hypotheses + (hypotheses.empty() ? "" : " |- ") + notation::typed_text(left) + " = " +
              notation::typed_text(right);
    return true;
  });
  return theorem;
}
}  // namespace equality
