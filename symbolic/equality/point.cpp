// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/point.hpp"

#include <algorithm>
#include <numeric>

#include <cln/integer.h>

namespace magicmass::equality {
namespace {

constexpr long largest_bits = 20000;
constexpr int most_tried = 3000;  // where few points satisfy the further conditions

bool is_moderate(const cln::cl_RA& x, const cln::cl_I& exponent) {
  const long bits = static_cast<long>(
      std::max(cln::integer_length(cln::numerator(x)), cln::integer_length(cln::denominator(x))));
  return cln::abs(exponent) * bits <= largest_bits;
}

bool all_numbers(const std::vector<Tree>& parts) {
  return std::all_of(parts.begin(), parts.end(), [](const Tree& part) {
    return is_number(part) && is_moderate(part->value, 1);
  });
}

Tree folded(const Tree& tree) {
  const std::vector<Tree>& parts = tree->parts;
  if (parts.empty() || !all_numbers(parts)) return tree;
  switch (tree->kind) {
    case Kind::sum: {
      cln::cl_RA total = 0;
      for (const Tree& part : parts) total = total + part->value;
      return number(total);
    }
    case Kind::product: {
      cln::cl_RA total = 1;
      for (const Tree& part : parts) total = total * part->value;
      return number(total);
    }
    case Kind::quotient:
      return parts[1]->value == 0 ? tree : number(parts[0]->value / parts[1]->value);
    case Kind::power: {
      const cln::cl_RA& base = parts[0]->value;
      if (!is_integer(parts[1]->value)) return tree;
      const cln::cl_I exponent = cln::numerator(parts[1]->value);
      if ((base == 0 && exponent <= 0) || !is_moderate(base, exponent)) return tree;
      return number(cln::expt(base, exponent));
    }
    case Kind::root: {
      cln::cl_RA exact = 0;
      const uintL order = cln::cl_I_to_uint(cln::numerator(tree->value));
      if (parts[0]->value < 0 || !cln::rootp(parts[0]->value, order, &exact)) return tree;
      return number(exact);
    }
    case Kind::function:
      if (tree->name == "abs") return number(cln::abs(parts[0]->value));
      if (parts[0]->value == 0 && (tree->name == "sin" || tree->name == "tan" ||
                                   tree->name == "atan" || tree->name == "asin"))
        return number(0);
      if (parts[0]->value == 0 && (tree->name == "cos" || tree->name == "exp")) return number(1);
      return tree;
    default:
      return tree;
  }
}

bool holds(const Comparison& comparison, const Point& point, const ExactSign& exact_sign) {
  const Tree left_minus_right = at(point, difference(comparison.left, comparison.right));
  try {
    const Ball ball = evaluate_to(left_minus_right, 200, exact_sign);
    auto sign = equality::sign(ball);
    if (!sign && exact_sign) sign = exact_sign(left_minus_right);
    if (!sign) return false;
    const std::string& relation = comparison.relation;
    if (relation == "=") return *sign == 0;
    if (relation == "!=") return *sign != 0;
    if (*sign == 0) return relation.size() == 2;
    return (*sign < 0) == (relation[0] == '<');
  } catch (const NotDefined&) {
    return false;
  } catch (const NotCertain&) {
    return false;
  }
}

}  // namespace

std::string to_text(const Point& point) {
  std::string result;
  for (const auto& [name, value] : point)
    result += (result.empty() ? "" : ", ") + name + " = " + to_text(number(value));
  return result;
}

Tree at(const Point& point, const Tree& tree) {
  if (tree->kind == Kind::symbol) {
    const auto found = point.find(tree->name);
    return found == point.end() ? tree : number(found->second);
  }
  if (tree->parts.empty()) return tree;
  std::vector<Tree> parts;
  parts.reserve(tree->parts.size());
  bool same = true;
  for (const Tree& part : tree->parts) {
    parts.push_back(at(point, part));
    same = same && parts.back() == part;
  }
  return folded(same ? tree : with_parts(tree, std::move(parts)));
}

std::vector<Point> points_of(const Domain& domain, std::size_t count, const ExactSign& exact_sign) {
  std::vector<std::string> names;
  std::vector<std::vector<cln::cl_RA>> values;
  for (const auto& [name, range] : domain.ranges) {
    names.push_back(name);
    values.push_back(simple_values(range, domain.ranges.size() == 1 ? count : 24));
    if (values.back().empty()) return {};
  }
  std::vector<Point> points;
  int tried = 0;
  const std::size_t dimension = names.size();
  const auto visit = [&](const auto& self, std::size_t depth, std::size_t remaining,
                         Point& point) -> void {
    if (points.size() >= count || tried > most_tried) return;
    if (depth == dimension) {
      if (remaining > 0) return;
      ++tried;
      if (std::all_of(domain.further.begin(), domain.further.end(),
                      [&](const Comparison& c) { return holds(c, point, exact_sign); }))
        points.push_back(point);
      return;
    }
    for (std::size_t i = 0; i <= remaining && i < values[depth].size(); ++i) {
      point[names[depth]] = values[depth][i];
      self(self, depth + 1, remaining - i, point);
    }
    point.erase(names[depth]);
  };
  std::size_t last = 0;
  for (const auto& list : values) last += list.size() - 1;
  // The sum of the places in the lists grows: simple points first. A bound on the work where few points hold.
  for (std::size_t total = 0; total <= std::min<std::size_t>(last, 60) && points.size() < count;
       ++total) {
    Point point;
    visit(visit, 0, total, point);
  }
  return points;
}

}  // namespace magicmass::equality
