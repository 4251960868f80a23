// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/pass_program.hpp"

#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "codegen/lower.hpp"
#include "codegen/passes/canonical_order.hpp"
#include "codegen/passes/common_subexpressions.hpp"
#include "codegen/passes/dead_code.hpp"
#include "derivation/derivation.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

using codegen::Op;

std::string fraction(const codegen::Node& node) {
  if (node.denominator == 1) return std::to_string(node.numerator);
  return fmt::format("{}.0 / {}", node.numerator, node.denominator);
}

/// The starter's name for an operation, and the node's number where it has one.
std::pair<std::string, std::string> operation_of(const codegen::Node& node) {
  switch (node.op) {
    case Op::input:
      return {node.name, "0"};  // alpha
    case Op::index:
      return {node.name, "0"};  // n
    case Op::constant:
      return {"constant", fraction(node)};
    case Op::add:
      return {"sum", "0"};
    case Op::multiply:
      return {"product", "0"};
    case Op::negate:
      return {"negative", "0"};
    case Op::reciprocal:
      return {"reciprocal", "0"};
    case Op::power:
      return {"power", fraction(node)};
    case Op::sine:
      return {"sine", "0"};
    case Op::cosine:
      return {"cosine", "0"};
    case Op::arctangent:
      return {"arctangent", "0"};
    default:
      throw InvalidInput("program: an operation that students' programs do not have");
  }
}

/// A table and a loop: initialisers of vectors, node by node, take a compiler seconds.
std::string header_of(const codegen::Program& program) {
  std::string rows;
  std::string arguments;
  std::size_t start = 0;
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const codegen::Node& node = program.nodes[i];
    const auto [operation, value] = operation_of(node);
    rows += fmt::format("      {{Operation::{}, {}, {}, {}}},  // {}: {}\n", operation, value,
                        start, node.args.size(), i, codegen::formula(program, static_cast<int>(i)));
    for (const int argument : node.args) arguments += fmt::format("{}, ", argument);
    start += node.args.size();
  }
  std::string outputs;
  for (const codegen::Output& output : program.outputs)
    outputs += fmt::format("  program.outputs.push_back({});\n", output.node);
  return "inline Program program_before() {\n"
         "  struct Row {\n    Operation operation;\n    double value;\n    int start, count;\n  "
         "};\n"
         "  static const Row rows[] = {\n" +
         rows + "  };\n  static const int arguments[] = {" + arguments +
         "};\n"
         "  Program program;\n"
         "  for (const Row& row : rows)\n"
         "    program.nodes.push_back(\n"
         "        {row.operation,\n"
         "         {arguments + row.start, arguments + row.start + row.count},\n"
         "         row.value});\n" +
         outputs + "  return program;\n}\n";
}

PassProgram made(const GeneratorPass& pass, const std::string& place) {
  static const derivation::Derivation derivation = derivation::derive();
  const auto theorem = [&](const std::string& id) {
    try {
      return derivation.at(id);
    } catch (const InvalidInput&) {
      throw InvalidInput(place + ": program: there is no theorem called " + shown_text(id) +
                         "; magicmass derive --list has them");
    }
  };
  codegen::Source source;
  for (const auto& [name, id] : pass.outputs) source.outputs.emplace_back(name, theorem(id));
  for (const std::string& id : pass.bindings) source.bindings.push_back(theorem(id));
  source.real_inputs = {"alpha"};
  source.index = "n";
  source.units = {"V", "L"};
  try {
    codegen::Program before = codegen::canonical_order(codegen::lower(source));
    const bool is_sharing = pass.name == "common_subexpressions";
    if (!is_sharing) before = codegen::without_repetitions(before);
    const codegen::Program after =
        is_sharing ? codegen::without_repetitions(before) : codegen::dead_code(before, pass.wanted);
    return {header_of(before), fmt::format("{{\"before\": {}, \"after\": {}}}", before.nodes.size(),
                                           after.nodes.size())};
  } catch (const std::logic_error& error) {
    throw InvalidInput(place + ": program: " + error.what());
  }
}

}  // namespace

const PassProgram& pass_program(const Exercise& exercise) {
  static std::map<std::string, PassProgram> programs;
  const std::string place = (exercise.folder / "exercise.toml").string();
  const auto found = programs.find(place);
  if (found != programs.end()) return found->second;
  return programs[place] = made(exercise.code.pass, place);
}

}  // namespace magicmass::command
