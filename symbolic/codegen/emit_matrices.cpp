// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "codegen/emit.hpp"
#include "codegen/expression.hpp"
#include "codegen/lower.hpp"
#include "codegen/make_kernel.hpp"
#include "codegen/pipelines.hpp"

namespace magicmass::codegen {
namespace {

std::string matrix_function(const MatrixForm& form, const std::vector<proof::Theorem>& theorems) {
  const auto named = [&](const std::string& id) { return theorem_named(theorems, id); };
  Source source{{{"entry", named(form.theorem)}}, {}, {"alpha"}, form.index, {"V", "L"}};
  source.left_sides = form.left_side;
  std::string with;
  for (const std::string& id : form.bindings) {
    source.bindings.push_back(named(id));
    with += (with.empty() ? "" : ", ") + id;
  }
  const Program program = in_plain_numbers(lower(source));
  const std::string type = form.exact ? "Field" : "Real";
  const std::string& label = source.outputs[0].second.step().label;
  std::string text =
      "\n" + wrapped_line("/// " + form.summary + ".") +
      wrapped_line("/// Domain: " + form.domain + ".") +
      wrapped_line("/// Error: " + form.error + ".") +
      wrapped_line("/// From: " + form.theorem + (label.empty() ? "" : " (" + label + ")") +
                   (form.left_side ? ", its left side" : "") + ".");
  if (!with.empty()) text += wrapped_line("/// With: " + with + ".");
  text += wrapped_line("/// Cost: " + codegen::to_text(operation_counts(program)) + ".");
  const bool is_vector = program.outputs.size() == 3;
  const bool has_integers = form.exact && !form.index.empty();
  text +=
      "template <class " + type + (has_integers ? ", class Integer" : "") + ">\n" +
      (is_vector ? "std::array<" + type + ", 3> " : "Rows<" + type + "> ") + form.function +
      "(const " + type + "& alpha" +
      (form.index.empty() ? ""
                          : (has_integers ? ", const Integer& " : ", std::int64_t ") + form.index) +
      ") {\n";
  const Emitted emitted = emit_expressions(program, type);
  for (const std::string& definition : emitted.lines) text += wrapped_line("  " + definition);
  text += is_vector ? "  return {\n" : "  return {{\n";
  const auto& entries = emitted.outputs;
  for (std::size_t i = 0; i < entries.size(); i += is_vector ? 1 : 3)
    text += wrapped_line(
        "      " +
        (is_vector ? entries[i]
                   : "{" + entries[i] + ", " + entries[i + 1] + ", " + entries[i + 2] + "}") +
        ",");
  return text + (is_vector ? "  };\n}\n" : "  }};\n}\n");
}

}  // namespace

std::string emit_matrices(const std::vector<proof::Theorem>& theorems) {
  std::string text = file_header("The matrices of a cycle and the vector that they turn");
  text +=
      "\n#include <array>\n#include <cmath>\n#include <cstdint>\n\n#include "
      "\"magicmass/cosine_ladder.hpp\"\n\nnamespace magicmass::generated {\n\n/// A 3x3 matrix, "
      "row "
      "by "
      "row.\ntemplate <class Number>\nusing Rows = std::array<std::array<Number, 3>, 3>;\n";
  for (const MatrixForm& form : matrix_forms()) text += matrix_function(form, theorems);
  return text + "\n}  // namespace magicmass::generated\n";
}

}  // namespace magicmass::codegen
