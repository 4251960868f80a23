// SPDX-License-Identifier: GPL-2.0-or-later
// Makes nodes, one for each different operation on the same operands, with its range; from the
// kernel's terms.
#pragma once

#include <map>
#include <tuple>

#include "codegen/program.hpp"
#include "codegen/quantity.hpp"

namespace codegen {
/// What nodes are computed in.
enum class Numbers {
  doubles,  ///< two or more to a number, with a bound of each error
  wide,     ///< MPFR's: no over- or underflow, whole numbers of any size
  plain,    ///< any real type of doubles' precision and exponents, or better, with <cmath>
  field     ///< any field's, without error: no limits, and no function
};
class Builder {
public:
  Program program;
  const Numbers numbers;

  explicit Builder(Numbers of) : numbers(of) {}
  /// Whether each operation of a theorem is one of the number type, as it is.
  bool is_plain() const { return numbers == Numbers::plain || numbers == Numbers::field; }

  std::map<kernel::Expr, int> nodes;  ///< of what is known: inputs, names, terms already built
  std::map<int, int> squares;         ///< nodes, for arctangents
  /// Refused: a name without a definition, an operation that there is none for.
  int build(kernel::Expr e);
  Interval range(kernel::Expr e) { return program[build(e)].range; }

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
  /// The whole number nearest to p/q. What must be certain for that is added to the signs:
  /// q/2 - |p - q k| > 0.
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

  int made(kernel::Expr e);
  int function(kernel::Expr e);
  int product(const kernel::Exprs& factors);
  int plain_product(const kernel::Exprs& factors);
  int ceiling(kernel::Expr x);
};
/// The largest angle that sine and cosine take without turning it: pi/6 and a little more.
constexpr double small_angle = 0.52359905;
}  // namespace codegen
