// SPDX-License-Identifier: GPL-2.0-or-later
// What the kernel proves again from its own rules: equations of terms built by +, *, / and roots.
#include "algebra/tactics.hpp"
#include "equality/normal_form.hpp"

namespace equality {
using algebra::Theorems;
namespace {
constexpr std::size_t heaviest = 400;
constexpr int most_multiplied_out = 24;

bool is_algebraic_term(Expr e) {
  if (e.op() == Op::Num || e.op() == Op::Var) return true;
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
void add_root(Expr x, Theorems& facts) {
  Forms forms({});
  const Sum sum = forms.of(x);
  const cln::cl_RA a = sum.contains({}) ? sum.at({}) : cln::cl_RA(0);
  const Sum rest = sum - number(a);
  if (rest.empty()) return facts.push_back(algebra::root_is(x, root_of(a), facts));
  const Sum squared = forms.of(kernel::power(forms.expression(rest), 2));
  const auto square = notation::rational_value(forms.expression(squared));
  cln::cl_RA d;
  if (!square || a * a < *square || !cln::sqrtp(a * a - *square, &d)) return;
  const Expr more = root_of((a + d) / 2), less = root_of((a - d) / 2);
  if (rest.begin()->second > 0) return facts.push_back(algebra::root_is(x, more + less, facts));
  const algebra::Theorem product = algebra::equation((more - less) * (more + less), d, facts);
  facts.push_back(algebra::certified(kernel::lt(0, more - less),
                                     {.equations = {{-1, product}},
                                      .products = {{d}},
                                      .multipliers = {algebra::positive(more + less, facts)}}));
  facts.push_back(algebra::root_is(x, more - less, facts));
}
void add_roots(Expr e, Theorems& facts) {
  for (Expr part : e.args()) add_roots(part, facts);
  if (is_call(e, "sqrt") && kernel::free_variables(e).empty())
    is_proved([&] { return add_root(e.arg(0), facts), true; });
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
    for (const auto& [kind, e] : needs) facts.push_back(kernel::assume(formula({kind, named(e)})));
    add_roots(left - right, facts);
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
