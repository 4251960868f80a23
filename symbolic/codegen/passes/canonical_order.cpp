// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/canonical_order.hpp"

#include <algorithm>
#include <string>
#include <tuple>

namespace magicmass::codegen {
namespace {

int rank(const Node& node) {
  switch (node.op) {
    case Op::constant:
      return 0;
    case Op::pi:
      return 1;
    case Op::input:
    case Op::index:
      return 2;
    case Op::add:
      return node.name.empty() ? 3 : 2;
    case Op::negate:
      return 9;
    default:
      return node.name.empty() ? 4 : 2;
  }
}

}  // namespace

Program canonical_order(const Program& program) {
  const Program sorted = rebuilt(program, [](Program& result, Node node) {
    if (node.op == Op::add || node.op == Op::multiply)
      std::sort(node.args.begin(), node.args.end(), [&result](int x, int y) {
        const auto key = [&result](int number) {
          return std::tuple(rank(result.nodes[static_cast<std::size_t>(number)]),
                            formula(result, number));
        };
        return key(x) < key(y);
      });
    return append(result, node);
  });
  // once more, for nodes to be numbered in the order of the sorted arguments
  return rebuilt(sorted, [](Program& result, const Node& node) { return append(result, node); });
}

}  // namespace magicmass::codegen
