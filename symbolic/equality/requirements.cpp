// What terms need to have a value, and what is known where that holds.
#include "equality/normal_form.hpp"

namespace equality {

bool is_certain(const Requirement& requirement, const Domain& domain,
                std::vector<Requirement> known) {
  return is_proved([&] {
    Forms forms(narrowed(domain, known));
    std::ranges::copy(conditions(domain), std::back_inserter(known));
    for (const auto& r : known) is_proved([&] { return forms.assume(r), true; });
    return forms.holds(requirement);
  });
}

Exprs parts_of(Expr term) {
  Exprs out;
  std::set<Expr> seen;
  const auto visit = [&](auto& self, Expr e) -> void {
    if (!seen.insert(e).second) return;
    for (Expr arg : e.args()) self(self, arg);
    out.push_back(e);
  };
  visit(visit, term);
  return out;
}
std::set<Expr> turns(Expr term) {
  std::set<Expr> out;
  for (Expr e : parts_of(term)) {
    if (is_call(e, "abs")) out.insert(e.arg(0));
    if (!is_call(e, "sqrt") && !is_call(e, "root")) continue;
    out.merge(kernel::free_variables(e));
    if (e.arg(0).op() == Op::Pow) out.insert(e.arg(0).arg(0));
  }
  return out;
}
std::vector<Requirement> requirements(Expr term, const Domain& domain) {
  std::vector<Requirement> out;
  for (Expr e : parts_of(term)) {
    if (e.op() != Op::Fun || e.size() == 0) continue;
    const std::string name = e.name();
    const Expr x = e.arg(0);
    if (name == "inv") out.push_back({Need::NotZero, x});
    if (name == "log") out.push_back({Need::Positive, x});
    // Asked of the square: 1 - sqrt(x)^2 is simpler than 1 - sqrt(x).
    if ((name == "asin" || name == "acos") &&
        !is_certain({Need::NotNegative, Expr(1) - kernel::power(x, 2)}, domain))
      for (Expr rest : {Expr(1) - x, Expr(1) + x}) out.push_back({Need::NotNegative, rest});
    const bool is_root = name == "sqrt" || name == "root";
    if (is_root && order_of(e) % 2 == 0) out.push_back({Need::NotNegative, x});
    if (name != "raised") continue;
    if (is_proved([&] { return Forms(domain).of(x).empty(); }))
      out.push_back({Need::Positive, e.arg(1)});
    else if (!Forms(domain).is_integer(e.arg(1)))
      out.push_back({root_exponent(e).value_or(1) < 0 ? Need::Positive : Need::NotNegative, x});
    else if (!is_certain({Need::Positive, e.arg(1)}, domain))
      out.push_back({Need::NotZero, x});
  }
  return out;
}

std::vector<Requirement> conditions(const Domain& domain) {
  std::vector<Requirement> out;
  for (const auto& [left, relation, right] : domain.further) {
    const Need at_0 = relation.ends_with('=') ? Need::NotNegative : Need::Positive;
    out.push_back({relation == "!=" ? Need::NotZero : at_0,
                   relation[0] == '<' ? right - left : left - right});
  }
  return out;
}

std::array<Expr, 3> quadratic_in(Expr term, Expr x) {
  const auto at = [&](int value) { return kernel::substitute(term, {{x, Expr(value)}}); };
  return {(at(1) + at(-1)) / 2 - at(0), (at(1) - at(-1)) / 2, at(0)};
}
std::optional<Expr> zero_of(Expr term, Expr x) {
  const Expr start = quadratic_in(term, x)[2], rise = quadratic_in(term, x)[1];
  std::optional<Expr> value;
  is_proved([&] {
    Forms forms({});
    const auto real = forms.real_expression(forms.of(Expr(-1) * start / rise));
    const auto number = forms.real_expression(forms.of(rise));
    if (real && number && exact_sign(*number).value_or(0) != 0 &&
        forms.is_zero(forms.of(term - start - rise * x)))
      value = kernel::expression(kernel::polynomial(*real));
    return true;
  });
  return value;
}

std::optional<Expr> inverse(Expr e, Expr value) {
  static const std::map<std::string, std::string> inverses{{"exp", "log"},  {"log", "exp"},
                                                           {"sin", "asin"}, {"cos", "acos"},
                                                           {"asin", "sin"}, {"acos", "cos"}};
  if (e.op() == Op::Pow) return notation::root(e.exponent(), value);
  if (is_call(e, "atan")) return kernel::sin(value) / kernel::cos(value);
  const auto it = e.op() == Op::Fun ? inverses.find(e.name()) : inverses.end();
  return it == inverses.end() ? std::nullopt : std::optional(notation::call(it->second, value));
}
Exprs zeros_of(Expr term, Expr x) {
  if (const auto zero = zero_of(term, x)) return {*zero};
  const auto [a, b, c] = quadratic_in(term, x);
  Exprs out;
  for (Expr root : {-kernel::sqrt(b * b - 4 * a * c), kernel::sqrt(b * b - 4 * a * c)})
    if (const auto zero = zero_of(2 * a * x + b - root, x)) out.push_back(*zero);
  const Expr value = kernel::real("value_of_function");  // which nobody can type
  for (Expr e : parts_of(term)) {
    if ((e.op() != Op::Fun && e.op() != Op::Pow) || !kernel::free_variables(e).contains(x))
      continue;
    const auto is = zero_of(kernel::replace(term, e, value), value);
    if (!is || !kernel::free_variables(*is).empty()) continue;
    if (const auto inner = inverse(e, *is))
      for (Expr zero : zeros_of(e.arg(0) - *inner, x)) out.push_back(zero);
    if (is_call(e, "sin") || is_call(e, "cos"))
      for (Expr angle : {kernel::pi() / 2, kernel::pi()}) out.push_back(angle);
  }
  return out;
}

Domain narrowed(Domain domain, const std::vector<Requirement>& needs) {
  const auto narrow = [&](const Requirement& r, Expr x) {  // by start + rise x
    Forms forms(domain);
    Sum start = forms.of(r.term);
    const cln::cl_RA rise = start[{{x, exponent(1)}}];
    start = start - scaled(atom(x), rise);
    const auto value = forms.real_expression(start);
    if (rise == 0 || !value || !kernel::free_variables(*value).empty()) return false;
    const auto exact = notation::rational_value(*value);
    const cln::cl_RA there = -(exact ? *exact : enclosure(*value, 64).high()) / rise;
    const cln::cl_I eighths = rise > 0 ? cln::floor1(8 * there) : cln::ceiling1(8 * there);
    // A little more than it leaves, where that is not rational.
    const End end{exact ? there : eighths / cln::cl_RA(8), r.kind == Need::NotNegative};
    if (rise > 0)
      domain.ranges[x].cut_below(end);
    else
      domain.ranges[x].cut_above(end);
    return true;
  };
  // Of a x^2 + b x + c with rational zeros: between them, or beyond the one that is not passed.
  const auto narrow_by_square = [&](const Requirement& r, Expr x) {
    const auto parts = quadratic_in(r.term, x);
    const auto number = [&](std::size_t i) {
      return notation::rational_value(parts[i]).value_or(0);
    };
    const cln::cl_RA a = number(0), b = number(1), c = number(2), square = b * b - 4 * a * c;
    cln::cl_RA root;
    Forms forms(domain);
    const Sum rest = forms.of(r.term - (Expr(a) * x + Expr(b)) * x - Expr(c));
    if (a == 0 || square < 0 || !cln::sqrtp(square, &root) || !forms.is_zero(rest)) return false;
    const bool is_inside = r.kind == Need::NotNegative;
    const End less{(-b - root / cln::signum(a)) / (2 * a), is_inside};
    const End more{(-b + root / cln::signum(a)) / (2 * a), is_inside};
    Range& range = domain.ranges[x];
    if (a < 0 || (range.low && range.low->value > less.value)) range.cut_below(a < 0 ? less : more);
    if (a < 0 || (range.high && range.high->value < more.value))
      range.cut_above(a < 0 ? more : less);
    return true;
  };
  for (const Requirement& r : needs) {
    const std::set<Expr> symbols = kernel::free_variables(r.term);
    if (r.kind != Need::NotZero && symbols.size() == 1)
      is_proved([&] { return narrow(r, *symbols.begin()); }) ||
          is_proved([&] { return narrow_by_square(r, *symbols.begin()); });
  }
  return domain;
}
}  // namespace equality
