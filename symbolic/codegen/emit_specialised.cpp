// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <set>

#include "codegen/expression.hpp"
#include "codegen/kernel_expression.hpp"
#include "codegen/specialised_kernel.hpp"

namespace magicmass::codegen {
namespace {

// The program of a kernel as straight lines for one number. Where the kernel has theorems for alpha from 1 on, what they replace
// is set by cases: the root and what follows from it, the sine and the cosine.
class StraightLines {
public:
  explicit StraightLines(const Kernel& kernel)
      : form_(kernel.form),
        program_(kernel.program),
        printer_(program_, stages_of(program_, false), form_.numbers) {
    for (const Output& output : program_.outputs) need(output.node);
  }

  std::string run() const {
    const int end = static_cast<int>(program_.nodes.size());
    std::string text;
    if (form_.first.empty()) {
      text = defined(0, end, "  ", {});
    } else {
      const int after_psi = end_of_psi();
      std::set<int> by_cases = needed_;
      std::erase_if(by_cases, [this](int number) { return is_of_psi(number); });
      for (int number = 0; number < end; ++number)
        if (node(number).op == Op::reciprocal_square_root) by_cases.insert(number);
      std::string declared;
      for (const int number : by_cases)
        declared += (declared.empty() ? "  Number " : ", ") + printer_.name(number);
      text = wrapped_line(declared + ";") + defined(0, after_psi, "  ", by_cases) +
             "  if (alpha < Real(1.0)) {\n" + defined(after_psi, end, "    ", by_cases) +
             "  } else {  // the first collisions are all there are\n" + from_one(by_cases) +
             "  }\n";
      for (int number = 0; number < end; ++number)
        if (printer_.is_kept(number) && !is_turn(node(number)) && follows_turn(number))
          text += definition(number, "  const Number ");
    }
    text += "  return {\n";
    for (const Output& output : program_.outputs)
      text += wrapped_line("      ." + output.name + " = " + printer_.value(output.node) + ",");
    return text + "  };\n";
  }

private:
  const Node& node(int number) const { return program_.nodes[static_cast<std::size_t>(number)]; }
  static bool is_turn(const Node& made) { return made.op == Op::sine || made.op == Op::cosine; }

  template <class Condition>
  bool follows(int number, const Condition& condition) const {
    const Node& made = node(number);
    return condition(made) || std::any_of(made.args.begin(), made.args.end(), [&](int argument) {
             return follows(argument, condition);
           });
  }
  bool follows_turn(int number) const { return follows(number, is_turn); }
  // psi, which an output may be, is that of the root whatever alpha is.
  bool is_of_psi(int number) const {
    return !follows_turn(number) && follows(number, [](const Node& made) {
      return made.op == Op::arctangent || made.op == Op::half_arcsecant;
    });
  }
  int end_of_psi() const {
    int end = 0;
    for (const int number : needed_)
      if (is_of_psi(number)) end = std::max(end, number + 1);
    return end;
  }

  // The sine, the cosine and what the outputs use besides.
  void need(int number) {
    if (printer_.is_kept(number) && (is_turn(node(number)) || !follows_turn(number))) {
      needed_.insert(number);
      return;
    }
    for (const int argument : node(number).args) need(argument);
  }

  std::string definition(int number, const std::string& before) const {
    const std::string indent = before.substr(0, before.find_first_not_of(' '));
    const std::string origin = node(number).origin.empty() ? "" : ", step " + node(number).origin;
    return wrapped_line(indent + "// " + printer_.name(number) + " = " + formula(program_, number) +
                        origin) +
           wrapped_line(before + printer_.name(number) + " = " + printer_.right_side(number) + ";");
  }

  // The named values from one node to another; what is set by cases is declared already, and what follows the
  // turn comes after it.
  std::string defined(int from, int to, const std::string& indent,
                      const std::set<int>& by_cases) const {
    std::string text;
    std::set<int> done;
    for (int number = from; number < to; ++number) {
      if (!printer_.is_kept(number) || done.contains(number)) continue;
      if (is_turn(node(number)))
        text += turned(number, indent, by_cases, done);
      else if (by_cases.empty() || !follows_turn(number))
        text += definition(number, indent + (by_cases.contains(number) ? "" : "const Number "));
    }
    return text;
  }

  // A sine and a cosine of one angle together.
  std::string turned(int number, const std::string& indent, const std::set<int>& by_cases,
                     std::set<int>& done) const {
    const std::string pair = "turned_to_" + printer_.name(number);
    std::string text =
        wrapped_line(indent + "const auto " + pair + " = " + printer_.right_side(number) + ";");
    for (int other = number; other < static_cast<int>(program_.nodes.size()); ++other) {
      if (!is_turn(node(other)) || node(other).args != node(number).args) continue;
      done.insert(other);
      text +=
          wrapped_line(indent + "// " + printer_.name(other) + " = " + formula(program_, other));
      text += indent + (by_cases.contains(other) ? "" : "const Number ") + printer_.name(other) +
              " = " + pair + (node(other).op == Op::sine ? ".sine" : ".cosine") + ";\n";
    }
    return text;
  }

  std::string from_one(const std::set<int>& by_cases) const {
    std::string text;
    for (const int number : by_cases) {
      const Node& made = node(number);
      const std::string value = made.op == Op::reciprocal_square_root
                                    ? "reciprocal(Number::sum(Real(1.0), alpha))"
                                : made.op == Op::sine   ? form_.first_sine()
                                : made.op == Op::cosine ? form_.first_cosine()
                                                        : printer_.right_side(number);
      text += wrapped_line("    " + printer_.name(number) + " = " + value + ";");
    }
    return text;
  }

  const KernelForm& form_;
  const Program& program_;
  KernelPrinter printer_;
  std::set<int> needed_;
};

std::string listed(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

std::string documentation(const Specialised& made, const Kernel& kernel) {
  std::vector<std::string> from;
  for (const auto& [name, theorem] : kernel.form.outputs) from.push_back(theorem);
  std::string text = wrapped_line("// Domain: " + kernel.form.domain +
                                  (made.has("psi") ? "; alpha at most 2^400" : "") + ".") +
                     wrapped_line("// From: " + listed(from) + ".");
  if (!kernel.form.bindings.empty())
    text += wrapped_line("// With: " + listed(kernel.form.bindings) + ".");
  if (!kernel.form.first.empty())
    text += wrapped_line("// From alpha = 1 on: " + listed(kernel.form.first) + ".");
  text += wrapped_line("// Cost: " + codegen::to_text(operation_counts(kernel.program)) + ".");
  const bool is_ratio = made.group[0].kernel == "ratios";
  return text +
         wrapped_line(
             std::string("// Error: that of Number; with the type that `evaluate` has, at most ") +
             (is_ratio ? "1 ulp." : "4 max(1/2, cond/2) ulp, where cond = |alpha y'/y|."));
}

// The quantities as members of a struct.
std::string members(const Specialised& made, const std::string& type, bool with_counts) {
  std::string text;
  for (const PaperQuantity& quantity : made.group) {
    const bool is_count = quantity.member.empty();
    if (is_count && !with_counts) continue;
    text += wrapped_line("  " + (is_count ? "std::int64_t" : type) + " " + quantity.name +
                         ";  // " + quantity.words);
  }
  return text;
}

std::string in_any_number(const Specialised& made, const Kernel& kernel) {
  std::vector<std::string> parameters;
  for (const std::string& input : kernel.form.reals)
    parameters.push_back("typename Number::Real " + input);
  for (const std::string& input : kernel.form.integers)
    parameters.push_back("typename Number::Real " + input);
  return "// Numbers of a type of magicmass/arithmetic.\ntemplate <class Number>\nstruct Outputs "
         "{\n" +
         members(made, "Number", false) + "};\n\n" + documentation(made, kernel) +
         wrapped_line("template <class Number>\nOutputs<Number> evaluate_in(" + listed(parameters) +
                      ") {") +
         "  using Real = typename Number::Real;\n" + StraightLines(kernel).run() + "}\n\n";
}

// Pairs are enough but for angles that go up to pi, and for psi from alpha = 1 on.
std::string number_type(const Specialised& made) {
  const std::string& kernel = made.group[0].kernel;
  const bool in_pairs = (kernel == "velocities" || kernel == "terminal") && !made.has("psi");
  return std::string("arithmetic::") + (in_pairs ? "Pair" : "Tracked") + "<double>";
}

// From doubles and whole numbers to doubles.
std::string in_doubles(const Specialised& made) {
  const bool counts = made.group[0].kernel == "terminal";
  std::string parameters, arguments;
  const auto pass = [&](const std::string& parameter, const std::string& argument) {
    if (!parameter.empty()) parameters += (parameters.empty() ? "" : ", ") + parameter;
    arguments += (arguments.empty() ? "" : ", ") + argument;
  };
  for (const Kernel& kernel : made.kernel) {
    for (const std::string& input : kernel.form.reals) pass("double " + input, input);
    for (const std::string& input : kernel.form.integers) {
      if (input == "turn")  // 1 - 2 (N_A - N_B)
        pass("", "counts->N_B == counts->N_A ? 1.0 : -1.0");
      else
        pass(counts ? "" : "std::int64_t " + input,
             "static_cast<double>(" + (counts ? "counts->" + input : input) + ")");
    }
  }
  if (made.kernel.empty()) parameters = "double alpha";
  std::string text = "struct Answer {\n" + members(made, "double", true) + "};\n\n";
  const bool needs_cycles = counts && !made.kernel.empty();
  if (counts)
    text += "// For any positive finite alpha, else InvalidInput; none where " +
            std::string(needs_cycles ? "N_A is more than 2^51" : "a count does not fit 64 bits") +
            ". The counts are exact:\n// from counting.N_A and counting.N_B, decided by "
            "count_collisions.\n";
  text += std::string("inline ") + (counts ? "std::optional<Answer>" : "Answer") + " evaluate(" +
          parameters + ") {\n";
  if (counts)
    text += "  const std::optional<Counts> counts = count_collisions(alpha);\n  if (!counts" +
            std::string(needs_cycles ? " || counts->N_A > std::int64_t{1} << 51U" : "") +
            ") return std::nullopt;\n";
  if (!made.kernel.empty())
    text += wrapped_line("  const auto all = evaluate_in<" + number_type(made) + ">(" + arguments +
                         ");");
  text += counts ? "  return Answer{\n" : "  return {\n";
  for (const PaperQuantity& quantity : made.group)
    text += "      ." + quantity.name + " = " +
            (quantity.member.empty() ? "counts->" + quantity.name
                                     : "rounded(all." + quantity.name + ")") +
            ",\n";
  return text + "  };\n}\n";
}

}  // namespace

std::string emit_specialised(const Specialised& made) {
  // what an instruction set changes is its own function; counts are the library's
  const bool is_for_target = !made.kernel.empty();
  std::string text = "namespace " + made.name() + " {\n";
  if (is_for_target) text += "inline namespace MAGICMASS_TARGET {\n";
  text += "\n";
  for (const Kernel& kernel : made.kernel) text += in_any_number(made, kernel);
  text += in_doubles(made) + "\n";
  if (is_for_target) text += "}  // namespace MAGICMASS_TARGET\n";
  return text + "}  // namespace " + made.name() + "\n";
}

}  // namespace magicmass::codegen
