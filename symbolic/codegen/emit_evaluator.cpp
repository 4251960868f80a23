// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/emit.hpp"
#include "codegen/expression.hpp"
#include "codegen/make_kernel.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::codegen {
namespace {

std::string theorem_list(const std::vector<proof::Theorem>& theorems) {
  std::string result;
  for (const proof::Theorem& theorem : theorems) {
    const std::string& label = theorem.step().label;
    result +=
        (result.empty() ? "" : ", ") + theorem.id() + (label.empty() ? "" : " (" + label + ")");
  }
  return result;
}

std::string parameters(const Form& form) {
  std::string result =
      form.exact ? "template <class Field, class Integer>\n" : "template <class Real>\n";
  result += "%RESULT% %NAME%(";
  std::string separator;
  const auto add = [&](const std::string& type, const std::string& name) {
    if (name.empty()) return;
    result += separator + type + name;
    separator = ", ";
  };
  add(form.exact ? "const Field& " : "Real ", form.real_input);
  add(form.exact ? "const Field& " : "Real ", form.restitution);
  add(form.exact ? "const Integer& " : "std::int64_t ", form.index);
  return result + ") {\n";
}

void replace(std::string& text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
}

std::string function(const Form& form, const Program& program, const std::string& name,
                     const std::string& result_type) {
  const std::string type = form.exact ? "Field" : "Real";
  std::string text = parameters(form);
  replace(text, "%RESULT%", result_type);
  replace(text, "%NAME%", name);
  const Emitted emitted = emit_expressions(program, type);
  for (const std::string& definition : emitted.lines) text += wrapped_line("  " + definition);
  if (emitted.outputs.size() == 1)
    return text + wrapped_line("  return " + emitted.outputs[0] + ";") + "}\n";
  text += "  return {\n";
  for (std::size_t i = 0; i < emitted.outputs.size(); ++i)
    text += wrapped_line("      ." + program.outputs[i].name + " = " + emitted.outputs[i] + ",");
  return text + "  };\n}\n";
}

}  // namespace

std::string emit_evaluator(const Evaluator& evaluator) {
  const Form& form = evaluator.form;
  const std::string type = form.exact ? "Field" : "Real";
  bool uses_cmath = false, uses_pi = false, uses_ladder = false;
  for (const Node& node : evaluator.program.nodes) {
    uses_cmath = uses_cmath || node.op == Op::sine || node.op == Op::cosine ||
                 node.op == Op::arctangent || node.op == Op::square_root ||
                 node.op == Op::indexed_power;
    uses_pi = uses_pi || node.op == Op::pi;
    uses_ladder = uses_ladder || node.op == Op::ladder_low;
  }
  std::string text = file_header(form.summary);
  std::string standard, own;
  if (uses_cmath) standard += "#include <cmath>\n";
  if (!form.exact && !form.index.empty()) standard += "#include <cstdint>\n";
  if (uses_pi) standard += "#include <numbers>\n";
  if (uses_ladder) own += "#include \"magicmass/cosine_ladder.hpp\"\n";
  if (!form.result.empty()) own += "#include \"magicmass/quantities.hpp\"\n";
  text += (standard.empty() ? "" : "\n" + standard) + (own.empty() ? "" : "\n" + own);
  text += "\nnamespace magicmass::generated {\n\n";
  const auto documentation = [&](const std::string& what, const Program& program,
                                 const std::vector<proof::Theorem>& from) {
    return wrapped_line("/// " + what + ".") + wrapped_line("/// Domain: " + form.domain + ".") +
           wrapped_line("/// Error: " + form.stated_error() + ".") +
           wrapped_line("/// From: " + theorem_list(from) + ".") +
           (evaluator.bindings.empty()
                ? ""
                : wrapped_line("/// With: " + theorem_list(evaluator.bindings) + ".")) +
           wrapped_line("/// Cost: " + codegen::to_text(operation_counts(program)) + ".");
  };
  const std::string result = form.result.empty() ? type : form.result + "<" + type + ">";
  text += documentation(form.summary, evaluator.program, evaluator.outputs);
  text += function(form, evaluator.program, form.function(), result);
  if (evaluator.single.size() > 1)
    for (std::size_t i = 0; i < evaluator.single.size(); ++i) {
      const std::string& output = evaluator.program.outputs[i].name;
      text += "\n" + wrapped_line("/// Only " + output + ", with that domain and error, from " +
                                  theorem_list({evaluator.outputs[i]}) + "; cost: " +
                                  codegen::to_text(operation_counts(evaluator.single[i])) + ".");
      text += function(form, evaluator.single[i], output + "_" + form.name, type);
    }
  return text + "\n}  // namespace magicmass::generated\n";
}

std::string emit_quantities(const std::vector<proof::Theorem>& theorems) {
  std::string text = file_header("What the evaluators return");
  text += "\n#include <array>\n\nnamespace magicmass::generated {\n";
  for (const QuantityStruct& made : quantity_structs()) {
    std::vector<proof::Theorem> meaning;
    for (const std::string& id : made.meaning) {
      meaning.push_back(theorem_named(theorems, id));
      if (meaning.back().step().verdict != "proved")
        throw InvalidInput(id + " is not proved, and " + made.name + " cites it");
    }
    text += "\n/// " + made.words + "\n" +
            (meaning.empty()
                 ? ""
                 : wrapped_line("/// That they are is proved in " + theorem_list(meaning) + ".")) +
            "template <class Number>\nstruct " + made.name + " {\n";
    for (const auto& [member, words] : made.members)
      text.append("  Number ").append(member).append(";  ///< ").append(words).append("\n");
    text +=
        "};\n\n/// The same in that order.\ntemplate <class Number>\nconstexpr "
        "std::array<Number, " +
        std::to_string(made.members.size()) + "> as_array(const " + made.name +
        "<Number>& all) {\n";
    std::string names;
    for (const auto& [member, words] : made.members)
      names += (names.empty() ? "all." : ", all.") + member;
    text += "  return {" + names + "};\n}\n";
  }
  return text + "\n}  // namespace magicmass::generated\n";
}

}  // namespace magicmass::codegen
