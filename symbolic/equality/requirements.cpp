// SPDX-License-Identifier: GPL-2.0-or-later
// What terms need to have a value.
#include "equality/atoms.hpp"

namespace equality {
using kernel::Op;
namespace {
// Proved for the square: 1 - sqrt(x)^2 is simpler than 1 - sqrt(x).
bool is_at_most_one(Expr x, const Domain& domain) {
  try {
    return Forms(domain).holds({Requirement::Kind::NotNegative, Expr(1) - kernel::power(x, 2)});
  } catch (const std::runtime_error&) {
    return false;
  }
}
}  // namespace

std::vector<Requirement> requirements(Expr term, const Domain& domain) {
  using Need = Requirement::Kind;
  std::vector<Requirement> out;
  std::set<Expr> seen;
  const auto visit = [&](auto& self, Expr e) -> void {
    if (!seen.insert(e).second) return;
    for (Expr arg : e.args()) self(self, arg);
    if (e.op() != Op::Fun || e.size() == 0) return;
    const std::string name = e.name();
    const Expr x = e.arg(0);
    if (name == "inv") out.push_back({Need::NotZero, x});
    if (name == "sqrt") out.push_back({Need::NotNegative, x});
    if (name == "log") out.push_back({Need::Positive, x});
    if ((name == "asin" || name == "acos") && !is_at_most_one(x, domain))
      for (Expr rest : {Expr(1) - x, Expr(1) + x}) out.push_back({Need::NotNegative, rest});
    if (name == "nth_root" && is_even(e.arg(1).value())) out.push_back({Need::NotNegative, x});
    if (name == "raised" && !Forms(domain).is_integer(e.arg(1)))
      out.push_back({Need::NotNegative, x});
  };
  visit(visit, term);
  return out;
}

Domain narrowed(Domain domain, const std::vector<Requirement>& needs) {
  const auto value = [](const Sum& sum) -> std::optional<cln::cl_RA> {
    if (sum.empty()) return cln::cl_RA(0);
    if (sum.size() > 1 || !sum.begin()->first.empty()) return {};
    return sum.begin()->second;
  };
  for (const Requirement& r : needs) {
    const std::set<Expr> symbols = kernel::free_variables(r.term);
    if (r.kind == Requirement::Kind::NotZero || symbols.size() != 1) continue;
    const Expr x = *symbols.begin();
    std::optional<cln::cl_RA> rise;
    std::optional<cln::cl_RA> start;
    try {
      Forms forms(domain);
      rise = value(forms.of(kernel::substitute(r.term, {{x, x + Expr(1)}}) - r.term));
      start = value(forms.of(kernel::substitute(r.term, {{x, 0}})));
    } catch (const std::runtime_error&) {
    }
    if (!rise || !start || *rise == 0) continue;
    const cln::cl_RA end = -*start / *rise;
    const bool closed = r.kind == Requirement::Kind::NotNegative;
    Range& range = domain.ranges[x];
    if (*rise > 0 && (!range.low || *range.low < end || (*range.low == end && !closed))) {
      range.low = end;
      range.has_low = closed;
    }
    if (*rise < 0 && (!range.high || *range.high > end || (*range.high == end && !closed))) {
      range.high = end;
      range.has_high = closed;
    }
  }
  return domain;
}
}  // namespace equality
