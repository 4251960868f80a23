// SPDX-License-Identifier: GPL-2.0-or-later
// The intermediate representation: operations in single assignment, in the order of their making.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "codegen/exact.hpp"

namespace codegen {
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
  bool of_pi = false;
  bool is_exact = false;
  bool is_whole = false;
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
};
/// A name as C++ has it: c' is c_prime.
std::string identifier(const std::string& name);

/// Without what no output, sign or guard needs.
Program without_dead_code(const Program& p);
/// In at most three stages, for arrays: what takes the result of a function is in the next one.
Program in_stages(const Program& p);
/// Each node named, no two alike, none like a word of the emitted text: -x of x, where x is named.
Program named(const Program& p);
}  // namespace codegen
