// SPDX-License-Identifier: GPL-2.0-or-later
// What the generator takes: quantities made of theorems, and of intervals that are data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "codegen/exact.hpp"
#include "kernel/theorem.hpp"

namespace codegen {
/// An argument of a quantity: a variable of the kernel (whole if its sort is Int), and where the
/// evaluators answer: in doubles, and in MPFR's numbers. Both are emitted as guards at run time.
struct Input {
  kernel::Expr variable;
  Interval range;
  Interval wide_range;
  bool may_be_zero = false;  ///< too, exactly: an evaluator's only
  bool is_whole() const { return variable.sort() == kernel::Sort::Int; }
  std::string name() const;  ///< as C++ has it
};
/// A closed interval of an input, or of a named node, that is tested at run time.
struct Condition {
  std::string name;
  Interval range;
  std::optional<Interval> wide_range = {};  ///< in MPFR's numbers, where it is another
  Interval of(bool is_wide) const { return is_wide ? wide_range.value_or(range) : range; }
};
/// `p <= q` about named nodes or numbers, or `p^2 = q` for the square that an arctangent needs: by
/// a theorem, or by an argument that is printed with the evaluator.
struct Fact {
  kernel::Exprs hypotheses;
  kernel::Expr formula;
  std::string argument = "a theorem";
  /// Why it holds of computed values, within 2^-22, where their error bounds do not show it.
  std::string of_computed;
  Fact(const kernel::Theorem& t) : hypotheses(t.hypotheses()), formula(t.conclusion()) {}
  Fact(kernel::Expr f, const std::string& why) : formula(f), argument(why) {}
};
/// One formula for a part of a quantity's domain. A theorem is taken only if each of its hypotheses
/// follows from the intervals: of the quantity, met with those of `where`.
struct Case {
  std::string name;
  std::vector<Condition> where;
  /// `name(params) = term`, in order; they name the nodes.
  kernel::Theorems definitions;
  /// `output(params) = term`; an input with a one-point interval may stand as that number.
  kernel::Theorems outputs;
  std::vector<Fact> facts;
  /// Named nodes that must be within their open intervals; else the row is left in doubt.
  std::vector<Condition> guards;
  /// Named nodes that must be above 2^23 times the bound of their errors; else as above. They
  /// are the divisors without a relative bound.
  std::vector<std::string> divisors = {};
};
/// |- f(params, 0) = .., f(params, 1) = .., f(params, 2*m) by f(params, m), and f(params, 2*m + 1)
/// by f(params, m), f(params, m + 1) and f(params, 1), for every integer m.
struct Doubling {
  kernel::Theorem at_0, at_1, even, odd;
};
struct Quantity {
  std::string name;
  std::string labels;  ///< of the paper's equations
  std::vector<Input> inputs;
  std::vector<Case> cases;          ///< disjoint
  kernel::Substitution units = {};  ///< parameters that are no inputs, and their value: V is 1
  std::optional<Doubling> doubling = {};  ///< of exact forms: a sequence at 2*x and 2*x + 1
  bool has_arrays = false;                ///< the first case is evaluated a register at a time, too
  bool is_tested = true;                  ///< whether tiers that test roundings test its own
};
}  // namespace codegen
