// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/expression.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace magicmass::codegen {
namespace {

enum Precedence { sum, product, factor };

class Emitter {
public:
  Emitter(const Program& program, std::string type)
      : program_(program), type_(std::move(type)), uses_(use_counts(program)) {
    // A minus sign is written where it is needed: what is behind it is used as often as it is.
    for (std::size_t i = program.nodes.size(); i-- > 0;)
      if (program.nodes[i].op == Op::negate)
        uses_[static_cast<std::size_t>(program.nodes[i].args[0])] += uses_[i] - 1;
  }

  Emitted run() {
    for (std::size_t i = 0; i < program_.nodes.size(); ++i)
      if (is_temporary(static_cast<int>(i))) define(static_cast<int>(i));
    for (const Output& output : program_.outputs)
      emitted_.outputs.push_back(print(output.node, sum));
    std::vector<std::string> declarations;
    for (const std::string& function : called_)
      declarations.push_back("using std::" + function + ";");
    emitted_.lines.insert(emitted_.lines.begin(), declarations.begin(), declarations.end());
    return std::move(emitted_);
  }

private:
  const Node& node(int number) const { return program_.nodes[static_cast<std::size_t>(number)]; }

  bool has_partner(int number) const {
    const Op op = node(number).op;
    if (op != Op::sine && op != Op::cosine) return false;
    const Op partner = op == Op::sine ? Op::cosine : Op::sine;
    return std::any_of(program_.nodes.begin(), program_.nodes.end(), [&](const Node& other) {
      return other.op == partner && other.args == node(number).args;
    });
  }

  bool is_temporary(int number) const {
    switch (node(number).op) {
      case Op::input:
      case Op::constant:
      case Op::pi:
      case Op::negate:
        return false;
      case Op::index:
      case Op::ladder_low:
      case Op::ladder_high:
        return true;
      default:
        return uses_[static_cast<std::size_t>(number)] > 1 || !node(number).name.empty() ||
               has_partner(number);
    }
  }

  // T(1) -> T_1, c' -> c_prime; a second temporary of one kind gets a number.
  std::string new_name(int number) {
    const Node& made = node(number);
    static const std::map<Op, std::string> kinds{
        {Op::sine, "sine"},        {Op::cosine, "cosine"},    {Op::reciprocal, "reciprocal"},
        {Op::divide, "ratio"},     {Op::add, "sum"},          {Op::multiply, "product"},
        {Op::square_root, "root"}, {Op::arctangent, "angle"}, {Op::indexed_power, "power"}};
    if (!made.name.empty()) {
      std::string name;
      for (const char character : made.name)
        if (character == '\'')
          name += "_prime";
        else if (character != ')')
          name += character == '(' ? '_' : character;
      return name;
    }
    const auto kind = kinds.find(made.op);
    const std::string base = kind == kinds.end() ? "value" : kind->second;
    return base + "_" + std::to_string(++numbered_[base]);
  }

  void define(int number) {
    const Node& made = node(number);
    if (made.op == Op::index) {
      names_[number] = made.name + "_";
      emitted_.lines.push_back("const " + type_ + " " + names_[number] + " = static_cast<" + type_ +
                               ">(" + made.name + ");");
      return;
    }
    if (made.op == Op::ladder_low || made.op == Op::ladder_high) {
      ladder(number);
      return;
    }
    const std::string name = new_name(number);
    const std::string origin = made.origin.empty() ? "" : ", step " + made.origin;
    emitted_.lines.push_back("// " + name + " = " + formula(program_, number) + origin);
    emitted_.lines.push_back("const " + type_ + " " + name + " = " + print(number, sum) + ";");
    names_[number] = name;
  }

  void ladder(int number) {
    const Node& made = node(number);
    const std::string multiple =
        (made.numerator == 1 ? "" : std::to_string(made.numerator)) + made.name;
    const std::string key = "T_" + multiple;
    if (ladders_.insert(key).second) {
      const std::string argument = made.numerator == 1 ? made.name : made.name + " + " + made.name;
      emitted_.lines.push_back("// " + key + ".low = T(" + multiple + "), " + key + ".high = T(" +
                               multiple + " + 1), steps chebyshev.even, chebyshev.odd");
      emitted_.lines.push_back("const CosinePair<" + type_ + "> " + key + " = cosine_ladder(" +
                               argument + ", " + print(made.args[0], sum) + ", " + type_ + "(1));");
    }
    names_[number] = key + (made.op == Op::ladder_low ? ".low" : ".high");
  }

  std::string constant(const Node& made) const {
    const auto integer = [&](std::int64_t value) {
      return type_ + "(" + std::to_string(value) + ")";
    };
    if (made.denominator == 1) return integer(made.numerator);
    const bool dyadic =
        (made.denominator & (made.denominator - 1)) == 0 && made.denominator <= 1024;
    if (dyadic && type_ == "Real") {  // exact in every binary floating-point type
      std::string digits = std::to_string(static_cast<double>(made.numerator) /
                                          static_cast<double>(made.denominator));
      digits.erase(digits.find_last_not_of('0') + 1);
      return "Real(" + digits + ")";
    }
    return "(" + integer(made.numerator) + " / " + integer(made.denominator) + ")";
  }

  std::string parenthesised(bool needed, const std::string& inside) const {
    return needed ? "(" + inside + ")" : inside;
  }

  std::string print(int number, Precedence outer) {
    if (const auto named = names_.find(number); named != names_.end()) return named->second;
    const Node& made = node(number);
    const auto call = [&](const char* name) {
      called_.insert(name);
      return std::string(name) + "(" + print(made.args[0], sum) + ")";
    };
    switch (made.op) {
      case Op::input:
        return made.name;
      case Op::constant:
        return constant(made);
      case Op::pi:
        return "std::numbers::pi_v<" + type_ + ">";
      case Op::add: {
        std::string result;
        for (const int argument : made.args) {
          const Node& term = node(argument);
          const bool minus = term.op == Op::negate && !names_.contains(argument) && !result.empty();
          result += minus ? " - " + print(term.args[0], product)
                          : (result.empty() ? "" : " + ") +
                                print(argument, result.empty() ? sum : product);
        }
        return parenthesised(outer > sum, result);
      }
      case Op::multiply: {
        std::string result;
        for (const int argument : made.args)
          result +=
              (result.empty() ? "" : " * ") + print(argument, result.empty() ? product : factor);
        return parenthesised(outer > product, result);
      }
      case Op::negate:
        return parenthesised(outer > sum, "-" + print(made.args[0], factor));
      case Op::reciprocal:
        return parenthesised(outer > product, type_ + "(1) / " + print(made.args[0], factor));
      case Op::divide:
        return parenthesised(outer > product,
                             print(made.args[0], product) + " / " + print(made.args[1], factor));
      case Op::indexed_power:
        return "std::pow(" + print(made.args[0], sum) + ", " + print(made.args[1], sum) + ")";
      case Op::square_root:
        return call("sqrt");
      case Op::sine:
        return call("sin");
      case Op::cosine:
        return call("cos");
      case Op::arctangent:
        return call("atan");
      default:
        throw std::logic_error("a node that no pass should have left");
    }
  }

  const Program& program_;
  std::string type_;
  std::vector<int> uses_;
  std::map<int, std::string> names_;
  std::map<std::string, int> numbered_;
  std::set<std::string> ladders_;
  std::set<std::string> called_;
  Emitted emitted_;
};

}  // namespace

Emitted emit_expressions(const Program& program, const std::string& type) {
  return Emitter(program, type).run();
}

std::string wrapped(const std::string& line, std::size_t columns) {
  if (line.size() <= columns) return line;
  const std::size_t indent = line.find_first_not_of(' ');
  const std::size_t slashes = line.find_first_not_of('/', indent) - indent;
  const std::string comment = slashes < 2 ? "" : std::string(slashes, '/');
  std::size_t cut = std::string::npos;
  for (const char* place : {" + ", " - ", " * ", " / ", ", "}) {
    const std::size_t found = line.rfind(place, columns - 2);
    if (found != std::string::npos && found > indent + 20 &&
        (cut == std::string::npos || found > cut))
      cut = found + (place[0] == ',' ? 1 : 2);
  }
  if (cut == std::string::npos) return line;
  const std::string rest = std::string(indent, ' ') + (comment.empty() ? "    " : comment + "   ") +
                           line.substr(cut + 1);
  return line.substr(0, cut) + "\n" + wrapped(rest, columns);
}

std::string wrapped_line(const std::string& line) { return wrapped(line) + "\n"; }

}  // namespace magicmass::codegen
