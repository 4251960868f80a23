// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/common_subexpressions.hpp"

#include <map>
#include <tuple>

namespace magicmass::codegen {
namespace {

using Key = std::tuple<Op, std::vector<int>, std::int64_t, std::int64_t, std::string>;

bool has_constant_and_more(const Program& program, const Node& node) {
  return node.op == Op::multiply && node.args.size() > 2 &&
         program.nodes[static_cast<std::size_t>(node.args[0])].op == Op::constant;
}

// c * x * y becomes c * (x * y).
Program constants_apart(const Program& program) {
  return rebuilt(program, [](Program& result, const Node& node) {
    if (!has_constant_and_more(result, node)) return append(result, node);
    const int rest =
        append(result, {.op = Op::multiply, .args = {node.args.begin() + 1, node.args.end()}});
    Node scaled = node;
    scaled.args = {node.args[0], rest};
    return append(result, scaled);
  });
}

// c * (x * y) becomes c * x * y again where the product in parentheses has no other use.
Program constants_back(const Program& program) {
  const std::vector<int> uses = use_counts(program);
  Program result = program;
  for (Node& node : result.nodes) {
    if (node.op != Op::multiply || node.args.size() != 2) continue;
    const Node& first = result.nodes[static_cast<std::size_t>(node.args[0])];
    const Node& second = result.nodes[static_cast<std::size_t>(node.args[1])];
    if (first.op != Op::constant || second.op != Op::multiply || !second.name.empty() ||
        uses[static_cast<std::size_t>(node.args[1])] != 1)
      continue;
    std::vector<int> args{node.args[0]};
    args.insert(args.end(), second.args.begin(), second.args.end());
    node.args = args;
  }
  return rebuilt(result, [](Program& kept, const Node& node) { return append(kept, node); });
}

}  // namespace

Program without_repetitions(const Program& program) {
  std::map<Key, int> known;
  return rebuilt(program, [&known](Program& result, const Node& node) {
    const bool named_by_kind = node.op == Op::input || node.op == Op::index ||
                               node.op == Op::ladder_low || node.op == Op::ladder_high;
    const Key key{node.op, node.args, node.numerator, node.denominator,
                  named_by_kind ? node.name : std::string()};
    const auto found = known.find(key);
    if (found == known.end()) return known[key] = append(result, node);
    Node& same = result.nodes[static_cast<std::size_t>(found->second)];
    if (same.name.empty()) {
      same.name = node.name;
      same.origin = node.origin;
    }
    return found->second;
  });
}

Program common_subexpressions(const Program& program) {
  return constants_back(without_repetitions(constants_apart(program)));
}

}  // namespace magicmass::codegen
