// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "codegen/emit.hpp"
#include "codegen/emit_kernel_block.hpp"
#include "codegen/emit_kernel_opening.hpp"
#include "codegen/expression.hpp"
#include "codegen/kernel_expression.hpp"

namespace magicmass::codegen {
namespace {

class KernelEmitter {
public:
  explicit KernelEmitter(const Kernel& kernel)
      : form_(kernel.form),
        program_(kernel.program),
        stages_(stages_of(program_, form_.cuts_turns)),
        printer_(program_, stages_, form_.numbers) {
    if (form_.rounds_results) printer_.put_doubles_first();
    for (std::size_t i = 0; i < program_.nodes.size(); ++i)
      for (const int argument : program_.nodes[i].args)
        if (stage(static_cast<int>(i)) != stage(argument) && printer_.is_kept(argument))
          carried_.insert(argument);
  }

  std::string run() {
    std::string text = kernel_opening(form_, program_);
    text += "template <class Number>\nstruct " + form_.kernel + " {\n";
    text += "  using Real = typename Number::Real;\n";
    if (!form_.rounds_results)
      text += "  static constexpr bool in_lanes = arithmetic::lane_count<Real> > 1;\n";
    text += emit_degrees(form_, program_) + "\n";
    for (const std::string& input : inputs()) text += "  Real " + input + ";\n";
    for (const std::string& input : form_.numbers) text += "  Number " + input + ";\n";
    for (const int number : carried_)
      text += wrapped_line("  " + type(number) + " " + printer_.name(number) + ";  // " +
                           formula(program_, number) + origin(number));
    for (int s = 0; s + 1 < stages_.count; ++s) text += "\n" + stage_function(s);
    text += "\n" + (form_.is_single ? rounded_result_function() : result_function());
    if (!form_.rounds_results) {
      if (has_rounded_result()) text += "\n" + rounded_result_function();
      if (!form_.first.empty()) text += "\n" + first_function();
      text += "\n" + evaluate_function();
    }
    text += "};\n";
    if (!form_.result.empty() && form_.numbers.empty() && !form_.is_single)
      text += "\n" + emit_block(form_, program_, stages_, printer_, carried());
    return text + "\n}  // namespace MAGICMASS_TARGET\n}  // namespace magicmass::generated\n";
  }

private:
  int stage(int number) const { return stages_.stage[static_cast<std::size_t>(number)]; }
  const Node& node(int number) const { return program_.nodes[static_cast<std::size_t>(number)]; }
  std::string origin(int number) const {
    return node(number).origin.empty() ? "" : ", step " + node(number).origin;
  }
  // What a value is carried from stage to stage as.
  std::string type(int number) const {
    const Op op = node(number).op;
    if (form_.rounds_results && (op == Op::reciprocal_square_root || op == Op::square_root))
      return "typename Number::Root";
    if (op == Op::arctangent || op == Op::half_arcsecant) return "typename Number::ArcTangent";
    if (!form_.small_angle.empty() && op == Op::sine) return "typename Number::SmallSine";
    if (!form_.small_angle.empty() && op == Op::cosine) return "typename Number::SmallCosine";
    return "Number";
  }
  std::map<int, std::string> carried() const {
    std::map<int, std::string> types;
    for (const int number : carried_) types.emplace(number, type(number));
    return types;
  }
  std::vector<std::string> inputs() const { return loaded_inputs(form_); }

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
        const std::string of_small = form_.small_angle.empty() ? "" : "small_";
        text += wrapped_line(indent + "const auto " + turned + " = " + of_small +
                             printer_.right_side(number) + ";");
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
      if (op == Op::reciprocal_square_root && form_.rounds_results) {
        text += is_beyond(indent);
        value = root_of_argument;
      } else if (op == Op::reciprocal_square_root && !form_.first.empty()) {
        text += indent + "if constexpr (in_lanes) {  // from alpha = 1 on: 1/(1 + alpha)\n" +
                indent + "  const auto is_beyond = alpha >= Real(1.0);\n" + indent + "  " +
                assigned(number) + " = " + root_of_argument + ";\n" + indent + "} else {\n" +
                wrapped_line(indent + "  " + assigned(number) + " = " + value + ";") + indent +
                "}\n";
        continue;
      }
      text += wrapped_line(indent + assigned(number) + " = " + value + ";");
    }
    return text;
  }

  // Its name, or its definition where no later stage has it.
  std::string assigned(int number) const {
    if (carried_.contains(number)) return printer_.name(number);
    const auto& of = node(number).args;
    const bool is_of_numbers =
        std::all_of(of.begin(), of.end(), [&](int argument) { return type(argument) == "Number"; });
    const std::string made = form_.rounds_results || !is_of_numbers ? "auto" : "Number";
    return "const " + made + " " + printer_.name(number);
  }

  // Two secants of a stage side by side. False if there is no other.
  bool paired_secants(int number, const std::string& indent, std::string& text,
                      std::set<int>& done) const {
    for (std::size_t j = static_cast<std::size_t>(number) + 1; j < program_.nodes.size(); ++j) {
      const int other = static_cast<int>(j);
      if (node(other).op != Op::secant_less_one || stage(other) != stage(number)) continue;
      text += wrapped_line(indent + "const auto secants = secants_less_one(" +
                           printer_.value(node(number).args[0]) + ", " +
                           printer_.value(node(other).args[0]) + ");") +
              indent + assigned(number) + " = secants.first;\n" + indent + assigned(other) +
              " = secants.second;\n";
      done.insert(other);
      return true;
    }
    return false;
  }

  static constexpr const char* root_of_argument =
      "reciprocal_square_root(Number::root_argument(alpha, is_beyond))";
  static std::string is_beyond(const std::string& indent) {
    return indent + "const auto is_beyond = alpha >= Real(1.0);\n";
  }

  std::string replaced_turn(const std::string& indent) const {
    if (form_.rounds_results) {
      const std::string one = "(Real(1.0))";
      return is_beyond(indent) + indent + "sine = select(is_beyond, Number" + one + ", sine);\n" +
             indent + "cosine = select(is_beyond, Number(cot_half), cosine);\n";
    }
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
    if (form_.rounds_results) return form_.result + "<typename Number::Result>";
    return form_.result + (has_products() ? "<arithmetic::Product<Number>>" : "<Number>");
  }
  bool has_products() const {
    return !form_.rounds_results && product_count() == program_.outputs.size();
  }
  std::size_t product_count() const {
    std::size_t count = 0;
    for (const Output& output : program_.outputs)
      if (printer_.as_product(output.node)) ++count;
    return count;
  }
  // Where some are, and single numbers are asked for, each is rounded as what it is.
  bool has_rounded_result() const {
    return !form_.arcsecant.empty() && !form_.result.empty() && !has_products();
  }

  template <class Value>
  std::string members(const Value& value) const {
    std::string text = "    return {\n";
    for (const Output& output : program_.outputs)
      text += wrapped_line("        ." + output.name + " = " + value(output.node) + ",");
    return text + "    };\n  }\n";
  }
  std::string rounded_result_function() const {
    const std::string what = form_.is_single ? "Each" : "The same, each";
    return "  // " + what + " rounded to the nearest or so.\n  [[gnu::always_inline]] " +
           form_.result + "<Real> rounded_result() const {\n" +
           assignments(stages_.count - 1, "    ") +
           "    using Product = arithmetic::Product<Number>;\n" + members([&](int output) {
             const auto product = printer_.as_product(output);
             return "rounded(" + (product ? "Product{" + *product + "}" : printer_.value(output)) +
                    ")";
           });
  }

  std::string result_function() const {
    std::string text = "  [[gnu::always_inline]] " + result_type() + " result() const {\n";
    if (form_.rounds_results) return text + rounded_results();
    text += assignments(stages_.count - 1, "    ");
    if (form_.result.empty())
      return text + wrapped_line("    return " + printer_.value(program_.outputs[0].node) + ";") +
             "  }\n";
    return text + members([&](int output) {
             return has_products() ? "{" + *printer_.as_product(output) + "}"
                                   : printer_.value(output);
           });
  }

  // A tangent that results use is cut for their products first.
  std::string rounded_results() const {
    KernelEmitter in_parts = *this;
    std::string text;
    const int last = stages_.count - 1;
    for (const int number : carried_) {
      const bool is_tangent =
          node(number).op == Op::multiply && is_needed_in(number, last, program_, stages_, form_);
      if (!is_tangent) continue;
      const std::string parts = printer_.name(number) + "_parts";
      text += wrapped_line("    const auto " + parts + " = parts(" + printer_.name(number) + ");");
      in_parts.printer_.rename(number, parts);
    }
    text += in_parts.assignments(last, "    ");
    return text + members([&](int output) { return in_parts.printer_.value(output); });
  }
  // The first collisions in a single number: what the selections above do in lanes.
  std::string first_function() const {
    std::string text =
        "  // From alpha = 1 on, where there are two collisions.\n  [[gnu::always_inline]] void "
        "first() {\n"
        "    cot_half = reciprocal(Number::sum(Real(1.0), alpha));\n";
    for (const int number : carried_)
      if (node(number).op == Op::multiply || node(number).op == Op::add)
        text += wrapped_line("    " + printer_.name(number) + " = " + printer_.right_side(number) +
                             ";");
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
    std::string text = wrapped_line("  [[gnu::always_inline]] static " + result_type() +
                                    " evaluate(" + parameters + ") {") +
                       "    " + form_.kernel + " kernel;\n" + members;
    if (!form_.first.empty())
      text +=
          "    if constexpr (!in_lanes)\n      if (alpha >= 1.0) {\n        kernel.first();\n      "
          "  "
          "return kernel.result();\n      }\n";
    for (int s = 1; s < stages_.count; ++s) text += fmt::format("    kernel.stage_{}();\n", s);
    return text + "    return kernel.result();\n  }\n";
  }

  const KernelForm& form_;
  const Program& program_;
  Stages stages_;
  KernelPrinter printer_;
  std::set<int> carried_;
};

}  // namespace

std::string emit_kernel(const Kernel& kernel) { return KernelEmitter(kernel).run(); }

}  // namespace magicmass::codegen
