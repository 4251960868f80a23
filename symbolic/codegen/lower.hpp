// From theorems to a program: what must hold of a theorem before it is taken, and how it is read;
// the maker of nodes, one for each different operation on the same operands, with its range.
#pragma once

#include <functional>
#include <tuple>

#include "codegen/program.hpp"

namespace codegen {
/// What nodes are computed in.
enum class Numbers {
  doubles,  ///< two or more to a number, with a bound of each error
  wide,     ///< MPFR's: no over- or underflow, whole numbers of any size
  plain,    ///< any real type of doubles' precision and exponents, or better, with <cmath>
  single,   ///< the same of float's
  field     ///< any field's, without error: no limits, and no function
};
class Builder {
public:
  Program program;
  const Numbers numbers;

  explicit Builder(Numbers of) : numbers(of) {}
  /// Whether each operation of a theorem is one of the number type, as it is.
  bool is_plain() const { return numbers != Numbers::doubles && numbers != Numbers::wide; }

  std::map<Expr, int> nodes;         ///< of what is known: inputs, names, terms already built
  std::map<int, int> squares;        ///< nodes, for arctangents
  std::set<std::string> recursions;  ///< pow and turn, if a theorem says that they are that
  /// Refused: a name without a definition, an operation that there is none for.
  int build(Expr e);
  Interval range(Expr e) { return program[build(e)].range; }

  int input(const std::string& name, bool is_whole, Interval range, bool may_be_zero = false);
  int constant(const cln::cl_RA& value, bool of_pi = false);
  int scaled(int x, double power_of_2);
  int sum(int x, int y);
  int product(int x, int y);
  int quotient(int x, int y);
  int unary(Op op, int x);
  int arc_tangent(int t, int square);
  int power(int x, int k);
  int turn(int k);
  /// The whole number nearest to p/q. What makes that certain joins the signs: q/2 - |p - q k| > 0.
  int nearest(int p, int q);
  /// ceil(p/q + whole), certain where |p - q k| > 0.
  int ceiling(int p, int q, const cln::cl_RA& whole);
  /// p - q k for a `nearest` k of p/q.
  int rest(int p, int q, int k);

  const Node& operator[](int k) const { return program[k]; }
  /// Makes a node's range smaller: by a theorem or a guard.
  void narrow(int k, Interval range) { program[k].range = meet(program[k].range, range); }

private:
  using Key = std::tuple<Op, std::vector<int>, double, std::string, bool>;
  std::map<Key, int> seen;
  void need_positive(const std::string& name, int k);
  int add(Node n);
  Interval range_of(const Node& n) const;

  int made(Expr e);
  int function(Expr e);
  int product(const Exprs& factors);
  int plain_product(const Exprs& factors);
  int ceiling(Expr x);
};
/// The largest angle that sine and cosine take without turning it: pi/6 and a little more.
constexpr double small_angle = 0.52359905;

/// The interval of an input in a case.
Interval range_of(const Input& input, const Case& which, bool is_wide);

/// "alpha from 0x1p-300 to 0x1p+40, N_A(alpha) from 1 to 9", and the guards; is_exact: "alpha > 0".
std::string domain_in_words(const Quantity& q, const Case& c, bool is_exact = false);
struct Output {
  std::string name;
  bool is_whole;
  bool operator==(const Output&) const = default;
};
std::vector<Output> outputs_of(const Case& c);  ///< whole ones first
/// Refused: no case, cases of different outputs.
void check_outputs(const Quantity& q);

/// A case, and the range of each term there; Refused: a term of which none is known.
struct Domain {
  const Quantity& quantity;
  const Case& which;
  bool is_wide;
  std::function<Interval(Expr)> range;
};
/// Refused: a hypothesis that does not follow from the ranges.
void check_hypotheses(const Domain& d, const Exprs& hypotheses, Expr conclusion);
/// The left side of |- name(params) = term. Refused: another form, hypotheses that do not follow.
Expr head(const Domain& d, const Theorem& t);
/// Refused, too: a parameter that is no input, unit, or one-point interval.
Expr checked_head(const Domain& d, const Theorem& t);
/// "pow" or "turn" of the theorem that says so: powers, and 1 and -1 in turn. Refused: another.
std::string name_of_recursion(const Theorem& t);
/// The formula with names at their parameters in place of units: a_n, not a_n(alpha, 1).
std::string shown(const Quantity& q, Expr formula);
/// The function template that goes to f(params, 2n) and f(params, 2n + 1) in as many steps as n has
/// bits. Refused: theorems of another shape.
std::string emit_doubling(const Doubling& t, const Domain& d);
/// Makes f(params, 2*x) and f(params, 2*x + 1) in a term known; the lines that compute both.
std::string call_doubling(const Doubling& t, Expr term, Builder& terms);
// The passes.
/// Without what no output, sign or guard needs.
Program without_dead_code(const Program& p);
/// In at most three stages, for arrays: what takes the result of a function is in the next one.
Program in_stages(const Program& p);
/// Each node named, no two alike, none like a word of the emitted text: -x of x, where x is named.
Program named(const Program& p);
/// The case's program after all passes; outputs of plain forms are entries where they are matrices.
/// Refused: a theorem with a hypothesis that does not follow from the intervals, a name without a
/// definition, an operation that there is none for, a divisor or root whose range is not known, a
/// value that may over- or underflow, a function of a field's numbers; quantity and case are named.
Program lower(const Quantity& quantity, const Case& which, Numbers numbers);
}  // namespace codegen
