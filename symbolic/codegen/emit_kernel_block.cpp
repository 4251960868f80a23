// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/emit_kernel_block.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "codegen/expression.hpp"

namespace magicmass::codegen {
namespace {

// The stage after which psi/4 is known.
int stage_of_angle(const Program& program, const Stages& stages) {
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    if (program.nodes[i].op == Op::arctangent || program.nodes[i].op == Op::half_arcsecant)
      return stages.stage[i];
  throw std::logic_error("what is counted is counted from an angle");
}

// Where the outputs go. Numbers that round their results are wanted for all of them.
std::string stored(const KernelForm& form, const Program& program) {
  std::string text;
  for (const Output& output : program.outputs) {
    const std::string& name = output.name;
    if (form.rounds_results)
      text += "    arithmetic::store(rounded(result." + name + "), " + name + " + i);\n";
    else
      text += "    " + std::string(text.empty() ? "auto known = " : "known &= ") +
              "certain.template store<Kernel::degrees." + name + ">(result." + name + ", " + name +
              ", i);\n";
  }
  return text + (form.rounds_results ? "" : "    certain.put(i, known);\n");
}

}  // namespace

std::vector<std::string> loaded_inputs(const KernelForm& form) {
  std::vector<std::string> all = form.reals;
  all.insert(all.end(), form.integers.begin(), form.integers.end());
  return all;
}

bool is_needed_in(int number, int stage, const Program& program, const Stages& stages,
                  const KernelForm& form) {
  if (stages.stage[static_cast<std::size_t>(number)] >= stage) return false;
  const auto is_in_stage = [&](std::size_t i) { return stages.stage[i] == stage; };
  const bool is_root =
      program.nodes[static_cast<std::size_t>(number)].op == Op::reciprocal_square_root;
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const Node& node = program.nodes[i];
    if (!is_in_stage(i)) continue;
    if (std::find(node.args.begin(), node.args.end(), number) != node.args.end()) return true;
    // the selections from alpha = 1 on use the root where the turn is known
    if (!form.first.empty() && is_root && node.op == Op::sine) return true;
  }
  return false;
}

std::string emit_degrees(const KernelForm& form, const Program& program) {
  if (form.result.empty() || form.rounds_results) return "";
  std::string text;
  for (const Output& output : program.outputs)
    text += fmt::format("{}.{} = {}", text.empty() ? "" : ", ", output.name,
                        std::max(1, degree_of(program, output.node)));
  return "  // How many factors that are not exact go into each, or 1.\n" +
         wrapped_line("  static constexpr " + form.result + "<int> degrees{" + text + "};");
}

std::string emit_block(const KernelForm& form, const Program& program, const Stages& stages,
                       const KernelPrinter& printer, const std::map<int, std::string>& carried) {
  const std::vector<std::string> inputs = loaded_inputs(form);
  const std::vector<std::string> counted =
      form.is_counted ? form.integers : std::vector<std::string>{};
  const auto is_counted = [&counted](const std::string& input) {
    return std::find(counted.begin(), counted.end(), input) != counted.end();
  };
  std::string names;
  for (const std::string& name : counted) names += ", " + name;
  std::string text =
      "// A block of at most arithmetic::block_size elements, a whole number of vectors.\n" +
      std::string(form.rounds_results ? ""
                                      : "// An output that is not wanted is null; `certain` is for "
                                        "number types that know.\n") +
      (counted.empty() ? "" : "// count(angles" + names + ") fills in the latter.\n") +
      "template <class Number" + (counted.empty() ? "" : ", class Count") + ">\n";
  std::string signature = "void " + form.name + "_block(std::size_t size";
  for (const std::string& input : inputs)
    if (!is_counted(input)) signature += ", const double* " + input;
  if (!counted.empty()) signature += ", Count count";
  for (const Output& output : program.outputs) signature += ", double* " + output.name;
  if (!form.rounds_results) signature += ", arithmetic::Certainty<Number>& certain";
  text += wrapped_line(signature + ") {");
  text += "  using Kernel = " + form.kernel +
          "<Number>;\n  using Real = typename Number::Real;\n  constexpr std::size_t lanes = "
          "arithmetic::lane_count<Real>;\n";
  for (const auto& [number, type] : carried)
    text += "  arithmetic::Block<" + type + "> " + printer.name(number) + "s;\n";
  for (const std::string& name : counted)
    text += "  alignas(64) arithmetic::BlockOfDoubles " + name + ";\n";
  const int counted_after = counted.empty() ? stages.count : stage_of_angle(program, stages);
  for (int s = 0; s < stages.count; ++s) {
    text += "  for (std::size_t i = 0; i < size; i += lanes) {\n    Kernel kernel;\n";
    for (const std::string& input : inputs)
      if (!is_counted(input))
        text += "    kernel." + input + " = arithmetic::load<Real>(" + input + " + i);\n";
      else if (s > counted_after)
        text += "    kernel." + input + " = arithmetic::load<Real>(&" + input + "[i]);\n";
    for (const auto& [number, type] : carried)
      if (is_needed_in(number, s, program, stages, form))
        text += "    kernel." + printer.name(number) + " = " + printer.name(number) + "s.get(i);\n";
    if (s + 1 < stages.count) {
      text += fmt::format("    kernel.stage_{}();\n", s + 1);
      for (const auto& [number, type] : carried)
        if (stages.stage[static_cast<std::size_t>(number)] == s)
          text +=
              "    " + printer.name(number) + "s.put(i, kernel." + printer.name(number) + ");\n";
    } else {
      text += "    const auto result = kernel.result();\n";
      text += stored(form, program);
    }
    text += "  }\n";
    if (s == counted_after) {
      std::string arrays;
      for (const std::string& name : counted) arrays += ", " + name + ".data()";
      text += "  count(angles" + arrays + ");\n";
    }
  }
  return text + "}\n";
}

}  // namespace magicmass::codegen
