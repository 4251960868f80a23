// What the passes of the exercises share_nodes and drop_nodes work on.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

// One operation. `does`: 'a' alpha, 'n' n, '=' the constant `value`; '+', '-', '*', '/' of nodes
// left and right; 'r' root, 's' sine, 'c' cosine, 't' arctangent of left. What is not used is 0.
struct Node {
  char does;
  int left, right;
  double value;
};

// Node 0, node 1, ...: each uses only nodes with smaller numbers. Outputs are numbers of nodes.
struct Program {
  std::vector<Node> nodes;
  std::vector<int> outputs;
};

namespace nodes {

inline bool is_of(char does, const char* these) { return std::strchr(these, does) != nullptr; }

// From formulas with operands before their operation: "a1+" is alpha + 1. Nodes are new or shared.
inline Program written(std::initializer_list<const char*> formulas, bool is_shared) {
  Program program;
  std::vector<int> stack;
  const auto pop = [&] {
    const int last = stack.back();
    stack.pop_back();
    return last;
  };
  for (const char* formula : formulas) {
    while (const char c = *formula++) {
      Node node{c, 0, 0, 0};
      if (c >= '0' && c <= '9') node = {'=', 0, 0, double(c - '0')};
      if (is_of(c, "+-*/")) node.right = pop();
      if (is_of(c, "+-*/rsct")) node.left = pop();
      std::size_t i = is_shared ? 0 : program.nodes.size();
      const auto is_same = [&](const Node& other) {
        return other.does == node.does && other.left == node.left && other.right == node.right &&
               other.value == node.value;
      };
      while (i < program.nodes.size() && !is_same(program.nodes[i])) ++i;
      if (i == program.nodes.size()) program.nodes.push_back(node);
      stack.push_back(int(i));
    }
    program.outputs.push_back(pop());
  }
  return program;
}

// The velocities of A and B as products, in units of V, psi twice as 2 atan(sqrt(a/(2 + a))).
inline Program velocities(bool is_shared) {
  return written(
      {"212a+/*1a+*n12/+2a2a+/rt**c*n12/-2a2a+/rt**c*", "212a+/*1a+*n1+2a2a+/rt**s*n2a2a+/rt**s*"},
      is_shared);
}

[[noreturn]] inline void refuse(const char* words, int node, int other) {
  std::fprintf(stderr, words, node, other);
  std::abort();
}

// The outputs; a program that is none is refused.
inline std::vector<double> run(const Program& program, double alpha, double n) {
  std::vector<double> values;
  for (const Node& node : program.nodes) {
    const int here = int(values.size());
    const bool is_leaf = is_of(node.does, "an=");
    for (const int used : {node.left, node.right})
      if (!is_leaf && (used < 0 || used >= here))
        refuse("node %d of your program uses node %d, which is not computed before it", here, used);
    const double x = is_leaf ? 0 : values[std::size_t(node.left)];
    const double y = is_leaf ? 0 : values[std::size_t(node.right)];
    values.push_back(node.does == 'a'   ? alpha
                     : node.does == 'n' ? n
                     : node.does == '=' ? node.value
                     : node.does == '+' ? x + y
                     : node.does == '-' ? x - y
                     : node.does == '*' ? x * y
                     : node.does == '/' ? x / y
                     : node.does == 'r' ? std::sqrt(x)
                     : node.does == 's' ? std::sin(x)
                     : node.does == 'c' ? std::cos(x)
                                        : std::atan(x));
  }
  std::vector<double> outputs;
  for (const int output : program.outputs) {
    if (output < 0 || output >= int(values.size()))
      refuse("the number of nodes is %d, and node %d should be an output", int(values.size()),
             output);
    outputs.push_back(values[std::size_t(output)]);
  }
  return outputs;
}

}  // namespace nodes
