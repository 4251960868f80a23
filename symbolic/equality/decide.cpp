// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/decide.hpp"

#include <algorithm>

#include "equality/comparison.hpp"
#include "equality/constant.hpp"
#include "equality/function_proof.hpp"
#include "equality/paper_names.hpp"
#include "equality/requirements.hpp"

namespace magicmass::equality {
namespace {

using Outcome = PointComparison::Outcome;

const char* const undecided_proof = "neither a proof nor a counterexample was found";
constexpr std::size_t points_tried = 60;
constexpr std::size_t points_tried_exactly = 3;
constexpr int fewest_poles = 3;  // so many are no isolated ones, where no other point has a value
                                 // or what is a little beside them is one, too

void require_defined(const Tree& constant, const std::string& side) {
  try {
    evaluate_to(constant, 120, exact_sign_or_nothing);
  } catch (const NotDefined& error) {
    throw NoQuestion("the " + side + " side has no value: " + error.what());
  } catch (const NotCertain&) {
  }
}

Verdict decide_constants(const Tree& lhs, const Tree& rhs,
                         const std::function<void(const Verdict&)>& provisional) {
  const Tree left = at({}, lhs);
  const Tree right = at({}, rhs);
  require_defined(left, "left");
  require_defined(right, "right");
  Verdict verdict;
  const auto different = [&](const PointComparison& comparison, const std::string& proof) {
    verdict.answer = Answer::different;
    verdict.counterexample = comparison.values;
    verdict.proof = proof;
    return verdict;
  };
  if (is_number(left) && is_number(right)) {
    if (left->value != right->value)
      return different(compare_at({}, left, right, false), "rational numbers, compared exactly");
    verdict.answer = Answer::equal;
    verdict.proof = "rational numbers, compared exactly";
    return verdict;
  }
  const PointComparison comparison = compare_at({}, left, right, false);
  if (comparison.outcome == Outcome::differ)
    return different(comparison,
                     "both numbers enclosed with certain error bounds; the enclosures are apart");
  if (comparison.outcome != Outcome::agree) {  // what the exact methods say is of defined numbers
    verdict.proof = "it is not certain that both sides are defined";
    return verdict;
  }
  verdict.agreeing_digits = comparison.digits;
  verdict.points = 1;
  verdict.proof = undecided_proof;
  if (provisional) provisional(verdict);
  const ExactResult exact = exact_sign(at({}, difference(left, right)));
  if (exact.is_nonzero) {
    if (*exact.is_nonzero) return different(compare_at({}, left, right, true), exact.method);
    verdict.answer = Answer::equal;
    verdict.proof = exact.method;
    return verdict;
  }
  const auto proof = identical(left, right)
                         ? std::optional<std::string>("both sides are the same expression")
                         : by_normal_form(left, right, {});
  if (proof) verdict.answer = Answer::equal;
  verdict.proof = proof.value_or("no exact method decides these constants");
  return verdict;
}

class FunctionQuestion {
public:
  FunctionQuestion(const Tree& lhs, const Tree& rhs, const Domain& domain)
      : lhs_(lhs), rhs_(rhs), domain_(domain) {
    verdict_.domain = to_texts(domain);
  }

  Verdict decide(const std::function<void(const Verdict&)>& provisional) {
    const bool same = identical(lhs_, rhs_);
    points_ = points_of(domain_, points_tried, exact_sign_or_nothing);
    if (points_.empty()) throw NoQuestion("no point of the domain was found");
    if (!compare(points_, false, same)) return verdict_;
    if (common_.empty() && poles_ == 0 && unknown_ == 0)
      throw NoQuestion("no point was found where both sides have a value");
    verdict_.points = static_cast<int>(common_.size());
    verdict_.proof = undecided_proof;
    if (provisional) provisional(verdict_);
    if (!common_.empty() && prove(same)) return verdict_;
    // Ever closer: what agrees to all digits that were computed may still differ.
    const std::vector<Point> few(
        common_.begin(), common_.begin() + static_cast<std::ptrdiff_t>(
                                               std::min(common_.size(), points_tried_exactly)));
    if (!compare(few, true, false)) return verdict_;
    return verdict_;
  }

private:
  // Fills in the counterexample and returns false where one was found.
  bool compare(const std::vector<Point>& points, bool exactly, bool one_is_enough) {
    std::optional<PointComparison> first_pole;
    for (const Point& point : points) {
      const PointComparison comparison = compare_at(point, lhs_, rhs_, exactly);
      switch (comparison.outcome) {
        case Outcome::differ:
          return found(comparison,
                       exactly ? "both values at one point, compared exactly"
                               : "both values at one point, enclosed with certain error bounds");
        case Outcome::left_not_defined:
          return found(comparison, "at one point the left side alone is not defined");
        case Outcome::right_not_defined:
          return found(comparison, "at one point the right side alone is not defined");
        case Outcome::pole:
          if (!first_pole) first_pole = comparison;
          ++poles_;
          if (persistent_ < fewest_poles && is_pole_beside(point)) ++persistent_;
          break;
        case Outcome::agree:
          if (exactly) break;
          verdict_.agreeing_digits = common_.empty()
                                         ? comparison.digits
                                         : std::min(verdict_.agreeing_digits, comparison.digits);
          common_.push_back(point);
          if (one_is_enough) return true;
          break;
        case Outcome::neither:
          break;
        case Outcome::unknown:
          ++unknown_;
          break;
      }
    }
    const bool has_nothing_else = common_.empty() && poles_ >= fewest_poles &&
                                  static_cast<std::size_t>(poles_) * 3 >= points.size();
    if (first_pole && (has_nothing_else || persistent_ >= fewest_poles))
      return found(*first_pole, "at this point and others one side alone divides by zero");
    return true;
  }

  // One side alone divides by zero, too, where all real symbols are moved a little, each by something else: zeros
  // of a denominator in between are met by points as simple as those that were tried, but not by this one.
  bool is_pole_beside(const Point& point) const {
    if (!domain_.further.empty()) return false;
    Point beside = point;
    cln::cl_RA step = cln::cl_RA(355) / 100003;
    bool is_moved = false;
    for (auto& [name, value] : beside) {
      const Range& range = domain_.ranges.at(name);
      if (range.is_integer) continue;
      for (const cln::cl_RA& moved : {value + step, value - step})
        if (range.contains(moved)) {
          value = moved;
          is_moved = true;
          break;
        }
      step = step * 3 / 7;
    }
    return is_moved && compare_at(beside, lhs_, rhs_, false).outcome == Outcome::pole;
  }

  bool found(const PointComparison& comparison, const std::string& proof) {
    verdict_.answer = Answer::different;
    verdict_.proof = proof;
    verdict_.counterexample = comparison.values;
    return false;
  }

  bool prove(bool same) {
    const std::vector<Requirement> left = unproved(requirements(lhs_), domain_);
    const std::vector<Requirement> right = unproved(requirements(rhs_), domain_);
    if (!same && !are_equivalent(left, right, domain_)) {
      verdict_.proof = "it is not proved that both sides are defined at the same points";
      return false;
    }
    std::optional<std::string> proof;
    if (same) proof = "both sides are the same expression";
    if (!proof) proof = by_normal_form(lhs_, rhs_, domain_);
    if (!proof) proof = by_derivative(lhs_, rhs_, domain_, common_);
    if (!proof) proof = by_unified_angles(lhs_, rhs_, domain_, common_);
    if (!proof) return false;
    verdict_.answer = Answer::equal;
    verdict_.proof = *proof;
    for (const auto& side : {left, right})
      for (const Requirement& requirement : side)
        if (requirement.kind != Requirement::Kind::smooth) add_condition(to_text(requirement));
    return true;
  }

  void add_condition(const std::string& condition) {
    auto& all = verdict_.conditions;
    if (std::find(all.begin(), all.end(), condition) == all.end()) all.push_back(condition);
  }

  const Tree& lhs_;
  const Tree& rhs_;
  const Domain& domain_;
  Verdict verdict_;
  std::vector<Point> points_;
  std::vector<Point> common_;  // where both are defined, and agree
  int poles_ = 0;
  int persistent_ = 0;  // of them
  int unknown_ = 0;
};

}  // namespace

Tree with_meanings(const Tree& tree) {
  Tree result = tree;
  for (const std::string& name : symbols_of(tree))
    if (const auto value = meaning(name)) result = substituted(result, name, *value);
  return result;
}

Verdict decide(const Tree& lhs, const Tree& rhs, const Domain& domain,
               const std::function<void(const Verdict&)>& provisional) {
  Verdict verdict = lhs->is_constant && rhs->is_constant
                        ? decide_constants(lhs, rhs, provisional)
                        : FunctionQuestion(lhs, rhs, domain).decide(provisional);
  if (verdict.answer != Answer::undecided) verdict.agreeing_digits = verdict.points = 0;
  return verdict;
}

}  // namespace magicmass::equality
