// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/comparison.hpp"

#include <algorithm>
#include <variant>

#include "equality/constant.hpp"

namespace magicmass::equality {
namespace {

using Outcome = PointComparison::Outcome;

constexpr int working_digits = 120;
constexpr int many_digits[] = {500, 2000};
constexpr int shortest_shown = 20;

struct Side {
  Tree tree;
  std::optional<Ball> value;
  std::string reason;  // why it is not defined; empty: it is not known
  bool isolated = false;
};

Side side_at(const Point& point, const Tree& tree) {
  Side side{at(point, tree), std::nullopt, ""};
  try {
    side.value = evaluate_to(side.tree, working_digits, exact_sign_or_nothing);
  } catch (const NotDefined& error) {
    side.reason = error.what();
    side.isolated = error.isolated;
  } catch (const NotCertain&) {
  }
  return side;
}

int decimal_places(const Ball& small, const Ball& scale) {  // of agreement relative to the scale
  const cln::cl_F size = cln::abs(small.middle) + small.radius;
  const cln::cl_F whole = cln::abs(scale.middle) + scale.radius;
  if (cln::zerop(size)) return working_digits;
  const cln::float_format_t coarse = cln::float_format(17);
  // relative, but absolute where the scale may be 0
  const cln::cl_F ratio = cln::cl_float(sign(scale).value_or(0) == 0 ? size : size / whole, coarse);
  const double places = -cln::double_approx(cln::ln(ratio)) / 2.302585092994046;
  return std::clamp(static_cast<int>(places), 0, working_digits);
}

std::string shown(const Side& side, int digits) {
  if (!side.value) return "not defined (" + side.reason + ")";
  if (is_number(side.tree)) {
    const std::string exact = to_text(side.tree);
    if (exact.size() <= 60) return exact;
  }
  if (!equality::sign(*side.value)) {
    const auto exact = exact_sign_or_nothing(side.tree);
    if (exact && *exact == 0) return "0";
    const int places = decimal_places(*side.value, *side.value);
    return places > 0 ? "0 to " + std::to_string(places) + " digits" : "not certain to any digit";
  }
  return equality::shown(*side.value, digits);
}

}  // namespace

PointComparison compare_at(const Point& point, const Tree& lhs, const Tree& rhs, bool exactly) {
  const Side left = side_at(point, lhs);
  const Side right = side_at(point, rhs);
  PointComparison result;
  for (const auto& [name, value] : point) result.values.point[name] = to_text(number(value));
  const auto found = [&](Outcome outcome, int digits) {
    result.outcome = outcome;
    result.values.left = shown(left, digits);
    result.values.right = shown(right, digits);
    return result;
  };
  if (!left.value || !right.value) {
    const bool one_alone =
        (left.value && !right.reason.empty()) || (right.value && !left.reason.empty());
    if (!left.reason.empty() && !right.reason.empty()) result.outcome = Outcome::neither;
    if (!one_alone) return result;
    if (left.isolated || right.isolated) return found(Outcome::pole, shortest_shown);
    return found(left.value ? Outcome::right_not_defined : Outcome::left_not_defined,
                 shortest_shown);
  }
  const BallArithmetic arithmetic(working_digits);
  const bool rational = is_number(left.tree) && is_number(right.tree);
  const Ball rest = rational
                        ? arithmetic.number(left.tree->value - right.tree->value)
                        : arithmetic.sum(*left.value, {-right.value->middle, right.value->radius});
  auto sign = equality::sign(rest);
  for (const int digits : many_digits) {
    if (sign || !exactly) break;
    try {
      const Ball closer =
          evaluate_to(difference(left.tree, right.tree), digits, exact_sign_or_nothing);
      sign = equality::sign(closer);
      if (sign) result.values.difference = shown(closer, 4);
    } catch (const NotCertain&) {
    }
  }
  if (!sign && exactly) {
    const ExactResult exact = exact_sign(at({}, difference(left.tree, right.tree)));
    if (exact.is_nonzero) sign = *exact.is_nonzero ? 1 : 0;
  }
  if (sign && *sign != 0) {
    if (equality::sign(rest)) result.values.difference = shown(rest, 4);
    return found(Outcome::differ, std::max(shortest_shown, decimal_places(rest, *left.value) + 4));
  }
  result.outcome = Outcome::agree;
  result.is_exact = sign.has_value();
  result.digits = decimal_places(rest, *left.value);
  return result;
}

}  // namespace magicmass::equality
