// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "codegen/emit.hpp"
#include "codegen/expression.hpp"
#include "codegen/kernel_expression.hpp"

namespace magicmass::codegen {
namespace {

std::string line(const std::string& text) { return wrapped(text) + "\n"; }

class KernelEmitter {
public:
  explicit KernelEmitter(const Kernel& kernel)
      : kernel_(kernel),
        form_(kernel.form),
        program_(kernel.program),
        stages_(stages_of(program_)),
        printer_(program_, form_.numbers) {
    for (std::size_t i = 0; i < program_.nodes.size(); ++i)
      for (const int argument : program_.nodes[i].args)
        if (stage(static_cast<int>(i)) != stage(argument) && printer_.is_kept(argument))
          carried_.insert(argument);
  }

  std::string run() {
    std::string text = file_header(form_.summary + ", in any number type");
    const auto include = [](const std::string& header) {
      return "#include \"magicmass/" + header + "\"\n";
    };
    text += "\n#include <cstddef>\n\n" +
            (uses(Op::arctangent) ? include("arithmetic/arctangent.hpp") : "") +
            include("arithmetic/block.hpp") +
            (uses(Op::secant_less_one) ? include("arithmetic/secant.hpp") : "") +
            (uses(Op::sine) ? include("arithmetic/sine_cosine.hpp") : "") +
            include("quantities.hpp") +
            "\nnamespace magicmass::generated {\ninline namespace MAGICMASS_TARGET {\n\n";
    text += documentation() + "template <class Number>\nstruct " + form_.kernel + " {\n";
    text +=
        "  using Real = typename Number::Real;\n  static constexpr bool in_lanes = "
        "arithmetic::lane_count<Real> > 1;\n\n";
    for (const std::string& input : inputs()) text += "  Real " + input + ";\n";
    for (const std::string& input : form_.numbers) text += "  Number " + input + ";\n";
    for (const int number : carried_)
      text += line("  Number " + printer_.name(number) + ";  // " + formula(program_, number) +
                   origin(number));
    for (int s = 0; s + 1 < stages_.count; ++s) text += "\n" + stage_function(s);
    text += "\n" + result_function();
    if (!form_.first.empty()) text += "\n" + first_function();
    text += "\n" + evaluate_function() + "};\n\n" + block_function();
    return text + "\n}  // namespace MAGICMASS_TARGET\n}  // namespace magicmass::generated\n";
  }

private:
  bool uses(Op op) const {
    return std::any_of(program_.nodes.begin(), program_.nodes.end(),
                       [op](const Node& node) { return node.op == op; });
  }
  int stage(int number) const { return stages_.stage[static_cast<std::size_t>(number)]; }
  const Node& node(int number) const { return program_.nodes[static_cast<std::size_t>(number)]; }
  std::string origin(int number) const {
    return node(number).origin.empty() ? "" : ", step " + node(number).origin;
  }
  std::vector<std::string> inputs() const {
    std::vector<std::string> all = form_.reals;
    all.insert(all.end(), form_.integers.begin(), form_.integers.end());
    return all;
  }

  std::string documentation() const {
    std::string from, with, first;
    for (const auto& [member, id] : form_.outputs) from += (from.empty() ? "" : ", ") + id;
    for (const std::string& id : form_.bindings) with += (with.empty() ? "" : ", ") + id;
    for (const std::string& id : form_.first) first += (first.empty() ? "" : ", ") + id;
    return line("// " + form_.summary + ".") + line("// Domain: " + form_.domain + ".") +
           line("// From: " + from + ".") + (with.empty() ? "" : line("// With: " + with + ".")) +
           (first.empty() ? "" : line("// From alpha = 1 on: " + first + ".")) +
           line("// Cost: " + codegen::text(operation_counts(program_)) + ".");
  }

  // The values of a stage in the program's order; a sine and a cosine of one angle together.
  std::string assignments(int s, const std::string& indent) const {
    std::string text;
    std::set<int> done;
    for (std::size_t i = 0; i < program_.nodes.size(); ++i) {
      const int number = static_cast<int>(i);
      if (!printer_.is_kept(number) || stage(number) != s || done.contains(number)) continue;
      const Op op = node(number).op;
      if (op == Op::sine || op == Op::cosine) {
        const std::string turned = "turned" + (done.empty() ? "" : fmt::format("_{}", done.size()));
        text += line(indent + "const auto " + turned + " = " + printer_.right_side(number) + ";");
        for (std::size_t j = i; j < program_.nodes.size(); ++j) {
          const Node& other = program_.nodes[j];
          if ((other.op != Op::sine && other.op != Op::cosine) || other.args != node(number).args)
            continue;
          done.insert(static_cast<int>(j));
          text += indent + printer_.name(static_cast<int>(j)) + " = " + turned + "." +
                  (other.op == Op::sine ? "sine" : "cosine") + ";\n";
        }
        if (!form_.first.empty()) text += replaced_turn(indent);
        continue;
      }
      if (op == Op::secant_less_one && paired_secants(number, indent, text, done)) continue;
      std::string value = printer_.right_side(number);
      if (op == Op::reciprocal_square_root && !form_.first.empty()) {
        text += line(indent + "Number square = " + printer_.value(node(number).args[0]) + ";");
        text += indent + "if constexpr (in_lanes) {  // from alpha = 1 on: 1/(1 + alpha)\n" +
                indent +
                "  square = square + arithmetic::where(alpha >= Real(1.0), Real(1.0));  // (1 + "
                "alpha)^2\n" +
                indent + "}\n";
        value = "reciprocal_square_root(square)";
      }
      text += line(indent + assigned(number) + " = " + value + ";");
    }
    return text;
  }

  // Its name, or its definition where no later stage has it.
  std::string assigned(int number) const {
    return (carried_.contains(number) ? "" : "const Number ") + printer_.name(number);
  }

  // Two secants of a stage side by side. False if there is no other.
  bool paired_secants(int number, const std::string& indent, std::string& text,
                      std::set<int>& done) const {
    for (std::size_t j = static_cast<std::size_t>(number) + 1; j < program_.nodes.size(); ++j) {
      const int other = static_cast<int>(j);
      if (node(other).op != Op::secant_less_one || stage(other) != stage(number)) continue;
      text += line(indent + "const auto secants = secants_less_one(" +
                   printer_.value(node(number).args[0]) + ", " +
                   printer_.value(node(other).args[0]) + ");") +
              indent + assigned(number) + " = secants.first;\n" + indent + assigned(other) +
              " = secants.second;\n";
      done.insert(other);
      return true;
    }
    return false;
  }

  std::string replaced_turn(const std::string& indent) const {
    return indent + "if constexpr (in_lanes) {  // two collisions\n" + indent +
           "  const auto is_beyond = alpha >= Real(1.0);\n" + indent +
           "  sine = select(is_beyond, " + form_.first_sine() + ", sine);\n" + indent +
           "  cosine = select(is_beyond, " + form_.first_cosine() + ", cosine);\n" + indent + "}\n";
  }

  std::string stage_function(int s) const {
    return fmt::format("  [[gnu::always_inline]] void stage_{}() {{\n", s + 1) +
           assignments(s, "    ") + "  }\n";
  }

  // Where all outputs are products they are handed out unevaluated: rounding one costs less than evaluating it.
  std::string result_type() const {
    if (form_.result.empty()) return "Number";
    return form_.result + (has_products() ? "<arithmetic::Product<Number>>" : "<Number>");
  }
  bool has_products() const {
    return std::all_of(program_.outputs.begin(), program_.outputs.end(), [&](const Output& output) {
      return printer_.as_product(output.node).has_value();
    });
  }

  std::string result_function() const {
    std::string text = "  [[gnu::always_inline]] " + result_type() + " result() const {\n" +
                       assignments(stages_.count - 1, "    ");
    if (form_.result.empty())
      return text + line("    return " + printer_.value(program_.outputs[0].node) + ";") + "  }\n";
    text += "    return {\n";
    for (const Output& output : program_.outputs)
      text += line("        ." + output.name + " = " +
                   (has_products() ? "{" + *printer_.as_product(output.node) + "}"
                                   : printer_.value(output.node)) +
                   ",");
    return text + "    };\n  }\n";
  }

  // The first collisions in a single number: what the selections above do in lanes.
  std::string first_function() const {
    std::string text =
        "  // From alpha = 1 on, where there are two collisions.\n  [[gnu::always_inline]] void "
        "first() {\n"
        "    cot_half = reciprocal(Number::sum(Real(1.0), alpha));\n";
    for (const int number : carried_)
      if (node(number).op == Op::multiply || node(number).op == Op::add)
        text += line("    " + printer_.name(number) + " = " + printer_.right_side(number) + ";");
    return text + "    sine = " + form_.first_sine() + ";\n    cosine = " + form_.first_cosine() +
           ";\n  }\n";
  }

  std::string evaluate_function() const {
    std::string parameters, members;
    for (const std::string& input : inputs()) {
      parameters += (parameters.empty() ? "Real " : ", Real ") + input;
      members += "    kernel." + input + " = " + input + ";\n";
    }
    for (const std::string& input : form_.numbers) {
      parameters += (parameters.empty() ? "Number " : ", Number ") + input;
      members += "    kernel." + input + " = " + input + ";\n";
    }
    std::string text = line("  [[gnu::always_inline]] static " + result_type() + " evaluate(" +
                            parameters + ") {") +
                       "    " + form_.kernel + " kernel;\n" + members;
    if (!form_.first.empty())
      text +=
          "    if constexpr (!in_lanes)\n      if (alpha >= 1.0) {\n        kernel.first();\n      "
          "  "
          "return kernel.result();\n      }\n";
    for (int s = 1; s < stages_.count; ++s) text += fmt::format("    kernel.stage_{}();\n", s);
    return text + "    return kernel.result();\n  }\n";
  }

  // Loops over a block, a stage each, with the carried values in between.
  std::string block_function() const {
    if (form_.result.empty() || !form_.numbers.empty()) return "";
    std::string text =
        "// A block of at most arithmetic::block_size elements, a whole number of vectors.\n// An "
        "output "
        "that is not wanted is null; `certain` is for number types that know.\n"
        "template <class Number>\n";
    std::string signature = "void " + form_.name + "_block(std::size_t size";
    for (const std::string& input : inputs()) signature += ", const double* " + input;
    for (const Output& output : program_.outputs) signature += ", double* " + output.name;
    text += line(signature + ", arithmetic::Certainty<Number>& certain) {");
    text += "  using Kernel = " + form_.kernel +
            "<Number>;\n  using Real = typename Number::Real;\n  constexpr std::size_t lanes = "
            "arithmetic::lane_count<Real>;\n";
    for (const int number : carried_)
      text += "  arithmetic::Block<Number> " + printer_.name(number) + "s;\n";
    for (int s = 0; s < stages_.count; ++s) {
      text += "  for (std::size_t i = 0; i < size; i += lanes) {\n    Kernel kernel;\n";
      for (const std::string& input : inputs())
        text += "    kernel." + input + " = arithmetic::load<Real>(" + input + " + i);\n";
      for (const int number : carried_)
        if (is_needed(number, s))
          text +=
              "    kernel." + printer_.name(number) + " = " + printer_.name(number) + "s.get(i);\n";
      if (s + 1 < stages_.count) {
        text += fmt::format("    kernel.stage_{}();\n", s + 1);
        for (const int number : carried_)
          if (stage(number) == s)
            text += "    " + printer_.name(number) + "s.put(i, kernel." + printer_.name(number) +
                    ");\n";
      } else {
        text += "    const auto result = kernel.result();\n";
        for (const Output& output : program_.outputs)
          text += "    if (" + output.name + " != nullptr) certain.store(result." + output.name +
                  ", " + output.name + ", i);\n";
      }
      text += "  }\n";
    }
    return text + "}\n";
  }

  bool is_needed(int number, int s) const {
    if (stage(number) >= s) return false;
    for (std::size_t i = 0; i < program_.nodes.size(); ++i) {
      const auto& args = program_.nodes[i].args;
      if (stages_.stage[i] == s && std::find(args.begin(), args.end(), number) != args.end())
        return true;
    }
    // the selections from alpha = 1 on use the root where the turn is known
    return !form_.first.empty() && node(number).op == Op::reciprocal_square_root &&
           std::any_of(program_.nodes.begin(), program_.nodes.end(), [&](const Node& other) {
             return other.op == Op::sine &&
                    stage(static_cast<int>(&other - program_.nodes.data())) == s;
           });
  }

  const Kernel& kernel_;
  const KernelForm& form_;
  const Program& program_;
  Stages stages_;
  KernelPrinter printer_;
  std::set<int> carried_;
};

}  // namespace

std::string emit_kernel(const Kernel& kernel) { return KernelEmitter(kernel).run(); }

}  // namespace magicmass::codegen
