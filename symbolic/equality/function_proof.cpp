// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/function_proof.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include <cln/integer.h>
#include <ginac/ginac.h>

#include "equality/angle.hpp"
#include "equality/constant.hpp"
#include "equality/requirements.hpp"
#include "equality/translation.hpp"

namespace magicmass::equality {
namespace {

using GiNaC::ex;

constexpr long most_residues = 24;
constexpr std::size_t most_points = 6;

const std::array<Translation::Manner, 6> manners{
    {{.view = Translation::View::wide, .kept_inverses = true},
     {.view = Translation::View::wide},
     {.view = Translation::View::wide, .halved_angles = true, .kept_inverses = true},
     {.view = Translation::View::exact, .kept_inverses = true},
     {.view = Translation::View::exact},
     {.view = Translation::View::exact, .halved_angles = true, .kept_inverses = true}}};

// The denominators q of multiples p/q n pi of pi under cos, sin and tan, and 2 for (-1)^n: cos(n p pi/q) has a period
// that divides 2 q.
void collect_periods(const Tree& tree, const std::string& name, cln::cl_I& period) {
  if (tree->is_constant) return;
  const auto extend = [&](const Tree& part) {
    if (symbols_of(part).contains(name)) {
      const auto slope = [&](long from) {
        return linear_form(at({}, difference(substituted(part, name, number(from + 1)),
                                             substituted(part, name, number(from)))));
      };
      const LinearForm form = slope(1);
      if (slope(2).of_pi != form.of_pi) return;  // not linear in it
      if (form.of_pi != 0) period = cln::lcm(period, 2 * cln::denominator(form.of_pi));
    }
  };
  if (is_function(tree, "cos") || is_function(tree, "sin") || is_function(tree, "tan"))
    extend(tree->parts[0]);
  if (tree->kind == Kind::power && is_number(tree->parts[0]) && tree->parts[0]->value < 0)
    extend(product({pi(), tree->parts[1]}));
  for (const Tree& part : tree->parts) collect_periods(part, name, period);
}

struct Case {
  Tree lhs, rhs;
  Domain domain;
};

// n = q n' + r for r = 0 ... q - 1, for each integer symbol in turn.
std::vector<Case> residues(const Case& whole) {
  std::vector<Case> cases{whole};
  for (const auto& [name, range] : whole.domain.ranges) {
    if (!range.is_integer) continue;
    cln::cl_I period = 1;
    collect_periods(whole.lhs, name, period);
    collect_periods(whole.rhs, name, period);
    if (period == 1) continue;
    if (period * cln::cl_I(static_cast<long>(cases.size())) > most_residues) return {whole};
    std::vector<Case> finer;
    for (const Case& one : cases)
      for (cln::cl_I r = 0; r < period; r = r + 1) {
        const Tree value = sum({product({number(period), symbol(name)}), number(r)});
        Case next{substituted(one.lhs, name, value), substituted(one.rhs, name, value), one.domain};
        Range& values = next.domain.ranges.at(name);
        if (values.low) values.low = cln::cl_RA(cln::ceiling1((*values.low - r) / period));
        if (values.high) values.high = cln::cl_RA(cln::floor1((*values.high - r) / period));
        values.has_low = values.has_high = true;
        finer.push_back(std::move(next));
      }
    cases = std::move(finer);
  }
  return cases;
}

// The least common multiple of the orders of roots; 1 where there are none or it would be large.
long common_root_order(const std::vector<Tree>& trees) {
  constexpr long largest = 12;
  long order = 1;
  const auto visit = [&](const auto& self, const Tree& tree) -> void {
    if (tree->is_constant) return;
    if (tree->kind == Kind::root)
      order = std::lcm(order, cln::cl_I_to_long(cln::numerator(tree->value)));
    if (tree->kind == Kind::power && is_number(tree->parts[1]) &&
        cln::denominator(tree->parts[1]->value) <= largest)
      order = std::lcm(order, cln::cl_I_to_long(cln::denominator(tree->parts[1]->value)));
    order = std::min(order, largest + 1);
    for (const Tree& part : tree->parts) self(self, part);
  };
  for (const Tree& tree : trees) visit(visit, tree);
  return order > largest ? 1 : order;
}

bool normal_form_is_zero(const Case& one, Translation::View view) {
  const long order = common_root_order({one.lhs, one.rhs});
  std::vector<Translation::Manner> tried{{.view = view}, {.view = view, .named_constants = false}};
  if (view == Translation::View::wide && order > 1) {
    tried.push_back({.view = view, .power = order});
    tried.push_back({.view = view, .named_constants = false, .power = order});
  }
  tried.push_back({.view = view, .halved_angles = true});
  return std::any_of(tried.begin(), tried.end(), [&](const Translation::Manner& manner) {
    try {
      Translation translation(one.domain, manner);
      return translation.is_zero(translation(one.lhs) - translation(one.rhs));
    } catch (const proof::NotInClass&) {
    } catch (const GiNaC::pole_error&) {
    } catch (const std::logic_error&) {  // what GiNaC throws where it does not know how
    }
    return false;
  });
}

bool derivatives_vanish(const Tree& lhs, const Tree& rhs, const Domain& domain,
                        const Translation::Manner& manner) {
  try {
    Translation translation(domain, manner);
    const ex f = translation(lhs) - translation(rhs);
    if (translation.has_opaque_powers()) return false;  // symbols that hide variables
    const auto vanishes = [&](const ex& variable) {
      return translation.is_zero(f.diff(GiNaC::ex_to<GiNaC::symbol>(variable)));
    };
    const auto& variables = translation.variables();
    return std::all_of(variables.begin(), variables.end(), vanishes);
  } catch (const proof::NotInClass&) {
  } catch (const GiNaC::pole_error&) {
  } catch (const std::logic_error&) {
  }
  return false;
}

bool has_closed_end(const Domain& domain) {
  return std::any_of(domain.ranges.begin(), domain.ranges.end(), [](const auto& entry) {
    const Range& range = entry.second;
    return !range.is_integer && (range.has_low || range.has_high);
  });
}

bool is_proved(const Case& one) {
  if (normal_form_is_zero(one, Translation::View::wide)) return true;
  // The interior alone: what belongs to the ends follows by continuity if both sides are defined all over the interior.
  if (has_closed_end(one.domain))
    for (const Tree& side : {one.lhs, one.rhs})
      for (const Requirement& requirement : unproved(requirements(side), one.domain))
        if (requirement.kind != Requirement::Kind::nonzero) return false;
  return normal_form_is_zero(one, Translation::View::exact);
}

}  // namespace

std::optional<std::string> by_normal_form(const Tree& lhs, const Tree& rhs, const Domain& domain) {
  const std::vector<Case> cases = residues({lhs, rhs, domain});
  if (!std::all_of(cases.begin(), cases.end(), is_proved)) return std::nullopt;
  return std::string(
             "normal form: the difference of the two sides, as a rational function of the "
             "symbols, of square roots and of cosines and sines with their relations, is 0") +
         (cases.size() > 1 ? ", for each of " + std::to_string(cases.size()) +
                                 " residues of the integers by itself"
                           : "");
}

std::optional<std::string> by_derivative(const Tree& lhs, const Tree& rhs, const Domain& domain,
                                         const std::vector<Point>& points) {
  const Tree rest = difference(lhs, rhs);
  if (!is_analytic_inside(requirements(rest), domain)) return std::nullopt;
  const bool is_constant =
      std::any_of(manners.begin(), manners.end(), [&](const Translation::Manner& manner) {
        return derivatives_vanish(lhs, rhs, domain, manner);
      });
  if (!is_constant) return std::nullopt;
  for (std::size_t i = 0; i < points.size() && i < most_points; ++i) {
    const ExactResult exact = exact_sign(at(points[i], rest));
    if (exact.sign && *exact.sign == 0)
      return "derivative and one point: every derivative of the difference is 0 in normal form, "
             "both "
             "sides are differentiable on the whole domain, and at " +
             to_text(points[i]) + " they agree exactly (" + exact.method + ")";
  }
  return std::nullopt;
}

}  // namespace magicmass::equality
