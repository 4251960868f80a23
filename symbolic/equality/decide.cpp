#include "equality/normal_form.hpp"

namespace equality {
using notation::typed_text;
namespace {
constexpr std::size_t points_tried = 40, points_inside = 10, points_of_case = 4;
constexpr std::size_t points_beyond = 8, points_beside = 20, points_exactly = 3;
constexpr const char* no_difference = "normal form: the difference of both sides is 0";
constexpr int most_gaps = 30;   // points that are tried where a divisor may be 0
constexpr int most_cases = 30;  // integers that are put in one by one

cln::cl_RA size(const Point& point) {
  cln::cl_RA sum = 0;
  for (const auto& [x, q] : point) sum = sum + cln::abs(cln::numerator(q)) * cln::denominator(q);
  return sum;
}
class Question {
public:
  Question(Expr the_left, Expr the_right, const Domain& the_domain, Wanted what)
      : left(the_left), right(the_right), domain(the_domain), wanted(what) {
    verdict.domain = texts(domain);
    while (put_in_a_value()) continue;
    needs = requirements(left - right, domain);
  }
  Verdict answer() {
    if (is_different_somewhere()) return verdict;
    if (prove()) {
      verdict.answer = Answer::Equal;
      if (wanted != Wanted::Case) add_conditions();
      if (wanted != Wanted::Explanation) return verdict;
      try {
        verdict.theorem = certified(asked, given, needs, domain);
        verdict.proof += ", certified by the kernel";
      } catch (const kernel::Refused& why) {
        if (left != right) verdict.proof += std::string("; the kernel ") + why.what();
      }
    } else if (!is_different_exactly() && verdict.proof.empty()) {
      verdict.proof =
          "neither a proof nor a counterexample was found; " +
          (common.empty() ? "both sides could be computed nowhere"
                          : "both sides agree to 50 digits at " + std::to_string(common.size()) +
                                (common.size() == 1 ? " point" : " points"));
    }
    return verdict;
  }

private:
  Expr left, right, asked = kernel::eq(left, right);
  Domain domain;
  Wanted wanted;
  Verdict verdict;
  std::vector<Requirement> needs;  // of both
  int gaps_tried = 0;
  std::vector<Point> common;  // where both sides have a value, and agree
  Exprs given;                // x = 2: values that were put in

  /// x = 2 and x + y = 1 are put in: in both sides, and in what else is said of x.
  bool put_in_a_value() {
    for (const auto& [x, r] : domain.ranges)
      if (r.is_point() && put_in(x, r.low->value)) return true;
    for (const auto& [l, sign, r] : domain.further)
      for (const auto& [x, range] : domain.ranges) {
        const auto value = sign == "=" ? zero_of(l - r, x) : std::nullopt;
        if (value && put_in(x, *value)) return true;
      }
    return false;
  }
  bool put_in(Expr x, Expr value) {
    const Range range = domain.ranges.at(x);
    if (range.is_integer && !Forms(domain).is_integer(value)) return false;
    given.push_back(kernel::eq(x, value));
    const auto written = [&](Expr e) { return kernel::substitute(e, {{x, value}}); };
    const auto& [is_integer, low, high] = range;
    if (low) domain.further.push_back({x, low->is_inside ? ">=" : ">", low->value});
    if (high) domain.further.push_back({x, high->is_inside ? "<=" : "<", high->value});
    domain.ranges.erase(x);
    left = written(left);
    right = written(right);
    for (auto& c : domain.further) c = {written(c.left), c.relation, written(c.right)};
    std::erase_if(domain.further, [](const auto& c) { return holds(c) == true; });
    return true;
  }
  std::string shown_point(const Point& point) const {
    std::string out;
    for (Expr is : given) out += (out.empty() ? "" : ", ") + typed_text(is);
    return out + (out.empty() || point.empty() ? "" : ", ") + equality::text(point);
  }
  bool is_counterexample(const Point& point, const std::string& how) {
    verdict.answer = Answer::Different;
    verdict.proof = how;
    verdict.counterexample =
        Counterexample{point, shown_point(point), shown_value(at(point, left)),
                       shown_value(at(point, right)), shown_value(at(point, left - right))};
    return true;
  }
  bool is_different_somewhere() {
    const Domain box = narrowed(domain, conditions(domain));
    auto all = points(box, wanted == Wanted::Case ? points_of_case : points_tried, {left, right});
    if (all.empty()) kernel::refuse("no point of the domain was found");
    const auto add = [&](const Domain& part, std::size_t count) {
      for (const Point& point : points(part, count, {}, true))
        if (std::ranges::find(all, point) == all.end()) all.push_back(point);
    };
    add(narrowed(box, needs), wanted == Wanted::Case ? points_of_case : points_inside);
    for (const Requirement& r : needs)  // where one side may have no value
      if (r.kind != Need::NotZero && wanted != Wanted::Case)
        add(narrowed(box, {{Need::NotNegative, -r.term}}), points_beyond);
    std::string why_none;
    bool is_open = false;  // somewhere it would take more bits to know a value
    std::ranges::stable_sort(all, {}, size);
    for (const Point& point : all) {
      Value a, b;
      for (int bits = 192; bits <= 3072; bits *= 4) {
        a = value_at(point, left, bits);
        b = value_at(point, right, bits);
        if (a.is_known() && b.is_known()) break;
      }
      is_open = is_open || !a.is_known() || !b.is_known();
      if (!a.is_known() || !b.is_known()) continue;
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
  bool proved(const std::string& how) { return verdict.proof = how, true; }
  bool prove() {
    if (left == right) return proved("both sides are the same expression");
    std::set<std::string> whole;
    for (Expr e : parts_of(left - right)) {
      if (!is_call(e, "raised") || kernel::free_variables(e.arg(1)).empty() ||
          !is_whole_form(e.arg(1)) || Forms(domain).is_integer(e.arg(1)))
        continue;
      if (!is_proved_below_0(e))
        return proved("not decided at whole exponents of " + typed_text(e.arg(0))), false;
      if (is_certain({Need::Positive, Expr(-1) * e.arg(0)}, domain))
        for (Expr symbol : kernel::free_variables(e.arg(1)))
          if (!Forms(domain).is_integer(symbol)) whole.insert(typed_text(symbol) + " integer");
    }
    verdict.conditions.assign(whole.begin(), whole.end());
    if (!whole.empty()) return proved("whole exponents: elsewhere there is no value");
    if (has_impossible_need()) return false;
    const Expr difference = left - right;
    if (domain.ranges.empty() && exact_sign(difference) == 0)
      return proved(is_algebraic(difference)
                        ? "algebraic numbers: the difference is below the least that it could be"
                        : no_difference);
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
    if (wanted == Wanted::Case) return false;
    const Domain box = narrowed(part, conditions(part));
    const auto never_holds = [&](const Requirement& r) {  // x + sqrt(x^2 - 1) > 0 where x <= 0
      return r.kind == Need::Positive && is_certain({Need::NotNegative, -r.term}, box, needs);
    };
    if (std::ranges::any_of(needs, never_holds)) return true;
    return is_proved([&] {  // not where there is no point
      const Verdict found = decide(left, right, part, Wanted::Case);
      return found.answer == Answer::Equal && proved(found.proof);
    });
  }
  /// A new symbol is an integer, or in another range.
  bool is_proved_where(Expr l, const std::string& relation, Expr r,
                       const Range& range = {.is_integer = true}) {
    Domain part = domain;
    part.further.push_back({l, relation, r});
    for (Expr symbol : kernel::free_variables(r)) part.ranges.try_emplace(symbol, range);
    return is_proved_on(part);
  }
  /// x >= 0 and x <= 0 where |x| or a root is, few integers, or an integer even and odd. Or with
  /// a root as the unknown: sqrt(x + 2 sqrt(x - 1)) is sqrt(s^2 + 1 + 2 s).
  bool prove_by_cases() {
    const std::string before = verdict.proof;
    for (Expr e : turns(left - right))
      if (is_proved_where(e, ">=", 0) && is_proved_where(e, "<=", 0)) {
        const std::string name = typed_text(e);
        return proved("cases: " + name + " >= 0 and " + name + " <= 0");
      }
    const Expr root = kernel::real("value_of_root");  // which nobody can type
    for (Expr e : parts_of(left - right)) {
      if (!is_call(e, "sqrt")) continue;
      for (Expr x : kernel::free_variables(e)) {
        const auto value = zero_of(e.arg(0) - kernel::power(root, 2), x);
        if (value && is_proved_where(x, "=", *value, {.low = End{0, true}}))
          return proved("normal form, with " + typed_text(e) + " as the unknown");
      }
    }
    for (const auto& [x, r] : domain.ranges) {
      if (!r.is_integer) continue;
      const std::string name = typed_text(x);
      if (r.low && r.high && is_proved_for_each(x, r)) return proved("cases: each " + name);
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
  /// x^y below 0 where y is whole, as are its symbols; (-1)^y has values there alone.
  bool is_proved_below_0(Expr power) {
    const Expr base = power.arg(0), exponent = power.arg(1), k = kernel::integer("whole_exponent");
    Domain whole = domain;
    whole.further.push_back({base, "<", 0});
    Expr others = left - right;  // what else is needed
    const Exprs parts = parts_of(others);
    for (Expr e : parts)
      if (is_call(e, "raised") && is_certain({Need::Positive, Expr(-1) * e.arg(0)}, whole))
        for (Expr x : kernel::free_variables(e.arg(1))) whole.ranges[x].is_integer = true;
    for (auto e = parts.rbegin(); e != parts.rend(); ++e)
      if (is_call(*e, "raised") && !Forms(whole).is_integer(e->arg(1)))
        others = kernel::replace(others, *e, e->arg(0) + e->arg(1));
    const auto never_holds = [&](const Requirement& r) {
      return r.kind != Need::NotZero && is_certain({Need::Positive, -r.term}, whole);
    };
    if (is_certain({Need::NotNegative, base}, domain, requirements(base - exponent, domain)) ||
        std::ranges::any_of(requirements(others, whole), never_holds))
      return true;
    if (!Forms(whole).is_integer(exponent)) whole.further.push_back({exponent, "=", k});
    if (!Forms(whole).is_integer(exponent)) whole.ranges[k] = {.is_integer = true};
    return wanted != Wanted::Case && is_proved([&] {
             return decide(left, right, whole, Wanted::Case).answer == Answer::Equal;
           });
  }
  bool is_same_form(Expr other) {
    try {
      Forms forms(narrowed(narrowed(domain, conditions(domain)), needs));
      for (int pass = 0; pass < 2; ++pass) {  // a sign found late names earlier terms anew
        for (const Requirement& r : needs) forms.assume(r);
        for (const auto& r : conditions(domain)) is_proved([&] { return forms.assume(r), true; });
      }
      const Sum difference = forms.of(left) - forms.of(other);
      if (forms.is_zero(difference)) return proved(no_difference);
      if (forms.is_zero(forms.of(notation::call("exp", 2 * (left - other))) - number(1)))
        return proved("normal form: the exponential of twice the difference is 1");
      for (Expr root : parts_of(left - other)) {
        const Expr name = kernel::real("value_of_root");  // which nobody can type
        if (!is_call(root, "sqrt") || kernel::free_variables(root).empty()) continue;
        const auto value = zero_of(kernel::replace(left - other, root, name), name);
        if (value && forms.is_not_negative(forms.of(*value)) &&
            forms.is_zero(forms.of(kernel::power(*value, 2) - root.arg(0))))
          return proved("normal form: " + typed_text(root) + " alone on one side, and squared");
      }
      if (forms.is_not_negative(forms.of(left)) && forms.is_not_negative(forms.of(other)) &&
          forms.is_zero(forms.of(kernel::power(left, 2) - kernel::power(other, 2))))
        return proved("normal form: neither side is negative, and their squares are equal");
    } catch (const TooLarge& large) {
      verdict.proof = std::string("not decided: ") + large.what();
    } catch (const std::runtime_error&) {  // not defined, or not certain
    }
    return false;
  }
  bool is_different_exactly() {
    for (std::size_t i = 0; i < std::min(common.size(), points_exactly); ++i)
      if (exact_sign(at(common[i], left - right)).value_or(0) != 0)
        return is_counterexample(common[i],
                                 "both sides at one point, compared with as many bits as it takes");
    return false;
  }

  void add_conditions() {
    const auto is_sure = [&](const Requirement& r) { return is_certain(r, domain); };
    for (const Requirement& r : needs) {
      const bool is_weaker = r.kind == Need::NotNegative &&  // than another one, or whole exponents
                             (std::ranges::count(needs, Requirement{Need::Positive, r.term}) > 0 ||
                              is_certain({Need::Positive, Expr(-1) * r.term}, domain));
      if (is_weaker || is_sure(r) || std::ranges::count(verdict.conditions, text(r)) > 0) continue;
      verdict.conditions.push_back(text(r));
      if (r.kind != Need::NotZero || wanted != Wanted::Explanation) continue;
      note_gap(r.term);
      for (const auto& [side, other] : {std::pair("left", right), {"right", left}})
        if (verdict.notes.empty() && std::ranges::all_of(requirements(other, domain), is_sure))
          verdict.notes = {std::string("the ") + side + " side alone " +
                           said_of_zero(r.term, domain)};
    }
  }
  /// Where a divisor is 0 at none of the points that were tried, as at x = sqrt(2) or y = 7/x.
  void note_gap(Expr divisor) {
    std::vector<Point> all = points(domain, points_beside, {});
    all.resize(std::min(all.size(), domain.ranges.size() == 1 ? 1 : points_beside));
    for (const Point& point : all)
      for (const auto& [x, old] : point) {
        Domain there = domain;
        Point others = point;
        others.erase(x);
        for (const auto& [y, value] : others) there.further.push_back({y, "=", value});
        for (Expr value : zeros_of(at(others, divisor), x)) {
          if (!verdict.notes.empty() || gaps_tried++ >= most_gaps) return;
          there.further.push_back({x, "=", value});
          is_proved([&] {
            Question one(left, right, there, Wanted::Verdict);
            is_proved([&] { return one.is_different_somewhere(); });
            verdict.notes = one.verdict.notes;
            return true;
          });
          there.further.pop_back();
        }
      }
  }
};
}  // namespace

Verdict decide(Expr left, Expr right, const Domain& domain, Wanted wanted) try {
  return Question(left, right, domain, wanted).answer();
} catch (const NotDefined& none) {
  kernel::refuse(std::string("there is no value: ") + none.what());
} catch (const TooLarge& large) {
  return {.proof = std::string("not decided: ") + large.what()};
}
const char* word(Answer answer) {
  constexpr const char* words[]{"equal", "different", "undecided"};
  return words[static_cast<std::size_t>(answer)];
}
}  // namespace equality
