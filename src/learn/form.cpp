// SPDX-License-Identifier: GPL-2.0-or-later
#include "learn/form.hpp"

#include <functional>
#include <set>

#include "equality/normal_form.hpp"

namespace learn {
namespace {

using kernel::Expr;
using kernel::Op;

bool is_angle_function(Expr e) {
  static const std::set<std::string> names{"sin", "cos", "atan", "asin", "acos"};
  return e.op() == Op::Fun && names.contains(e.name());
}
bool is_quotient(Expr e) { return equality::is_function(e, "inv") && e.arg(0).op() != Op::Num; }

/// The first part, outer ones first, of which `is_lack` is true; none inside of functions of
/// angles.
std::optional<Expr> found(Expr e, const std::function<bool(Expr)>& is_lack) {
  if (is_lack(e)) return e;
  if (is_angle_function(e)) return {};
  for (Expr arg : e.args())
    if (const auto part = found(arg, is_lack)) return part;
  return {};
}

std::string without_angle_functions(Expr e, const equality::Domain&) {
  const auto part = found(e, is_angle_function);
  if (part) return notation::typed_text(*part) + " is still in it";
  for (const std::string& name : notation::symbols_of(e))
    if (name == "psi" || name == "theta") return name + " is still in it";
  return {};
}

/// Terms of both signs somewhere: what nearly cancels there loses digits.
std::string without_cancellation(Expr e, const equality::Domain& domain) {
  const std::vector<equality::Point> points = equality::points(domain, 3, {});
  const auto sign = [&](Expr term, const equality::Point& point) {
    try {
      return equality::exact_sign(equality::at(point, term)).value_or(0);
    } catch (const equality::NotDefined&) {
      return 0;
    }
  };
  const auto part = found(e, [&](Expr term) {
    if (term.op() != Op::Add) return false;
    for (const equality::Point& point : points) {
      std::set<int> signs;
      for (Expr one : term.args()) signs.insert(sign(one, point));
      if (signs.contains(1) && signs.contains(-1)) return true;
    }
    return false;
  });
  return part ? notation::typed_text(*part) + " is a difference" : "";
}

/// Whether a sum is a product in disguise: 4*x, x*y + x, or x^2 + 2*x + 1, but not 1 - x^2.
bool hides_product(Expr sum) {
  const kernel::Polynomial terms = kernel::polynomial(sum);
  for (const auto& [factor, times] : equality::factorized(terms))
    if (times > 1 || (factor.size() == 1 && !factor.begin()->first.empty())) return true;
  cln::cl_I common = 0;
  for (const auto& [monomial, coefficient] : terms)
    common = cln::gcd(common, cln::numerator(coefficient));
  return common > 1;
}
std::string factored(Expr e, const equality::Domain&) {
  if (e.op() == Op::Add) return "it is a sum";
  const auto part = found(e, [](Expr term) { return term.op() == Op::Add && hides_product(term); });
  return part ? notation::typed_text(*part) + " can be written as a product" : "";
}

std::string one_fraction(Expr e, const equality::Domain&) {
  const auto inner = found(e, [](Expr term) {
    const bool is_place = term.op() == Op::Add || is_quotient(term);
    if (!is_place) return false;
    for (Expr arg : term.args())
      if (found(arg, is_quotient)) return true;
    return false;
  });
  return inner ? notation::typed_text(*inner) + " has a division inside" : "";
}

using Check = std::string (*)(Expr, const equality::Domain&);
const std::vector<std::pair<std::string, Check>> checks{
    {"no trigonometric functions", without_angle_functions},
    {"no difference", without_cancellation},
    {"factored", factored},
    {"one fraction", one_fraction}};

}  // namespace

Texts forms() {
  Texts names;
  for (const auto& [name, check] : checks) names.push_back(name);
  return names;
}

std::string lacking(const std::string& form, Expr typed, const equality::Domain& domain) {
  for (const auto& [name, check] : checks)
    if (name == form) return check(typed, domain);
  return {};
}

}  // namespace learn
