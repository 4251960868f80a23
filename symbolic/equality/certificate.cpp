// SPDX-License-Identifier: GPL-2.0-or-later
// What the kernel proves again from its own rules: equations of terms built by +, *, /, roots, and
// sines of parts of pi.
#include "algebra/tactics.hpp"
#include "equality/normal_form.hpp"

namespace equality {
using algebra::operator+;
using algebra::Theorems;
namespace {
constexpr std::size_t heaviest = 400;
constexpr int most_multiplied_out = 24;
constexpr int most_parts = 60;  // d of pi/d
constexpr int most_work = 10;
constexpr int most_work_of_15 = 3;  // whose sines are of more roots

bool is_sine(Expr e) { return is_call(e, "sin") || is_call(e, "cos"); }
bool is_algebraic_term(Expr e) {
  if (e.op() == Op::Num || e.op() == Op::Var) return true;
  if (is_sine(e)) return multiple_of_pi(e.arg(0)).has_value();
  if (e.op() == Op::Fun && e.name() != "inv" && e.name() != "sqrt") return false;
  return e.size() > 0 && std::ranges::all_of(e.args(), is_algebraic_term);
}
// Sums to high powers are names, for they are not multiplied out.
void name_bases(Expr e, kernel::Substitution& names) {
  const bool is_high = e.op() == Op::Pow && e.exponent() > most_multiplied_out;
  if (is_high && e.arg(0).op() == Op::Add && names.size() < std::size_t(most_multiplied_out))
    names.emplace(kernel::real("base_" + std::to_string(names.size())), e.arg(0));
  for (Expr part : e.args()) name_bases(part, names);
}
Expr formula(const Requirement& r) {
  return r.kind == Need::NotZero       ? kernel::neq(r.term, 0)
         : r.kind == Need::NotNegative ? kernel::le(0, r.term)
                                       : kernel::lt(0, r.term);
}
// The root of a fraction, 2 sqrt(2) sqrt(3) of 24.
Expr root_of(const cln::cl_RA& q) {
  Forms forms({});
  const Sum root = forms.of(kernel::sqrt(Expr(q)));
  Expr out = root.begin()->second;
  for (const auto& [prime, half] : root.begin()->first) out = out * kernel::sqrt(prime);
  return out;
}
// sqrt(a + b) and sqrt(a - b) are sqrt((a + d)/2) and sqrt((a - d)/2), added or subtracted, where a
// is rational and the root of a rational is b; d^2 = a^2 - b^2.
std::optional<Expr> sum_of_roots(Expr x, Theorems& facts) {
  Forms forms({});
  const Sum sum = forms.of(x);
  const cln::cl_RA a = sum.contains({}) ? sum.at({}) : cln::cl_RA(0);
  const Sum rest = sum - number(a);
  if (rest.empty()) return root_of(a);
  const Sum squared = forms.of(kernel::power(forms.expression(rest), 2));
  const auto square = notation::rational_value(forms.expression(squared));
  cln::cl_RA d;
  if (!square || a * a < *square || !cln::sqrtp(a * a - *square, &d)) return {};
  const Expr more = root_of((a + d) / 2), less = root_of((a - d) / 2);
  if (rest.begin()->second > 0) return more + less;
  const algebra::Theorem product = algebra::equation((more - less) * (more + less), d, facts);
  facts.push_back(algebra::certified(kernel::lt(0, more - less),
                                     {.equations = {{-1, product}},
                                      .products = {{d}},
                                      .multipliers = {algebra::positive(more + less, facts)}}));
  return more - less;
}
// The root of a rational times sqrt(other) or 1/sqrt(other).
std::optional<Expr> by_other(Expr x, Expr other) {
  Forms forms({});
  const Sum sum = forms.of(x), of_other = forms.of(other);
  const cln::cl_RA ratio = sum.begin()->second / of_other.begin()->second;
  if (sum == scaled(of_other, ratio)) return root_of(ratio) * kernel::sqrt(other);
  const auto product = notation::rational_value(forms.expression(forms.of(x * other)));
  return product ? std::optional(root_of(*product) / kernel::sqrt(other)) : std::nullopt;
}
// Facts of the roots of constants, by those that are no sums of simpler ones.
void add_roots(Expr e, Theorems& facts, Exprs& others) {
  for (Expr part : e.args()) add_roots(part, facts, others);
  if (!is_call(e, "sqrt") || !kernel::free_variables(e).empty()) return;
  const Expr x = e.arg(0);
  if (Forms({}).of(x).empty()) return;
  const auto is = [&](std::optional<Expr> root) {
    return root && (facts.push_back(algebra::root_is(x, *root, facts)), true);
  };
  if (is_proved([&] { return is(sum_of_roots(x, facts)); })) return;
  for (Expr other : others)
    if (is_proved([&] { return is(by_other(x, other)); })) return;
  others.push_back(x);
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
    for (const auto& [kind, e] : needs) facts.push_back(kernel::assume(formula({kind, named(e)})));
    std::string hypotheses;
    const algebra::Theorem proved = algebra::equation(named(left), named(right), facts);
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
