// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "algebra/tactics.hpp"
#include "equality/normal_form.hpp"

namespace equality {
using kernel::Op;
using Need = Requirement::Kind;
namespace {
constexpr std::size_t points_tried = 40;
constexpr std::size_t points_inside = 10;
constexpr std::size_t points_of_case = 4;
constexpr std::size_t points_exactly = 3;
constexpr int most_certified = 24;
constexpr int digits_shown = 16;
constexpr std::size_t longest_shown = 40;
constexpr int largest_denominator = 1000;
constexpr int most_cases = 30;  // integers that are put in one by one

// Exactly where it is a short fraction.
std::optional<cln::cl_RA> fraction(Expr constant) {
  if (const auto value = notation::rational_value(constant)) return value;
  const Value value = value_at({}, constant);
  if (!value.ball) return {};
  const auto near = near_fraction(value.ball->low(), largest_denominator);
  return near && exact_sign(constant - Expr(*near)) == 0 ? near : std::nullopt;
}
std::string shown(Expr constant) {
  if (const auto exact = fraction(constant)) {
    const std::string digits = kernel::digits(*exact);
    if (digits.size() <= longest_shown) return digits;
  }
  for (int bits = 128; bits <= 8192; bits *= 2) {
    const Value value = value_at({}, constant, bits);
    if (!value.ball) continue;
    if (const auto text = balls::decimal(value.ball->low(), value.ball->high(), digits_shown))
      return *text;
  }
  return "too close to 0 to be shown";
}
std::string text(const Requirement& r) {
  return notation::typed_text(r.term) + (r.kind == Need::NotZero       ? " != 0"
                                         : r.kind == Need::NotNegative ? " >= 0"
                                                                       : " > 0");
}

class Question {
public:
  Question(Expr the_left, Expr the_right, const Domain& the_domain)
      : left(the_left), right(the_right), domain(the_domain) {
    verdict.domain = texts(domain);
    while (put_in_a_value()) continue;
    needs = requirements(left - right, domain);
  }
  Verdict answer() {
    if (is_different_somewhere()) return verdict;
    if (prove()) {
      verdict.answer = Answer::Equal;
      add_conditions();
      if (given.empty()) certify();
      return verdict;
    }
    if (!is_different_exactly() && verdict.proof.empty())
      verdict.proof =
          "neither a proof nor a counterexample was found; " +
          (common.empty() ? "the values are too large, or take too many digits to know"
                          : "both sides agree to 50 digits at " + std::to_string(common.size()) +
                                (common.size() == 1 ? " point" : " points"));
    return verdict;
  }

private:
  static inline bool is_case = false;  // cases are not split again
  Expr left;
  Expr right;
  Domain domain;
  Verdict verdict;
  std::vector<Requirement> needs;  // of both
  std::vector<Point> common;       // where both sides have a value, and agree
  std::string given;               // "x = 2": values that were put in

  /// x = 2 and x + y = 1 are put in: in both sides, and in what else is said of x.
  bool put_in_a_value() {
    for (const auto& [x, range] : domain.ranges)
      if (range.is_point()) return put_in(x, range.low->value);
    for (const auto& [l, relation, r] : domain.further)
      for (const auto& [x, range] : domain.ranges) {
        const auto value = relation == "=" ? zero_of(l - r, x) : std::nullopt;
        if (value && put_in(x, *value)) return true;
      }
    return false;
  }
  bool put_in(Expr x, Expr value) {
    const Range range = domain.ranges.at(x);
    if (range.is_integer && !Forms(domain).is_integer(value)) return false;
    const auto written = [&](Expr e) { return kernel::substitute(e, {{x, value}}); };
    given +=
        (given.empty() ? "" : ", ") + notation::typed_text(x) + " = " + notation::typed_text(value);
    if (range.low)
      domain.further.push_back({x, range.low->is_inside ? ">=" : ">", range.low->value});
    if (range.high)
      domain.further.push_back({x, range.high->is_inside ? "<=" : "<", range.high->value});
    domain.ranges.erase(x);
    left = written(left);
    right = written(right);
    for (notation::Comparison& c : domain.further)
      c = {written(c.left), c.relation, written(c.right)};
    std::erase_if(domain.further, [](const auto& c) { return holds(c) == true; });
    return true;
  }
  std::string shown_point(const Point& point) const {
    const std::string free = equality::text(point);
    return given + (given.empty() || free.empty() ? "" : ", ") + free;
  }
  bool is_counterexample(const Point& point, const std::string& how) {
    verdict.answer = Answer::Different;
    verdict.proof = how;
    verdict.counterexample =
        Counterexample{shown_point(point), shown(at(point, left)), shown(at(point, right)),
                       shown(at(point, left - right))};
    return true;
  }
  bool is_different_somewhere() {
    const Domain box = narrowed(domain, conditions(domain));
    std::vector<Point> all = points(box, is_case ? points_of_case : points_tried, {left, right});
    if (all.empty()) kernel::refuse("no point of the domain was found");
    for (const Point& point :
         points(narrowed(box, needs), is_case ? points_of_case : points_inside, {}, true))
      if (std::ranges::find(all, point) == all.end()) all.push_back(point);
    std::string why_none;
    bool is_open = false;  // somewhere it would take more bits to know a value
    for (const Point& point : all) {
      Value a, b;
      for (int bits = 192; bits <= 3072; bits *= 4) {
        a = value_at(point, left, bits);
        b = value_at(point, right, bits);
        if (a.is_known() && b.is_known()) break;
      }
      if (!a.is_known() || !b.is_known()) {
        is_open = true;
        continue;
      }
      if (!a.ball || !b.ball) {
        why_none = (b.ball ? a : b).why_none;
        if (verdict.notes.empty() && (a.ball || b.ball))
          verdict.notes.push_back(std::string(a.ball ? "the right" : "the left") +
                                  " side alone has no value at " + shown_point(point) + ": " +
                                  why_none);
        continue;
      }
      if (a.ball->high() < b.ball->low() || b.ball->high() < a.ball->low())
        return is_counterexample(point, "both sides at one point, with certain bounds of error");
      common.push_back(point);
    }
    if (common.empty() && !is_open)
      kernel::refuse("no point was found where both sides have a value" +
                     (why_none.empty() ? "" : ": " + why_none));
    return false;
  }
  /// Under conditions that never hold everything can be proved.
  bool has_impossible_need() {
    const auto may_hold_at = [&](const Point& point) {
      return std::ranges::none_of(needs, [&](const Requirement& r) {
        const Value value = value_at(point, r.term);
        return r.kind != Need::NotZero && value.ball && value.ball->high() < 0;
      });
    };
    const auto is_of_sign = [](const Requirement& r) { return r.kind != Need::NotZero; };
    return std::ranges::any_of(needs, is_of_sign) && std::ranges::none_of(common, may_hold_at);
  }
  bool proved(const std::string& how) {
    verdict.proof = how;
    return true;
  }
  bool prove() {
    if (left == right) return proved("both sides are the same expression");
    if (prove_at_whole_exponents()) return true;
    if (has_impossible_need()) return false;
    const Expr difference = left - right;
    if (domain.ranges.empty() && exact_sign(difference) == 0)
      return proved(is_algebraic(difference)
                        ? "algebraic numbers: the difference is below the least that it could be"
                        : "normal form: the difference of both sides is 0");
    if (is_same_form(right)) return true;
    const Expr other = with_one_angle(left, right, domain, common);
    if (other != right && is_same_form(other)) return true;
    if (!is_same_angle(left, right, domain, common)) return prove_by_cases();
    const std::string point = equality::text(common[0]);
    return proved("angles: both sides have the same cosine and sine, " +
                  (point.empty() ? "and they are less than a turn apart"
                                 : "both are continuous, and at " + point + " they agree"));
  }
  bool is_proved_on(const Domain& part) {
    if (is_case) return false;
    is_case = true;
    const bool is_equal = is_proved([&] {  // not where there is no point
      const Verdict found = decide(left, right, part);
      return found.answer == Answer::Equal && proved(found.proof);
    });
    is_case = false;
    return is_equal;
  }
  /// A new symbol is an integer.
  bool is_proved_where(Expr l, const std::string& relation, Expr r) {
    Domain part = domain;
    part.further.push_back({l, relation, r});
    for (Expr symbol : kernel::free_variables(r)) part.ranges[symbol] = {.is_integer = true};
    return is_proved_on(part);
  }
  /// x >= 0 and x <= 0 where |x| or a root is, few integers, or an integer even and odd.
  bool prove_by_cases() {
    const std::string before = verdict.proof;
    std::set<Expr> turns;
    collect_turns(left - right, turns);
    for (Expr e : turns)
      if (is_proved_where(e, ">=", 0) && is_proved_where(e, "<=", 0)) {
        const std::string name = notation::typed_text(e);
        return proved("cases: " + name + " >= 0 and " + name + " <= 0");
      }
    for (const auto& [x, range] : domain.ranges) {
      if (!range.is_integer) continue;
      const std::string name = notation::typed_text(x);
      if (range.low && range.high && is_proved_for_each(x, range))
        return proved("cases: each " + name);
      const Expr half = kernel::integer("half_" + x.name());  // which nobody can type
      if (is_proved_where(x, "=", Expr(2) * half) &&
          is_proved_where(x, "=", Expr(2) * half + Expr(1)))
        return proved("cases: " + name + " even and " + name + " odd");
    }
    verdict.proof = before;  // not that of one case alone
    return false;
  }
  bool is_proved_for_each(Expr x, const Range& range) {
    cln::cl_RA value = cln::ceiling1(range.low->value);
    if (range.high->value - value > most_cases) return false;
    for (; value <= range.high->value; value = value + 1)
      if (range.contains(value) && !is_proved_where(x, "=", value)) return false;
    return true;
  }
  void collect_turns(Expr e, std::set<Expr>& found) {
    if (is_call(e, "abs")) found.insert(e.arg(0));
    if (is_call(e, "sqrt") || is_call(e, "root")) found.merge(kernel::free_variables(e));
    for (Expr part : e.args()) collect_turns(part, found);
  }
  /// A power whose base is negative and whose exponent is not always whole.
  std::optional<Expr> power_of_negative(Expr e) {
    if (is_call(e, "raised") && !kernel::free_variables(e.arg(1)).empty() &&
        !Forms(domain).is_integer(e.arg(1)) &&
        is_certain({Need::Positive, Expr(-1) * e.arg(0)}, domain))
      return e;
    for (Expr part : e.args())
      if (const auto found = power_of_negative(part)) return found;
    return {};
  }
  /// (-1)^x has values only where x is whole.
  bool prove_at_whole_exponents() {
    const auto found = power_of_negative(left - right);
    if (!found) return false;
    const std::set<Expr> symbols = kernel::free_variables(found->arg(1));
    return std::ranges::any_of(symbols,
                               [&](Expr x) { return prove_at_whole_exponent(x, found->arg(1)); });
  }
  bool prove_at_whole_exponent(Expr x, Expr exponent) {
    Domain whole = domain;
    whole.ranges[x].is_integer = true;
    const std::string condition = " integer";
    if (Forms(whole).is_integer(exponent)) {
      if (!is_proved_on(whole)) return false;
      verdict.conditions.push_back(notation::typed_text(x) + condition);
      domain = whole;  // nothing else is asked of its bases
      needs = requirements(left - right, domain);
      return true;
    }
    const bool is_linear = is_proved_where(exponent, "=", kernel::integer("whole_exponent"));
    if (is_linear) verdict.conditions.push_back(notation::typed_text(exponent) + condition);
    return is_linear;
  }
  bool is_same_form(Expr other) {
    try {
      Forms forms(narrowed(narrowed(domain, needs), conditions(domain)));
      for (int pass = 0; pass < 2; ++pass) {  // a sign found late names earlier terms anew
        for (const Requirement& r : needs) forms.assume(r);
        for (const Requirement& r : conditions(domain))
          is_proved([&] { return forms.assume(r), true; });
      }
      const Sum difference = forms.of(left) - forms.of(other);
      if (forms.is_zero(difference))
        return proved("normal form: the difference of both sides is 0");
      if (forms.is_zero(forms.of(notation::call("exp", left - other)) - number(1)))
        return proved("normal form: the exponential of the difference is 1");
      if (forms.is_not_negative(forms.of(left)) && forms.is_not_negative(forms.of(other)) &&
          forms.is_zero(forms.of(kernel::power(left, 2) - kernel::power(other, 2))))
        return proved("normal form: neither side is negative, and their squares are equal");
    } catch (const TooLarge& large) {
      verdict.proof = std::string("not decided: ") + large.what();
    } catch (const std::runtime_error&) {  // not defined, or not certain
    }
    return false;
  }
  // What agrees to fifty digits may still differ.
  bool is_different_exactly() {
    for (std::size_t i = 0; i < std::min(common.size(), points_exactly); ++i)
      if (exact_sign(at(common[i], left - right)).value_or(0) != 0)
        return is_counterexample(common[i],
                                 "both sides at one point, compared with as many bits as it takes");
    return false;
  }

  void add_conditions() {
    std::set<std::string> seen;
    for (const Requirement& r : needs) {
      const bool is_weaker = r.kind == Need::NotNegative &&  // than another one, or whole exponents
                             (std::ranges::count(needs, Requirement{Need::Positive, r.term}) > 0 ||
                              is_certain({Need::Positive, Expr(-1) * r.term}, domain));
      if (!is_weaker && !is_certain(r, domain) && seen.insert(text(r)).second)
        verdict.conditions.push_back(text(r));
    }
  }
  static bool is_algebraic_term(Expr e) {
    if (e.op() == Op::Num || e.op() == Op::Var) return true;
    if (e.op() == Op::Fun && e.name() != "inv" && e.name() != "sqrt") return false;
    return e.size() > 0 && std::ranges::all_of(e.args(), is_algebraic_term);
  }
  // Sums to high powers are names, for they are not multiplied out.
  static void name_bases(Expr e, kernel::Substitution& names) {
    const bool is_high = e.op() == Op::Pow && e.exponent() > most_certified;
    if (is_high && e.arg(0).op() == Op::Add && names.size() < most_certified)
      names.emplace(kernel::real("base_" + std::to_string(names.size())), e.arg(0));
    for (Expr part : e.args()) name_bases(part, names);
  }
  // The kernel proves it again from its own rules, where both sides are built by +, *, / and roots.
  void certify() {
    if (!is_algebraic_term(left - right) || left.weight() + right.weight() > 400) return;
    kernel::Substitution bases;
    name_bases(left - right, bases);
    const auto named = [&](Expr e) {
      for (const auto& [name, base] : bases) e = kernel::replace(e, base, name);
      return e;
    };
    const auto formula = [](Need kind, Expr e) {
      return kind == Need::NotZero       ? kernel::neq(e, 0)
             : kind == Need::NotNegative ? kernel::le(0, e)
                                         : kernel::lt(0, e);
    };
    try {
      algebra::Theorems facts;
      for (const auto& [kind, term] : needs)
        facts.push_back(kernel::assume(formula(kind, named(term))));
      const algebra::Theorem theorem =
          kernel::instantiate(algebra::equation(named(left), named(right), facts), bases);
      std::string hypotheses;
      for (Expr h : theorem.hypotheses()) {
        const auto r = std::ranges::find_if(
            needs, [&](const Requirement& need) { return h == formula(need.kind, need.term); });
        if (r == needs.end()) return;  // a hypothesis that nobody is told of
        hypotheses += (hypotheses.empty() ? "" : ", ") + text(*r);
      }
      verdict.theorem = (hypotheses.empty() ? "" : hypotheses + " |- ") +
                        notation::typed_text(left) + " = " + notation::typed_text(right);
      verdict.proof += ", certified by the kernel";
    } catch (const kernel::Refused&) {
    }
  }
};
}  // namespace

Verdict decide(Expr left, Expr right, const Domain& domain) {
  try {
    return Question(left, right, domain).answer();
  } catch (const NotDefined& none) {
    kernel::refuse(std::string("there is no value: ") + none.what());
  } catch (const TooLarge& large) {
    return {.proof = std::string("not decided: ") + large.what()};
  }
}
const char* word(Answer answer) {
  constexpr const char* words[]{"equal", "different", "undecided"};
  return words[static_cast<std::size_t>(answer)];
}
}  // namespace equality
