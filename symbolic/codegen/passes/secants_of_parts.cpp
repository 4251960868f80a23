// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/secants_of_parts.hpp"

#include <optional>

namespace magicmass::codegen {
namespace {

const Node& at(const Program& program, int number) {
  return program.nodes[static_cast<std::size_t>(number)];
}

bool is_one(const Node& node) {
  return node.op == Op::constant && node.numerator == 1 && node.denominator == 1;
}

// m of an angle pi/m, itself a node of the program or a whole multiple of one.
struct Part {
  int node;
  std::int64_t times = 1;
};

std::optional<Part> part_of_pi(const Program& program, int angle) {
  const Node& product = at(program, angle);
  if (product.op != Op::multiply) return std::nullopt;
  bool has_pi = false;
  std::optional<Part> part;
  std::int64_t times = 1;
  for (const int factor : product.args) {
    const Node& one = at(program, factor);
    if (one.op == Op::pi && !has_pi)
      has_pi = true;
    else if (one.op == Op::reciprocal && !part)
      part = Part{one.args[0]};
    else if (one.op == Op::constant && one.numerator == 1 && times == 1)
      times = one.denominator;
    else
      return std::nullopt;
  }
  if (!has_pi || !part) return std::nullopt;
  part->times = times;
  return part;
}

// Of the terms 1/cos(pi/m) and -1.
std::optional<Part> part_of_secant_less_one(const Program& program, const Node& sum) {
  if (sum.op != Op::add || sum.args.size() != 2) return std::nullopt;
  std::optional<Part> part;
  bool has_minus_one = false;
  for (const int term : sum.args) {
    const Node& one = at(program, term);
    if (one.op == Op::negate && is_one(at(program, one.args[0])))
      has_minus_one = true;
    else if (one.op == Op::reciprocal && at(program, one.args[0]).op == Op::cosine)
      part = part_of_pi(program, at(program, one.args[0]).args[0]);
  }
  return has_minus_one ? part : std::nullopt;
}

}  // namespace

Program secants_of_parts(const Program& program) {
  const Program marked = rebuilt(program, [](Program& result, const Node& node) {
    const std::optional<Part> part = part_of_secant_less_one(result, node);
    if (!part) return append(result, node);
    int of = part->node;
    if (part->times != 1) {
      const int times = append(result, {.op = Op::constant, .numerator = part->times});
      of = append(result, {.op = Op::multiply, .args = {times, of}});
    }
    return append(result, {.op = Op::secant_less_one, .args = {of}});
  });
  // what nothing uses any more goes
  return rebuilt(marked, [](Program& kept, const Node& node) { return append(kept, node); });
}

}  // namespace magicmass::codegen
