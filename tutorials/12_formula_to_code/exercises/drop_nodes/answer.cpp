// SPDX-License-Identifier: GPL-2.0-or-later
#include <vector>

// What a node computes. A constant has its value, a power its exponent.
enum class Operation {
  alpha,
  n,
  constant,
  sum,
  product,
  negative,
  reciprocal,
  power,
  sine,
  cosine,
  arctangent
};

// One operation. Its arguments are nodes with smaller numbers.
struct Node {
  Operation operation;
  std::vector<int> arguments;
  double value;
};

// Node 0, node 1, ...; the outputs are the numbers of two of them: the velocities of A and of B.
struct Program {
  std::vector<Node> nodes;
  std::vector<int> outputs;
};

// The same program without what output number `wanted` does not need; that one
// is then the only output.
Program drop(const Program& before, int wanted) {
  return {before.nodes, {before.outputs[wanted]}};  // change this
}
