// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "codegen/emit.hpp"

namespace magicmass::codegen {
namespace {

struct Table {
  std::string quantity;
  std::string entry;      // "VelocityEvaluator"
  std::string table;      // "velocity_table"
  std::string function;   // "velocity_evaluators"
  std::string signature;  // of the function pointer, with %RESULT%
};

const std::vector<Table>& tables() {
  static const std::vector<Table> all{
      {"angle", "AngleEvaluator", "angle_table", "angle_evaluators",
       "Real (*evaluate)(Real alpha)"},
      {"collapse", "CollapseEvaluator", "collapse_table", "collapse_evaluators",
       "Real (*evaluate)(Real alpha, Real e)"},
      {"encounters", "EncounterEvaluator", "encounter_table", "encounter_evaluators",
       "Encounters<Real> (*evaluate)(Real alpha, std::int64_t j)"},
      {"ratios", "RatioEvaluator", "ratio_table", "ratio_evaluators",
       "Ratios<Real> (*evaluate)(std::int64_t k)"},
      {"terminal", "TerminalEvaluator", "terminal_table", "terminal_evaluators",
       "TerminalValues<Real> (*evaluate)(Real alpha, Real e, std::int64_t k)"},
      {"two_collisions", "TwoCollisionsEvaluator", "two_collisions_table",
       "two_collisions_evaluators", "TerminalValues<Real> (*evaluate)(Real alpha, Real e)"},
      {"velocities", "VelocityEvaluator", "velocity_table", "velocity_evaluators",
       "Velocities<Real> (*evaluate)(Real alpha, std::int64_t n)"},
  };
  return all;
}

/// "terminal_speed" as part of a type's name: "TerminalSpeed".
std::string capitalised(const std::string& words) {
  std::string name;
  bool is_first = true;
  for (const char character : words) {
    if (character != '_')
      name += is_first ? static_cast<char>(std::toupper(static_cast<unsigned char>(character)))
                       : character;
    is_first = character == '_';
  }
  return name;
}

// A quantity that nobody has named a table for.
Table table_for(const Form& form) {
  std::string parameters;
  if (!form.real_input.empty()) parameters += "Real " + form.real_input;
  if (!form.index.empty())
    parameters += (parameters.empty() ? "" : ", ") + ("std::int64_t " + form.index);
  const std::string result = form.result.empty() ? "Real" : form.result + "<Real>";
  return {form.quantity, capitalised(form.quantity) + "Evaluator", form.quantity + "_table",
          form.quantity + "_evaluators", result + " (*evaluate)(" + parameters + ")"};
}

std::vector<Table> tables_for(const std::vector<Evaluator>& evaluators) {
  std::vector<Table> all = tables();
  for (const Evaluator& evaluator : evaluators) {
    const Form& form = evaluator.form;
    const bool has_table = std::any_of(all.begin(), all.end(), [&](const Table& table) {
      return table.quantity == form.quantity;
    });
    if (!form.exact && !has_table) all.push_back(table_for(form));
  }
  return all;
}

// "alpha,n" of "Velocities<Real> (*evaluate)(Real alpha, std::int64_t n)".
std::string inputs_of(const std::string& signature) {
  std::string names;
  std::string parameters = signature.substr(signature.rfind('(') + 1);
  parameters.back() = ',';
  for (std::size_t from = 0; from < parameters.size();) {
    const std::size_t end = parameters.find(',', from);
    const std::size_t name = parameters.rfind(' ', end) + 1;
    names += (names.empty() ? "" : ",") + parameters.substr(name, end - name);
    from = end + 1;
  }
  return names;
}

std::string outputs_of(const std::string& quantity, const std::vector<Evaluator>& evaluators) {
  for (const Evaluator& evaluator : evaluators) {
    if (evaluator.form.quantity != quantity) continue;
    std::string names;
    for (const auto& [name, theorem] : evaluator.form.outputs)
      names += (names.empty() ? "" : ",") + name;
    return names;
  }
  return "";
}

// A function that calls a visitor with each table, so that a new quantity is met by those who know none.
std::string visit(const std::vector<Table>& tables, const std::vector<Evaluator>& evaluators) {
  std::string text =
      "\n/// Calls `visitor.operator()<table>(quantity, outputs, inputs)` for each table.\n"
      "template <class Real, class Visitor>\nconstexpr void visit_tables(Visitor&& visitor) {\n";
  for (const Table& table : tables)
    text += "  visitor.template operator()<" + table.table + "<Real>>(\"" + table.quantity +
            "\", \"" + outputs_of(table.quantity, evaluators) + "\", \"" +
            inputs_of(table.signature) + "\");\n";
  return text + "}\n";
}

std::string bound(double value) {
  return value == no_bound ? "no_bound" : fmt::format("{}", value);
}

}  // namespace

std::string emit_registry(const std::vector<Evaluator>& evaluators) {
  std::string text =
      file_header("Tables of the evaluators, for tests and reports that treat all alike");
  text +=
      "\n#include <array>\n#include <cstdint>\n#include <limits>\n\n#include "
      "\"magicmass/quantities.hpp\"\n";
  for (const Evaluator& evaluator : evaluators)
    if (!evaluator.form.exact) text += "#include \"" + evaluator.form.header() + "\"\n";
  text +=
      "\nnamespace magicmass::generated {\n\n"
      "/// In a table: the largest error that a form promises, in ulp of the exact value or in eps "
      "of the\n"
      "/// largest such value of the body at that alpha <= 1; infinity where it promises none.\n"
      "inline constexpr double no_bound = std::numeric_limits<double>::infinity();\n";
  const std::vector<Table> tables = tables_for(evaluators);
  for (const Table& table : tables) {
    std::string rows;
    int count = 0;
    for (const Evaluator& evaluator : evaluators) {
      const Form& form = evaluator.form;
      if (form.exact || form.quantity != table.quantity) continue;
      rows += "    {\"" + form.function() + "\", \"" + form.name + "\", &" + form.function() +
              "<Real>, " + bound(form.bound.ulp) + ", " + bound(form.bound.eps) + "},\n";
      ++count;
    }
    text += "\n/// A row of " + table.function + "().\ntemplate <class Real>\nstruct " +
            table.entry +
            " {\n  const char* name;  ///< the function's\n  const char* form;  ///< its last "
            "word\n  " +
            table.signature +
            ";  ///< the function\n  double ulp_bound;  ///< as no_bound says\n"
            "  double eps_bound;  ///< as no_bound says\n};\n";
    text += "\n/// The table behind " + table.function +
            "().\ntemplate <class Real>\ninline constexpr std::array<" + table.entry + "<Real>, " +
            std::to_string(count) + "> " + table.table + "{{\n" + rows + "}};\n";
    text += "\n/// Every evaluator of the quantity '" + table.quantity +
            "'.\ntemplate <class Real>\nconstexpr const auto& " + table.function +
            "() {\n  return " + table.table + "<Real>;\n}\n";
  }
  return text + visit(tables, evaluators) + "\n}  // namespace magicmass::generated\n";
}

}  // namespace magicmass::codegen
