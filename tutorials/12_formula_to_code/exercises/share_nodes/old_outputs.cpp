// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>
#include <tuple>
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

// The same program with each value computed once: nodes that do the same with
// the same arguments become one.
Program share(const Program& before) {
  Program after;
  std::map<std::tuple<Operation, std::vector<int>, double>, int> known;
  std::vector<int> number(before.nodes.size());  // of each old node, in the new
  for (std::size_t i = 0; i < before.nodes.size(); ++i) {
    Node node = before.nodes[i];
    for (int& argument : node.arguments) argument = number[argument];
    const std::tuple what{node.operation, node.arguments, node.value};
    if (!known.contains(what)) {
      known[what] = static_cast<int>(after.nodes.size());
      after.nodes.push_back(node);
    }
    number[i] = known[what];
  }
  const int last = static_cast<int>(after.nodes.size()) - 1;
  after.outputs = {last, last};
  return after;
}
