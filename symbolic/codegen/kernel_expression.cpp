// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/kernel_expression.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace magicmass::codegen {
namespace {

bool is_power_of_two(const Node& node) {
  const auto whole = [](std::int64_t k) { return k > 0 && (k & (k - 1)) == 0; };
  return node.op == Op::constant && whole(node.numerator) && whole(node.denominator);
}

std::string real(const Node& constant) {
  if (constant.denominator == 1) return fmt::format("Real({}.0)", constant.numerator);
  if ((constant.denominator & (constant.denominator - 1)) != 0)
    throw std::logic_error("a kernel's constants are exact doubles");
  return fmt::format("Real({})", static_cast<double>(constant.numerator) /
                                     static_cast<double>(constant.denominator));
}

std::string plain_name(const Node& node) {
  std::string name;
  for (const char character : node.name)
    if (character != ')') name += character == '(' ? '_' : character;
  return name;
}

}  // namespace

KernelPrinter::KernelPrinter(const Program& program, const Stages& stages,
                             const std::vector<std::string>& number_inputs)
    : program_(program), number_inputs_(number_inputs), names_(program.nodes.size()) {
  std::vector<int> uses = use_counts(program);
  for (std::size_t i = program.nodes.size(); i-- > 0;)  // a minus sign goes where it is used
    if (program.nodes[i].op == Op::negate)
      uses[static_cast<std::size_t>(program.nodes[i].args[0])] += uses[i] - 1;
  std::vector<bool> crosses(program.nodes.size(), false);
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    for (const int argument : program.nodes[i].args)
      if (stages.stage[i] != stages.stage[static_cast<std::size_t>(argument)])
        crosses[static_cast<std::size_t>(argument)] = true;
  std::map<std::string, int> numbered;
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const Node& made = program.nodes[i];
    if (made.op == Op::input || is_exact(static_cast<int>(i)) || made.op == Op::negate ||
        is_of_pi(static_cast<int>(i)) || is_divisor(static_cast<int>(i)))
      continue;
    if (uses[i] < 2 && !crosses[i] && !ends_a_stage(made)) continue;
    static const std::map<Op, std::string> kinds{{Op::sine, "sine"},
                                                 {Op::cosine, "cosine"},
                                                 {Op::add, "sum"},
                                                 {Op::multiply, "product"},
                                                 {Op::arctangent, "angle"},
                                                 {Op::half_arcsecant, "angle"},
                                                 {Op::reciprocal_square_root, "root"},
                                                 {Op::secant_less_one, "secant"}};
    const auto kind = kinds.find(made.op);
    const std::string base = !made.name.empty()    ? plain_name(made)
                             : kind == kinds.end() ? "value"
                                                   : kind->second;
    const int count = ++numbered[base];
    names_[i] = count == 1 ? base : base + "_" + std::to_string(count);
  }
}

const Node& KernelPrinter::node(int number) const {
  return program_.nodes[static_cast<std::size_t>(number)];
}
bool KernelPrinter::is_kept(int number) const {
  return !names_[static_cast<std::size_t>(number)].empty();
}
std::string KernelPrinter::name(int number) const {
  return names_[static_cast<std::size_t>(number)];
}
void KernelPrinter::rename(int number, const std::string& name) {
  names_[static_cast<std::size_t>(number)] = name;
}
bool KernelPrinter::is_number_input(int number) const {
  const Node& made = node(number);
  return made.op == Op::input &&
         std::find(number_inputs_.begin(), number_inputs_.end(), made.name) != number_inputs_.end();
}
// A power of two times it, too.
bool KernelPrinter::is_of_pi(int number) const {
  const Node& made = node(number);
  if (made.op == Op::multiply)
    return made.args.size() == 2 && is_power_of_two(node(made.args[0])) && is_of_pi(made.args[1]);
  return made.op == Op::pi;
}
// Of an exact number; a product is divided by it.
bool KernelPrinter::is_divisor(int number) const {
  return node(number).op == Op::reciprocal && is_exact(node(number).args[0]);
}
// Also a power of two times an input.
bool KernelPrinter::is_exact(int number) const {
  const Node& made = node(number);
  if (made.op == Op::multiply)
    return made.args.size() == 2 && is_power_of_two(node(made.args[0])) &&
           (node(made.args[1]).op == Op::input || node(made.args[1]).op == Op::index) &&
           !is_number_input(made.args[1]);
  if (is_number_input(number)) return false;
  return made.op == Op::input || made.op == Op::index || made.op == Op::constant;
}
std::string KernelPrinter::exact(int number) const {
  const Node& made = node(number);
  if (made.op == Op::multiply) return exact(made.args[0]) + " * " + exact(made.args[1]);
  return made.op == Op::constant ? real(made) : made.name;
}

std::string KernelPrinter::value(int number) const {
  return is_kept(number) ? name(number) : right_side(number);
}

std::string KernelPrinter::factor(int number) const {
  const Op op = node(number).op;
  const bool bare = is_kept(number) || (op != Op::add && op != Op::negate);
  return bare ? value(number) : "(" + value(number) + ")";
}

std::string KernelPrinter::sum(const Node& made) const {
  std::string text;
  std::vector<int> exacts;
  const auto add = [&](int number) {
    const bool minus = node(number).op == Op::negate;
    const std::string term = minus ? factor(node(number).args[0]) : value(number);
    if (text.empty())
      text = minus ? "-" + term : term;
    else
      text += (minus ? " - " : " + ") + term;
  };
  for (const int argument : made.args) {
    const int of = node(argument).op == Op::negate ? node(argument).args[0] : argument;
    if (is_exact(of))
      exacts.push_back(argument);
    else if (node(argument).op != Op::negate)
      add(argument);
  }
  for (const int argument : made.args)
    if (node(argument).op == Op::negate && !is_exact(node(argument).args[0])) add(argument);
  // 1 - x, of which nothing is negated
  if (are_doubles_first_ && made.args.size() == 2 && exacts.size() == 1 && text.starts_with('-') &&
      node(exacts[0]).op != Op::negate)
    return exact(exacts[0]) + " - " + text.substr(1);
  const auto exact_term = [&](int number) {
    return node(number).op == Op::negate ? "-" + exact(node(number).args[0]) : exact(number);
  };
  std::size_t next = 0;
  if (text.empty() && exacts.size() > 1) {
    text = "Number::sum(" + exact_term(exacts[0]) + ", " + exact_term(exacts[1]) + ")";
    next = 2;
  }
  for (; next < exacts.size(); ++next) text += " + " + exact_term(exacts[next]);
  return text;
}

std::string KernelPrinter::product(const Node& made) const {
  const bool is_square = made.args.size() == 2 && made.args[0] == made.args[1];
  if (are_doubles_first_ && is_square && !is_exact(made.args[0]))
    return "squared(" + value(made.args[0]) + ")";
  std::string text, others, divisor;
  std::vector<std::string> exacts;
  std::string scale;
  for (const int argument : made.args) {
    if (is_power_of_two(node(argument)))
      scale = real(node(argument));
    else if (is_divisor(argument))
      divisor = " / " + exact(node(argument).args[0]);
    else if (is_exact(argument))
      exacts.push_back(exact(argument));
    else if (text.empty())
      text = factor(argument);
    else
      others += " * " + factor(argument);
  }
  if (!are_doubles_first_) text += std::exchange(others, "");
  if (!scale.empty() && !exacts.empty()) {  // a power of two times a double is exact
    exacts[0] = "(" + scale + " * " + exacts[0] + ")";
    scale.clear();
  }
  std::size_t next = 0;
  if (text.empty() && exacts.size() > 1) {
    text = "Number::product(" + exacts[0] + ", " + exacts[1] + ")";
    next = 2;
  }
  for (; next < exacts.size(); ++next) text += " * " + exacts[next];
  text += others + divisor;
  if (scale.empty()) return text;
  return "scaled(" + text + ", " + scale.substr(5, scale.size() - 6) + ")";  // Real(2.0) -> 2.0
}

std::optional<std::string> KernelPrinter::as_product(int number) const {
  const bool is_negative = node(number).op == Op::negate;
  const int of = is_negative ? node(number).args[0] : number;
  const Node& made = node(of);
  if (made.op != Op::multiply || is_kept(of) || is_exact(of)) return std::nullopt;
  double scale = is_negative ? -1.0 : 1.0;
  std::vector<int> factors, exacts;
  for (const int argument : made.args) {
    if (is_power_of_two(node(argument)))
      scale *= static_cast<double>(node(argument).numerator) /
               static_cast<double>(node(argument).denominator);
    else
      (is_exact(argument) ? exacts : factors).push_back(argument);
  }
  if (factors.size() < 2) return std::nullopt;
  if (factors.size() > 2) {
    const auto last = std::max_element(factors.begin(), factors.end(), [&](int one, int other) {
      return depth_of(program_, one) < depth_of(program_, other);
    });
    std::rotate(last, last + 1, factors.end());
  }
  const bool is_single = factors.size() == 2 && exacts.empty();
  std::string all_but_one = is_single ? value(factors[0]) : factor(factors[0]);
  for (std::size_t i = 1; i + 1 < factors.size(); ++i) all_but_one += " * " + factor(factors[i]);
  for (const int exact_one : exacts) all_but_one += " * " + exact(exact_one);
  std::string shown = fmt::format("{}", scale);
  if (shown.find_first_of(".e") == std::string::npos) shown += ".0";
  return all_but_one + ", " + value(factors.back()) + ", " + shown;
}

std::string KernelPrinter::right_side(int number) const {
  const Node& made = node(number);
  switch (made.op) {
    case Op::input:
      if (is_number_input(number)) return made.name;
      [[fallthrough]];
    case Op::index:
    case Op::constant:
      return "Number(" + exact(number) + ")";
    case Op::pi:
      return "Number::pi()";
    case Op::add:
      return sum(made);
    case Op::multiply:
      return product(made);
    case Op::negate:
      return "-" + factor(made.args[0]);
    case Op::magnitude:
      return "magnitude(" + value(made.args[0]) + ")";
    case Op::reciprocal:
      return "reciprocal(" + value(made.args[0]) + ")";
    case Op::divide:
      return factor(made.args[0]) + " / " + factor(made.args[1]);
    case Op::reciprocal_square_root:
      return "reciprocal_square_root(" + value(made.args[0]) + ")";
    case Op::arctangent:
      return "arctangent(" + value(made.args[0]) + ")";
    case Op::half_arcsecant:
      return "half_arcsecant(" + exact(made.args[0]) + ", " + value(made.args[1]) + ")";
    case Op::sine:
    case Op::cosine:
      return "sine_cosine(" + value(made.args[0]) + ")";
    case Op::secant_less_one:
      return "secant_less_one(" + value(made.args[0]) + ")";
    case Op::square_root:
      if (formula(program_, number) == "sqrt(alpha*(1/(2 + alpha)))")
        return "Number::half_arcsecant_tangent(alpha)";
      [[fallthrough]];
    default:
      throw std::logic_error("a kernel has no such operation: " + formula(program_, number));
  }
}

}  // namespace magicmass::codegen
