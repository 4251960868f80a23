// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/ir.hpp"

#include <map>
#include <set>
#include <utility>

namespace magicmass::codegen {
namespace {

std::string parenthesised(bool needed, const std::string& inside) {
  return needed ? "(" + inside + ")" : inside;
}

std::string rational(const Node& node) {
  const std::string above = std::to_string(node.numerator);
  return node.denominator == 1 ? above : above + "/" + std::to_string(node.denominator);
}

std::string print(const Program& program, int number, int outer, bool top);

std::string join(const Program& program, const Node& node, const char* sign, int precedence) {
  std::string result;
  for (const int argument : node.args) {
    const std::string shown = print(program, argument, precedence, false);
    const bool minus = node.op == Op::add && !result.empty() && shown.front() == '-';
    if (minus)
      result += " - " + shown.substr(1);
    else
      result += (result.empty() ? "" : sign) + shown;
  }
  return result;
}

std::string call(const Program& program, const Node& node, const char* name) {
  return std::string(name) + "(" + print(program, node.args[0], 0, false) + ")";
}

// Precedences: 0 sum, 1 product, 2 factor, 3 base of a power.
std::string print(const Program& program, int number, int outer, bool top) {
  const Node& node = program.nodes[static_cast<std::size_t>(number)];
  if (!node.name.empty() && !top && node.op != Op::ladder_low && node.op != Op::ladder_high)
    return node.name;
  switch (node.op) {
    case Op::input:
    case Op::index:
      return node.name;
    case Op::constant:
      return parenthesised(outer > 1 && (node.denominator != 1 || node.numerator < 0),
                           rational(node));
    case Op::pi:
      return "pi";
    case Op::add:
      return parenthesised(outer > 0, join(program, node, " + ", 0));
    case Op::multiply:
      return parenthesised(outer > 2, join(program, node, "*", 2));
    case Op::negate:
      return parenthesised(outer > 0, "-" + print(program, node.args[0], 1, false));
    case Op::magnitude:
      return "|" + print(program, node.args[0], 0, false) + "|";
    case Op::reciprocal:
      return parenthesised(outer > 1, "1/" + print(program, node.args[0], 3, false));
    case Op::divide:
      return parenthesised(outer > 1, print(program, node.args[0], 1, false) + "/" +
                                          print(program, node.args[1], 3, false));
    case Op::power:
      return print(program, node.args[0], 3, false) + "^" +
             parenthesised(node.denominator != 1, rational(node));
    case Op::indexed_power:
      return print(program, node.args[0], 3, false) + "^" +
             parenthesised(true, print(program, node.args[1], 0, false));
    case Op::square_root:
      return call(program, node, "sqrt");
    case Op::reciprocal_square_root:
      return parenthesised(outer > 1, "1/" + call(program, node, "sqrt"));
    case Op::sine:
      return call(program, node, "sin");
    case Op::cosine:
      return call(program, node, "cos");
    case Op::arctangent:
      return call(program, node, "atan");
    case Op::half_arcsecant:
      return parenthesised(outer > 1, "asec(1 + " + print(program, node.args[0], 0, false) + ")/2");
    case Op::secant_less_one:
      return parenthesised(outer > 0,
                           "1/cos(pi/" + print(program, node.args[0], 3, false) + ") - 1");
    case Op::ladder_low:
    case Op::ladder_high: {
      const std::int64_t offset = node.denominator + (node.op == Op::ladder_high ? 1 : 0);
      return "T(" + (node.numerator == 1 ? "" : std::to_string(node.numerator) + "*") + node.name +
             (offset == 0 ? "" : " + " + std::to_string(offset)) + ")";
    }
  }
  return {};
}

}  // namespace

int append(Program& program, Node node) {
  program.nodes.push_back(std::move(node));
  return static_cast<int>(program.nodes.size()) - 1;
}

std::vector<int> use_counts(const Program& program) {
  std::vector<int> uses(program.nodes.size(), 0);
  for (const Node& node : program.nodes)
    for (const int argument : node.args) ++uses[static_cast<std::size_t>(argument)];
  for (const Output& output : program.outputs) ++uses[static_cast<std::size_t>(output.node)];
  return uses;
}

std::string formula(const Program& program, int node) { return print(program, node, 0, true); }

Program rebuilt(const Program& program, const Rewrite& rewrite) {
  Program result;
  std::map<int, int> renumbered;
  const auto visit = [&](const auto& self, int number) -> int {
    const auto found = renumbered.find(number);
    if (found != renumbered.end()) return found->second;
    Node node = program.nodes[static_cast<std::size_t>(number)];
    for (int& argument : node.args) argument = self(self, argument);
    return renumbered[number] = rewrite(result, node);
  };
  for (const Output& output : program.outputs) {
    const int node = visit(visit, output.node);
    result.outputs.push_back({output.name, node, output.theorem});
  }
  return result;
}

OperationCounts operation_counts(const Program& program) {
  OperationCounts counts;
  std::set<int> sines;
  std::set<int> cosines;
  std::set<std::string> ladders;
  for (const Node& node : program.nodes) {
    const int further = static_cast<int>(node.args.size()) - 1;
    switch (node.op) {
      case Op::add:
        counts.additions += further;
        break;
      case Op::multiply:
        counts.multiplications += further;
        break;
      case Op::reciprocal:
      case Op::divide:
        ++counts.divisions;
        break;
      case Op::indexed_power:
        ++counts.indexed_powers;
        break;
      case Op::square_root:
      case Op::reciprocal_square_root:
        ++counts.square_roots;
        break;
      case Op::sine:
        sines.insert(node.args[0]);
        break;
      case Op::cosine:
        cosines.insert(node.args[0]);
        break;
      case Op::arctangent:
      case Op::half_arcsecant:
        ++counts.arctangents;
        break;
      case Op::secant_less_one:
        ++counts.secants;
        break;
      case Op::ladder_low:
      case Op::ladder_high:
        ladders.insert(std::to_string(node.numerator) + node.name +
                       std::to_string(node.denominator));
        break;
      default:
        break;
    }
  }
  for (const int angle : sines) counts.sine_cosine_pairs += cosines.contains(angle) ? 1 : 0;
  counts.sines_or_cosines =
      static_cast<int>(sines.size() + cosines.size()) - 2 * counts.sine_cosine_pairs;
  counts.ladders = static_cast<int>(ladders.size());
  return counts;
}

std::string to_text(const OperationCounts& counts) {
  struct Named {
    int count;
    const char* one;
    const char* several;
  };
  const Named named[] = {
      {counts.additions, "addition", "additions"},
      {counts.multiplications, "multiplication", "multiplications"},
      {counts.divisions, "division", "divisions"},
      {counts.square_roots, "square root", "square roots"},
      {counts.sine_cosine_pairs, "sine-cosine pair", "sine-cosine pairs"},
      {counts.sines_or_cosines, "sine or cosine", "sines or cosines"},
      {counts.arctangents, "arctangent", "arctangents"},
      {counts.secants, "secant less 1", "secants less 1"},
      {counts.ladders, "cosine ladder", "cosine ladders"},
      {counts.indexed_powers, "power", "powers"},
  };
  std::string result;
  for (const auto& [count, one, several] : named) {
    if (count == 0) continue;
    if (!result.empty()) result += ", ";
    result += std::to_string(count) + " " + (count == 1 ? one : several);
  }
  return result.empty() ? "none" : result;
}

}  // namespace magicmass::codegen
