// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include <cln/integer.h>
#include <cln/real.h>

#include "equality/constant.hpp"
#include "equality/function_proof.hpp"

namespace magicmass::equality {
namespace {

constexpr std::size_t most_functions = 6;
constexpr long largest_denominator = 8;

void collect_inverse_functions(const Tree& tree, std::vector<Tree>& all) {
  if (tree->is_constant) return;
  for (const Tree& part : tree->parts) collect_inverse_functions(part, all);
  if (!is_function(tree, "atan") && !is_function(tree, "asin") && !is_function(tree, "acos"))
    return;
  if (std::none_of(all.begin(), all.end(), [&](const Tree& one) { return identical(one, tree); }))
    all.push_back(tree);
}

Tree replaced(const Tree& tree, const Tree& from, const Tree& to) {
  if (identical(tree, from)) return to;
  if (tree->parts.empty()) return tree;
  std::vector<Tree> parts;
  for (const Tree& part : tree->parts) parts.push_back(replaced(part, from, to));
  return with_parts(tree, std::move(parts));
}

std::optional<cln::cl_RA> simple_fraction(double value) {
  for (long below = 1; below <= largest_denominator; ++below)
    if (std::abs(value) < 100 && std::abs(value * static_cast<double>(below) -
                                          std::round(value * static_cast<double>(below))) < 1e-9)
      return cln::cl_RA(std::lround(value * static_cast<double>(below))) / below;
  return std::nullopt;
}

double approximate(const Tree& tree, const Point& point) {
  return cln::double_approx(evaluate_to(at(point, tree), 30, exact_sign_or_nothing).middle);
}

// B = rho A + sigma pi: a guess from two points, then proved like any other equation.
std::optional<Tree> in_terms_of(const Tree& one, const Tree& other, const Domain& domain,
                                const std::vector<Point>& points) {
  if (points.empty()) return std::nullopt;
  try {
    const double first = approximate(one, points[0]);
    const auto second = std::find_if(points.begin(), points.end(), [&](const Point& point) {
      return std::abs(approximate(one, point) - first) > 1e-6;
    });
    if (second == points.end()) return std::nullopt;
    const double step = approximate(one, *second) - first;
    const double slope = (approximate(other, *second) - approximate(other, points[0])) / step;
    const double start = approximate(other, points[0]) - slope * first;
    const auto rho = simple_fraction(slope);
    const auto sigma = simple_fraction(start / 3.14159265358979323846);
    if (!rho || *rho == 0 || !sigma) return std::nullopt;
    Tree guess = product({number(*rho), one});
    if (*sigma != 0) guess = sum({guess, product({number(*sigma), pi()})});
    if (by_derivative(other, guess, domain, points)) return guess;
  } catch (const NotDefined&) {
  } catch (const NotCertain&) {
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> by_unified_angles(const Tree& lhs, const Tree& rhs, const Domain& domain,
                                             const std::vector<Point>& points) {
  std::vector<Tree> functions;
  collect_inverse_functions(lhs, functions);
  collect_inverse_functions(rhs, functions);
  if (functions.size() < 2 || functions.size() > most_functions) return std::nullopt;
  Tree left = lhs;
  Tree right = rhs;
  std::string replacements;
  for (std::size_t i = 1; i < functions.size(); ++i) {
    const auto value = in_terms_of(functions[0], functions[i], domain, points);
    if (!value) continue;
    left = replaced(left, functions[i], *value);
    right = replaced(right, functions[i], *value);
    replacements +=
        (replacements.empty() ? "" : ", ") + to_text(functions[i]) + " = " + to_text(*value);
  }
  if (replacements.empty()) return std::nullopt;
  const auto proof = by_normal_form(left, right, domain);
  if (!proof) return std::nullopt;
  return replacements + " (derivative and one point); then " + *proof;
}

}  // namespace magicmass::equality
