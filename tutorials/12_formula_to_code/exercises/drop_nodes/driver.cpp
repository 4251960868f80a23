// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

#include <cmath>
#include <cstdlib>
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

Program drop(const Program& before, int wanted);

#include "program_before.hpp"

namespace {

void require(bool is_good, const char* words, int node, int other) {
  if (is_good) return;
  std::fprintf(stderr, words, node, other);
  std::fflush(stderr);
  std::abort();
}

// What every program must be: arguments come first, and as many as the operation takes.
void check(const Program& program) {
  int number = 0;
  for (const Node& node : program.nodes) {
    const int count = static_cast<int>(node.arguments.size());
    const bool has_none = node.operation <= Operation::constant;
    const bool has_many = node.operation == Operation::sum || node.operation == Operation::product;
    require(has_none ? count == 0 : has_many ? count > 1 : count == 1,
            "node %d of your program has %d arguments, which its operation does not take\n", number,
            count);
    for (int argument : node.arguments)
      require(argument >= 0 && argument < number,
              "node %d of your program uses node %d, which is not computed before it\n", number,
              argument);
    ++number;
  }
  for (int output : program.outputs)
    require(output >= 0 && output < number,
            "your program has %d nodes, and node %d is to be an output\n", number, output);
}

double computed(const Node& node, const std::vector<double>& values, double alpha, long n) {
  const double first = node.arguments.empty() ? 0 : values[node.arguments[0]];
  double result = node.operation == Operation::product ? 1 : 0;
  switch (node.operation) {
    case Operation::alpha:
      return alpha;
    case Operation::n:
      return static_cast<double>(n);
    case Operation::constant:
      return node.value;
    case Operation::sum:
      for (int argument : node.arguments) result += values[argument];
      return result;
    case Operation::product:
      for (int argument : node.arguments) result *= values[argument];
      return result;
    case Operation::negative:
      return -first;
    case Operation::reciprocal:
      return 1 / first;
    case Operation::power:
      return std::pow(first, node.value);
    case Operation::sine:
      return std::sin(first);
    case Operation::cosine:
      return std::cos(first);
    case Operation::arctangent:
      return std::atan(first);
  }
  return result;
}

std::vector<double> outputs_of(const Program& program, double alpha, long n) {
  std::vector<double> values;
  for (const Node& node : program.nodes) values.push_back(computed(node, values, alpha, n));
  std::vector<double> outputs;
  for (int output : program.outputs) outputs.push_back(values[output]);
  return outputs;
}

}  // namespace

int main() {
  return exercise::run_cases([](exercise::Case& one) {
    const double alpha = one.number();
    const Program after = drop(program_before(), 1);
    check(after);
    const int outputs = static_cast<int>(after.outputs.size());
    require(outputs == 1, "your program has %d outputs, %d asked for\n", outputs, 1);
    for (double output : outputs_of(after, alpha, one.whole())) one.give(output);
    one.give(static_cast<double>(after.nodes.size()));
  });
}
