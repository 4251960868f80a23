// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/requirements.hpp"

#include <algorithm>

#include <cln/integer.h>
#include <ginac/ginac.h>

#include "equality/constant.hpp"
#include "equality/evaluate.hpp"
#include "equality/point.hpp"
#include "equality/translation.hpp"

namespace magicmass::equality {
namespace {

using GiNaC::ex;
using ReqKind = Requirement::Kind;

void add(ReqKind kind, const Tree& tree, std::vector<Requirement>& all) {
  if (tree->is_constant) return;
  for (const Requirement& known : all)
    if (known.kind == kind && identical(known.tree, tree)) return;
  all.push_back({kind, tree});
}

void collect(const Tree& tree, std::vector<Requirement>& all) {
  if (tree->is_constant) return;
  for (const Tree& part : tree->parts) collect(part, all);
  const auto argument = [&]() -> const Tree& { return tree->parts[0]; };
  switch (tree->kind) {
    case Kind::quotient:
      return add(ReqKind::nonzero, tree->parts[1], all);
    case Kind::root:
      return add(cln::oddp(cln::numerator(tree->value)) ? ReqKind::smooth : ReqKind::not_negative,
                 argument(), all);
    case Kind::power: {
      const Tree& exponent = tree->parts[1];
      if (!is_number(exponent)) {
        if (!is_number(argument()) || argument()->value <= 0)
          add(ReqKind::positive, argument(), all);
        return;
      }
      if (!is_integer(exponent->value)) add(ReqKind::not_negative, argument(), all);
      if (exponent->value <= 0) add(ReqKind::nonzero, argument(), all);
      return;
    }
    case Kind::function:
      if (tree->name == "tan") add(ReqKind::nonzero, function("cos", argument()), all);
      if (tree->name == "log") add(ReqKind::positive, argument(), all);
      if (tree->name == "abs") add(ReqKind::smooth, argument(), all);
      if (tree->name == "asin" || tree->name == "acos")
        add(ReqKind::not_negative, difference(number(1), power(argument(), number(2))), all);
      return;
    default:
      return;
  }
}

bool is_isolated(const Requirement& requirement) {
  return requirement.kind == ReqKind::nonzero || requirement.kind == ReqKind::smooth;
}

// `strict`: with > for >= and != for smooth.
bool holds(const Requirement& requirement, Translation& translation, bool strict) {
  try {
    const ex e = translation(requirement.tree);
    switch (requirement.kind) {
      case ReqKind::smooth:
        if (!strict) return true;
        [[fallthrough]];
      case ReqKind::nonzero:
        return translation.is_positive(e) || translation.is_positive(-e);
      case ReqKind::positive:
        return translation.is_positive(e);
      case ReqKind::not_negative:
        return strict ? translation.is_positive(e) : translation.is_not_negative(e);
    }
  } catch (const proof::NotInClass&) {
  }
  return false;
}

bool has_closed_end(const Range& range) {
  return !range.is_integer && ((range.low && range.has_low) || (range.high && range.has_high));
}

// On the whole domain: on its interior, and again with each end that belongs to it put in.
bool holds_everywhere(const Requirement& requirement, const Domain& domain) {
  if (requirement.tree->is_constant) {
    try {
      const Ball ball = evaluate_to(at({}, requirement.tree), 60, exact_sign_or_nothing);
      auto sign = equality::sign(ball);
      if (!sign) sign = exact_sign_or_nothing(requirement.tree);
      if (!sign) return false;
      if (requirement.kind == ReqKind::nonzero) return *sign != 0;
      if (requirement.kind == ReqKind::positive) return *sign > 0;
      return requirement.kind == ReqKind::smooth || *sign >= 0;
    } catch (const NotDefined&) {
      return false;
    } catch (const NotCertain&) {
      return false;
    }
  }
  Translation wide(domain, {.view = Translation::View::wide});
  if (holds(requirement, wide, false)) return true;
  Translation exact(domain, {.view = Translation::View::exact});
  if (!holds(requirement, exact, false)) return false;
  for (const auto& [name, range] : domain.ranges) {
    if (!has_closed_end(range)) continue;
    Domain face = domain;
    face.ranges.erase(name);
    for (const auto& [end, belongs] :
         {std::pair{range.low, range.has_low}, std::pair{range.high, range.has_high}})
      if (end && belongs &&
          !holds_everywhere({requirement.kind, substituted(requirement.tree, name, number(*end))},
                            face))
        return false;
  }
  return true;
}

}  // namespace

std::string to_text(const Requirement& requirement) {
  const char* relation = requirement.kind == ReqKind::not_negative ? " >= 0"
                         : requirement.kind == ReqKind::positive   ? " > 0"
                                                                   : " != 0";
  return to_text(requirement.tree) + relation;
}

std::vector<Requirement> requirements(const Tree& tree) {
  std::vector<Requirement> all;
  collect(tree, all);
  return all;
}

std::vector<Requirement> unproved(const std::vector<Requirement>& requirements,
                                  const Domain& domain) {
  std::vector<Requirement> result;
  for (const Requirement& requirement : requirements)
    if (!holds_everywhere(requirement, domain)) result.push_back(requirement);
  return result;
}

bool is_analytic_inside(const std::vector<Requirement>& requirements, const Domain& domain) {
  Translation wide(domain, {.view = Translation::View::wide});
  Translation exact(domain, {.view = Translation::View::exact});
  return std::all_of(requirements.begin(), requirements.end(), [&](const Requirement& r) {
    return holds(r, wide, true) || holds(r, exact, true);
  });
}

bool are_equivalent(const std::vector<Requirement>& left, const std::vector<Requirement>& right,
                    const Domain& domain) {
  Translation translation(domain, {.view = Translation::View::wide});
  const auto has_match = [&](const Requirement& one, const std::vector<Requirement>& others) {
    return std::any_of(others.begin(), others.end(), [&](const Requirement& other) {
      if (one.kind != other.kind) return false;
      if (identical(one.tree, other.tree)) return true;
      try {  // the one a positive multiple of the other
        return translation.is_positive(translation(one.tree) / translation(other.tree));
      } catch (const proof::NotInClass&) {
        return false;
      } catch (const GiNaC::pole_error&) {
        return false;
      }
    });
  };
  const auto all_matched = [&](const auto& ones, const auto& others) {
    return std::all_of(ones.begin(), ones.end(), [&](const Requirement& requirement) {
      return is_isolated(requirement) || has_match(requirement, others);
    });
  };
  return all_matched(left, right) && all_matched(right, left);
}

}  // namespace magicmass::equality
