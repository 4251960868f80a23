// The intermediate representation: operations in single assignment, in the order of their making.
#pragma once

#include <algorithm>

#include "codegen/exact.hpp"
#include "kernel/theorem.hpp"

namespace codegen {
using kernel::Expr, kernel::Exprs, kernel::Theorem, kernel::Theorems;
/// "Exact" nodes are plain numbers without error; all others are of the number type.
enum class Op {
  input,            ///< exact
  constant,         ///< exact where it is a double, else in two parts
  exact_sum,        ///< of two exact numbers
  whole_sum,        ///< of two exact whole numbers: exact
  sum,              ///< of two numbers of one sign
  cancelling_sum,   ///< of any two
  product,          ///< of two numbers
  exact_product,    ///< of a number by an exact one
  scale,            ///< by a power of two: exact where its operand is
  quotient,         ///<
  reciprocal_root,  ///<
  root,             ///< plain forms' alone
  ceiling,          ///< plain forms' alone
  arc_tangent,      ///< of t, with t^2 where that is needed
  sine,             ///<
  cosine,           ///<
  size,             ///< |x|
  nearest,          ///< the whole number nearest to x/y: exact; its test is among the signs
  power,            ///< x^k, x from 0 to 1, k an exact whole number; 2^-200 in place of less
  turn,             ///< 1 for an even whole number, -1 for an odd one: exact
  step              ///< k, or k - 1 where the rest is negative: exact
};
struct Node {
  Op op;
  std::vector<int> of = {};  ///< operands, all before this one
  double factor = 1;         ///< of scale
  cln::cl_RA value = 0;      ///< of a constant, in units of pi where `of_pi`
  bool of_pi = false, is_exact = false, is_whole = false;
  std::string name = {};
  std::string formula = {};  ///< as the theorem has it
  Interval range = {0, 0};
  double least = 0;  ///< |x| is 0 or at least that; 0 where nothing is known
  int stage = 1;
  cln::cl_RA number() const { return of_pi ? value * pi() : value; }
};
/// What a program is for.
struct Result {
  enum Kind {
    whole,
    real,
    sign,    ///< positive, or the row is left in doubt
    guard,   ///< within its open range, or the row is left in doubt
    divisor  ///< above 2^23 times its error, or the row is left in doubt
  } kind;
  std::string name;
  int node;
};
/// |small| <= |large|, by a theorem; of computed values, too, unless that is still to be checked.
struct SizeFact {
  int small, large;
  bool is_of_computed;
};
struct Program {
  std::string doubling, calls;  ///< C++ of a doubling: before all, and of the lines that come first
  std::vector<Node> nodes;
  std::vector<Result> results;  ///< kind by kind
  std::vector<SizeFact> facts;

  const Node& operator[](int k) const { return nodes[std::size_t(k)]; }
  Node& operator[](int k) { return nodes[std::size_t(k)]; }
  int size() const { return int(nodes.size()); }
  bool has(Result::Kind kind, int node) const {
    const auto is_it = [&](const Result& r) { return r.kind == kind && r.node == node; };
    return std::ranges::any_of(results, is_it);
  }
};
/// A name as C++ has it: c' is c_prime.
std::string identifier(const std::string& name);

// What the generator takes: quantities made of theorems, and of intervals that are data.
/// An argument of a quantity: a variable of the kernel (whole if its sort is Int), and where the
/// evaluators answer: in doubles, and in MPFR's numbers. Both are emitted as guards at run time.
struct Input {
  Expr variable;
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
  Exprs hypotheses;
  Expr formula;
  std::string argument = "by theorem";
  /// Why it holds of computed values, within 2^-22, where their error bounds do not show it.
  std::string of_computed;
  Fact(const Theorem& t) : hypotheses(t.hypotheses()), formula(t.conclusion()) {}
  Fact(Expr f, const std::string& why) : formula(f), argument(why) {}
};
/// One formula for a part of a quantity's domain. A theorem is taken only if each of its hypotheses
/// follows from the intervals: of the quantity, met with those of `where`.
struct Case {
  std::string name;
  std::vector<Condition> where = {};
  /// `name(params) = term`, in order; they name the nodes.
  Theorems definitions = {};
  /// `output(params) = term`; an input with a one-point interval may stand as that number.
  Theorems outputs = {};
  std::vector<Fact> facts = {};
  /// Named nodes that must be within their open intervals; else the row is left in doubt.
  std::vector<Condition> guards = {};
  /// Named nodes that must be above 2^23 times the bound of their errors; else as above. They
  /// are the divisors without a relative bound.
  std::vector<std::string> divisors = {};
};
/// |- f(params, 0) = .., f(params, 1) = .., f(params, 2*m) by f(params, m), and f(params, 2*m + 1)
/// by f(params, m), f(params, m + 1) and f(params, 1), for every integer m.
struct Doubling {
  Theorem at_0, at_1, even, odd;
};
struct Quantity {
  std::string name;
  std::string labels;  ///< of the paper's equations
  std::vector<Input> inputs;
  std::vector<Case> cases;          ///< disjoint
  kernel::Substitution units = {};  ///< parameters that are no inputs, and their value: V is 1
  std::optional<Doubling> doubling = {};  ///< of exact forms: a sequence at 2*x and 2*x + 1
  Theorems recursions = {};               ///< what pow and turn are, where these are used
  bool has_arrays = false;                ///< the first case is evaluated a register at a time, too
  bool is_tested = true;                  ///< whether tiers that test roundings test its own
};
}  // namespace codegen
