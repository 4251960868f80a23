// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace magicmass::codegen {

// What a node computes from its arguments.
enum class Op {
  input,     // name: a real (or field) argument
  index,     // name: an integer argument as a number
  constant,  // numerator / denominator
  pi,
  add,       // n-ary
  multiply,  // n-ary
  negate,
  magnitude,
  reciprocal,
  divide,  // made by shared_reciprocals
  power,   // args[0] ^ (numerator / denominator), denominator 1 or 2; removed by strength_reduction
  indexed_power,  // args[0] ^ args[1], the exponent a sum with an index in it
  square_root,
  reciprocal_square_root,  // made by reciprocal_square_roots
  sine,
  cosine,
  arctangent,
  half_arcsecant,   // asec(1 + args[0])/2 = atan(args[1]), made by half_arcsecants
  secant_less_one,  // 1/cos(pi/args[0]) - 1, made by secants_of_parts
  ladder_low,  // T(m) and T(m + 1) of args[0] = cos(psi/2), with m = numerator * name + denominator
  ladder_high,
};

struct Node {
  Op op;
  std::vector<int> args = {};
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  std::string name =
      {};  // of an input; of the paper's symbol that this node is the value of ("psi")
  std::string origin = {};  // the theorem that says so
};

struct Output {
  std::string name;
  int node;
  std::string theorem;
};

// A straight-line program in static single assignment form: an argument's number is less than its user's.
struct Program {
  std::vector<Node> nodes;
  std::vector<Output> outputs;
};

// Appends, sharing nothing: passes decide what is shared.
int append(Program& program, Node node);

// How often each node is used, outputs included.
std::vector<int> use_counts(const Program& program);

// The mathematics of a node in infix notation, down to the inputs and the named values: an order key and,
// in the generated code, the comment beside a temporary.
std::string formula(const Program& program, int node);

// A program rebuilt from its outputs: `rewrite` gets each reachable node with its arguments renumbered and
// appends its replacement.
using Rewrite = std::function<int(Program& result, const Node& node)>;
Program rebuilt(const Program& program, const Rewrite& rewrite);

struct OperationCounts {
  int additions = 0, multiplications = 0, divisions = 0, square_roots = 0;
  int sine_cosine_pairs = 0, sines_or_cosines = 0, arctangents = 0, ladders = 0;
  int secants = 0;
  int indexed_powers = 0;
};
OperationCounts operation_counts(const Program& program);
std::string to_text(const OperationCounts& counts);  // "3 additions, 5 multiplications, ..."

}  // namespace magicmass::codegen
