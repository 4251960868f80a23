// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/emit_kernel_opening.hpp"

#include <algorithm>

#include "codegen/emit.hpp"
#include "codegen/expression.hpp"

namespace magicmass::codegen {
namespace {

std::string comment(const std::string& text) { return wrapped("// " + text + ".") + "\n"; }

std::string includes(const KernelForm& form, const Program& program) {
  const auto include = [](const std::string& header) {
    return "#include \"magicmass/" + header + "\"\n";
  };
  const auto if_used = [&](std::initializer_list<Op> ops, const std::string& header) {
    const bool is_used = std::any_of(
        program.nodes.begin(), program.nodes.end(),
        [&](const Node& node) { return std::find(ops.begin(), ops.end(), node.op) != ops.end(); });
    return is_used ? include(header) : "";
  };
  if (form.is_single) return include("arithmetic/tabled.hpp");
  if (form.rounds_results)
    return include("arithmetic/rough_block.hpp") + include("arithmetic/rough_functions.hpp");
  return if_used({Op::arctangent, Op::half_arcsecant}, "arithmetic/arctangent.hpp") +
         include("arithmetic/block.hpp") + if_used({Op::secant_less_one}, "arithmetic/secant.hpp") +
         if_used({Op::sine}, "arithmetic/sine_cosine.hpp");
}

std::string list(const std::vector<std::string>& ids) {
  std::string text;
  for (const std::string& id : ids) text += (text.empty() ? "" : ", ") + id;
  return text;
}

}  // namespace

std::string kernel_opening(const KernelForm& form, const Program& program) {
  std::vector<std::string> from;
  for (const auto& [member, id] : form.outputs) from.push_back(id);
  std::vector<std::string> with = form.bindings;
  if (!form.arcsecant.empty()) with.push_back(form.arcsecant);
  return file_header(form.summary + ", in any number type") +
         (form.is_single ? "\n" : "\n#include <cstddef>\n\n") + includes(form, program) +
         "#include \"magicmass/quantities.hpp\"\n" +
         "\nnamespace magicmass::generated {\ninline namespace MAGICMASS_TARGET {\n\n" +
         comment(form.summary) + comment("Domain: " + form.domain) +
         comment("From: " + list(from)) + (with.empty() ? "" : comment("With: " + list(with))) +
         (form.first.empty() ? "" : comment("From alpha = 1 on: " + list(form.first))) +
         comment("Cost: " + to_text(operation_counts(program)));
}

}  // namespace magicmass::codegen
