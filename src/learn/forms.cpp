// What an answer lacks of the form that is asked for: factored, one fraction, ...
#include "equality/normal_form.hpp"
#include "learn/terms.hpp"
#include "notation/tokens.hpp"

namespace learn {
namespace {

using namespace kernel;

bool is_angle_function(Expr e) {
  static const std::set<std::string> names{"sin", "cos", "atan", "asin", "acos"};
  return e.op() == Op::Fun && names.contains(e.name());
}
bool is_quotient(Expr e) { return is_call(e, "inv") && e.arg(0).op() != Op::Num; }

/// The first part, outer ones first, of which `is_lack` is true; unless it is said, none of an
/// angle, x/2 in cos(x/2), but for what an inverse function in it is taken of.
std::optional<Expr> found(Expr e, const std::function<bool(Expr)>& is_lack, bool of_angles = false,
                          bool is_angle = false) {
  if ((of_angles || !is_angle) && is_lack(e)) return e;
  const bool has_angle = is_angle_function(e) ? e.name()[0] != 'a' : is_angle;
  for (Expr arg : e.args())
    if (const auto part = found(arg, is_lack, of_angles, has_angle)) return part;
  return {};
}

bool has_angle(Expr e, const equality::Domain&) {
  const std::string name = notation::name_of(e);
  return is_angle_function(e) || name == "psi" || name == "theta";
}

/// Terms of both signs somewhere: what nearly cancels there loses digits.
bool is_difference(Expr e, const equality::Domain& domain) {
  if (e.op() != Op::Add) return false;
  for (const equality::Point& point : equality::points(domain, 3, {})) {
    std::set<int> signs;
    for (Expr one : e.args()) try {
        signs.insert(equality::exact_sign(equality::at(point, one)).value_or(0));
      } catch (const equality::NotDefined&) {
      }
    if (signs.contains(1) && signs.contains(-1)) return true;
  }
  return false;
}

/// The same as over and under one line, without quotients in either.
std::pair<Expr, Expr> one_fraction(Expr e) {
  if (is_quotient(e) || e.op() == Op::Pow) {
    const auto [over, under] = one_fraction(e.arg(0));
    if (e.op() != Op::Pow) return {under, over};
    return {power(over, e.exponent()), power(under, e.exponent())};
  }
  if (e.op() != Op::Add && e.op() != Op::Mul) return {e, 1};
  auto [all_over, all_under] = one_fraction(e.arg(0));
  for (std::size_t i = 1; i < e.size(); ++i) {
    const auto [over, under] = one_fraction(e.arg(i));
    all_over = e.op() == Op::Mul ? all_over * over : all_over * under + over * all_under;
    all_under = all_under * under;
  }
  return {all_over, all_under};
}

/// Whether a sum is a product: x*y + x, x^2 + 2*x + 1, 1/x + 2 + x; not 1 - x^2 or 1/x + 1/y.
bool hides_product(Expr e, const equality::Domain&) {
  if (e.op() != Op::Add) return false;
  const Polynomial terms = polynomial(one_fraction(e).first);
  std::set<std::set<std::string>> symbols;
  for (const auto& [factor, times] : equality::factorized(terms)) {
    if (times > 1 || (factor.size() == 1 && !factor.begin()->first.empty())) return true;
    if (factor.size() > 1) symbols.insert(notation::symbols_of(expression(factor)));
  }
  if (symbols.size() > 1) return true;
  cln::cl_I common = 0;
  for (const auto& [monomial, q] : terms) common = cln::gcd(common, cln::numerator(q));
  return common > 1;
}

/// Also where a factor could be cancelled.
bool is_no_fraction(Expr e, const equality::Domain&) {
  if (e.op() == Op::Add) return found(e, is_quotient).has_value();
  const auto [over, under] = one_fraction(e);
  const auto factors = equality::factorized(polynomial(over));
  for (const auto& [factor, times] : equality::factorized(polynomial(under)))
    for (const auto& [other, ignored] : factors)
      if (scaled(factor, other.begin()->second) == scaled(other, factor.begin()->second) &&
          !factor.rbegin()->first.empty())
        return true;
  return false;
}

/// exp or log of a symbol: exp(log(x) - log(y)) is x/y, and log(exp(x)/exp(y)) is x - y.
bool hides_form(Expr e) {
  return (is_call(e, "exp") || is_call(e, "log") || is_call(e, "raised")) &&
         !notation::symbols_of(e.args().back()).empty();
}

long divisions(const std::string& typed) {
  std::string before;  // what stands before, but for brackets: x^(-1) is a division
  return std::ranges::count_if(notation::tokens(typed), [&](const notation::Token& word) {
    const bool is_power = word.text == "-" && before == "^";
    if (word.text != "(" && word.text != "{") before = word.text;
    return is_power || word.text == "/" || word.text == "frac";
  });
}

struct Form {
  std::string name;
  bool (*is_lack)(Expr part, const equality::Domain&);
  std::string lack;
};
const std::vector<Form> all_forms{{"no trigonometric functions", has_angle, " is still in it"},
                                  {"no difference", is_difference, " is a difference"},
                                  {"factored", hides_product, " can be written as a product"},
                                  {"one fraction", is_no_fraction,
                                   " has more divisions than it needs, or a factor that cancels"}};

}  // namespace

Texts forms() { return answers::texts_of(all_forms, &Form::name); }

std::string Terms::lacking(Expr term, const std::string& text) const {
  const auto it = std::ranges::find(all_forms, exercise.form, &Form::name);
  if (it == all_forms.end()) return {};
  if (it->is_lack == hides_product && term.op() == Op::Add) return quoted(text, term) + " is a sum";
  const auto hidden = found(term, hides_form, true);
  if (hidden && it->is_lack != has_angle) return quoted(text, *hidden) + " hides its form";
  const long count = divisions(text) - divisions(exercise.name);
  if (it->is_lack == is_no_fraction && count > 1)
    return "there are " + std::to_string(count) + " divisions in it";
  const equality::Domain where = domain(notation::symbols_of(term));
  const auto is_lack = [&](Expr e) { return it->is_lack(e, where); };
  const auto part = found(term, is_lack, it->is_lack == is_difference);
  return part ? quoted(text, *part) + it->lack : "";
}

Texts Terms::allowed() const {
  Texts names = exercise.symbols;
  if (exercise.kind == "symbolic")
    std::erase_if(names, [&](auto& name) { return !lacking(content(name), name).empty(); });
  return names;
}

}  // namespace learn
