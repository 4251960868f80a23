// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <ginac/ginac.h>

#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using GiNaC::subs_options;

namespace {

struct Grid {
  numeric numerators = 1;  // least common multiples over all affine pieces
  numeric denominators = 1;
};

// Sums, rational multiples and step functions of the variable: nothing else.
bool collect(const ex& e, const ex& variable, Grid& grid) {
  if (is_a<numeric>(e)) {
    const numeric value = ex_to<numeric>(e);
    if (!value.is_rational()) return false;
    grid.denominators = GiNaC::lcm(grid.denominators, value.denom());
    if (!value.is_zero()) grid.numerators = GiNaC::lcm(grid.numerators, GiNaC::abs(value.numer()));
    return true;
  }
  if (e.is_equal(variable)) return true;
  if (is_step_function(e)) return collect(e.op(0), variable, grid);
  if (is_a<GiNaC::mul>(e))
    return e.nops() == 2 && (is_a<numeric>(e.op(0)) || is_a<numeric>(e.op(1))) &&
           collect(e.op(0), variable, grid) && collect(e.op(1), variable, grid);
  if (is_a<GiNaC::add>(e))
    return std::all_of(e.begin(), e.end(),
                       [&](const ex& term) { return collect(term, variable, grid); });
  return false;
}

// sawtooth(u) = u - floor(u): then every step function is an integer and coefficients of the variable add up.
ex without_sawtooth(const ex& e) {
  if (is_step_function(e)) {
    const ex inside = without_sawtooth(e.op(0)).expand();
    if (function_name(e) == "sawtooth") return inside - floor(inside);
    return function_name(e) == "ceil" ? ceiling(inside) : floor(inside);
  }
  if (!is_a<GiNaC::add>(e) && !is_a<GiNaC::mul>(e)) return e;
  ex result = is_a<GiNaC::add>(e) ? 0 : 1;
  for (const ex& part : e)
    result =
        is_a<GiNaC::add>(e) ? result + without_sawtooth(part) : result * without_sawtooth(part);
  return result.expand();
}

int depth(const ex& e) {
  int deepest = 0;
  for (const ex& part : e) deepest = std::max(deepest, depth(part));
  return deepest + (is_step_function(e) ? 1 : 0);
}

bool holds(const Statement& statement, const ex& variable, const numeric& value) {
  const numeric difference = ex_to<numeric>(
      (statement.lhs() - statement.rhs()).subs(variable == value, subs_options::no_pattern));
  return statement.relation() == Relation::greater ? difference > 0 : difference <= 0;
}

}  // namespace

// With N and D the least common multiples of all numerators and denominators: a jump of a step function
// of p X + q is at X = (m - q)/p, and of one that holds others, r X + s (integer) + q, likewise, so all
// lie on the grid of step 1/(N D). Between its points both sides are affine. Shifting X by D^depth shifts
// the innermost arguments by integers that D^(depth - 1) divides, and so on outwards: both sides change by
// constants. So they are equal everywhere if they are on the grid, at two points inside each cell of one
// period, and once more over a second period.
Theorem Kernel::step_functions(const Claim& claim, const std::vector<Theorem>& equations,
                               const ex& variable, const std::vector<Statement>& where) {
  const std::string rule = "step functions, piece by piece";
  Evidence evidence;
  ex left = claim.statement.lhs();
  ex right = claim.statement.rhs();
  for (const Theorem& equation : equations) {
    left = applied(equation, left, claim, rule, evidence);
    right = applied(equation, right, claim, rule, evidence);
  }
  // The variable is pi/psi, or an integer of the claim.
  const ex x = GiNaC::realsymbol("X");
  const bool integer = claim.indices.contains(to_text(variable));
  const auto in_variable = [&](const ex& e) {
    const ex written_out = definitions_.expand_except_angles(e);
    require(!written_out.has(x), claim, rule, "X is taken");
    if (!integer && !variable.is_equal(GiNaC::Pi / symbol("psi")))
      return without_sawtooth(written_out.subs(variable == x, subs_options::no_pattern));
    return without_sawtooth(
        integer ? written_out.subs(variable == x, subs_options::no_pattern)
                : written_out.subs(symbol("psi") == GiNaC::Pi / x, subs_options::no_pattern)
                      .subs(variable == x, subs_options::no_pattern));
  };
  left = in_variable(left);
  right = in_variable(right);
  std::vector<Statement> cases;
  for (const Statement& condition : where) {
    require(
        condition.relation() == Relation::greater || condition.relation() == Relation::less_equal,
        claim, rule, "a case must read <= or >");
    cases.emplace_back(in_variable(condition.lhs() - condition.rhs()), condition.relation(), 0);
    evidence.conditions.insert(proof::condition(condition));
  }
  Grid grid;
  require(collect(left.expand(), x, grid) && collect(right.expand(), x, grid), claim, rule,
          to_text(left) + " or " + to_text(right) +
              " is not built from step functions of affine arguments");
  for (const Statement& condition : cases)
    require(collect(condition.lhs(), x, grid) && collect(condition.rhs(), x, grid), claim, rule,
            "the case is not built from step functions");

  int deepest = std::max(depth(left), depth(right));
  for (const Statement& condition : cases) deepest = std::max(deepest, depth(condition.lhs()));
  const numeric period = grid.denominators.power(deepest);
  const numeric cells = integer ? numeric(1) : grid.numerators * grid.denominators;
  require(period * cells <= 20000, claim, rule, "too many pieces");
  for (const Statement& condition : cases)
    require(condition.lhs()
                .subs(x == 0, subs_options::no_pattern)
                .is_equal(condition.lhs().subs(x == period, subs_options::no_pattern)),
            claim, rule, "the case " + to_text(condition) + " is not periodic");
  bool reached = false;
  for (numeric i = 0; i <= 2 * period * cells; i += 1)
    for (const numeric& inside : {numeric(0), numeric(1, 3), numeric(2, 3)}) {
      if (integer && !inside.is_zero()) continue;
      const numeric value =
          (i + inside) / cells + (integer ? claim.indices.at(to_text(variable)) : 0);
      if (!std::all_of(cases.begin(), cases.end(),
                       [&](const Statement& s) { return holds(s, x, value); }))
        continue;
      reached = true;
      const ex l = left.subs(x == value, subs_options::no_pattern);
      const ex r = right.subs(x == value, subs_options::no_pattern);
      require(l.is_equal(r), claim, rule,
              "at " + to_text(variable) + " = " + to_text(value) + " the left side is " +
                  to_text(l) + " and the right side is " + to_text(r));
    }
  require(reached, claim, rule, "the cases exclude every point");
  if (integer)
    evidence.conditions.insert(
        index_condition(to_text(variable), claim.indices.at(to_text(variable))));
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
