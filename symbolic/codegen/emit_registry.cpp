// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

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
      {"encounters", "EncounterEvaluator", "encounter_table", "encounter_evaluators",
       "Encounters<Real> (*evaluate)(Real alpha, std::int64_t j)"},
      {"ratios", "RatioEvaluator", "ratio_table", "ratio_evaluators",
       "Ratios<Real> (*evaluate)(std::int64_t k)"},
      {"velocities", "VelocityEvaluator", "velocity_table", "velocity_evaluators",
       "Velocities<Real> (*evaluate)(Real alpha, std::int64_t n)"},
  };
  return all;
}

bool is_in_a_table(const Form& form) {
  return !form.exact && std::any_of(tables().begin(), tables().end(), [&](const Table& table) {
    return table.quantity == form.quantity;
  });
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
    if (is_in_a_table(evaluator.form)) text += "#include \"" + evaluator.form.header() + "\"\n";
  text +=
      "\nnamespace magicmass::generated {\n\n"
      "// In a table: the largest error that a form promises, in ulp of the exact value or in eps "
      "of the\n"
      "// largest such value of the body at that alpha <= 1; infinity where it promises none.\n"
      "inline constexpr double no_bound = std::numeric_limits<double>::infinity();\n";
  for (const Table& table : tables()) {
    std::string rows;
    int count = 0;
    for (const Evaluator& evaluator : evaluators) {
      const Form& form = evaluator.form;
      if (form.exact || form.quantity != table.quantity) continue;
      rows += "    {\"" + form.function() + "\", \"" + form.name + "\", &" + form.function() +
              "<Real>, " + bound(form.bound.ulp) + ", " + bound(form.bound.eps) + "},\n";
      ++count;
    }
    text += "\ntemplate <class Real>\nstruct " + table.entry +
            " {\n  const char* name;\n  const char* form;\n  " + table.signature +
            ";\n  double ulp_bound;\n  double eps_bound;\n};\n";
    text += "\ntemplate <class Real>\ninline constexpr std::array<" + table.entry + "<Real>, " +
            std::to_string(count) + "> " + table.table + "{{\n" + rows + "}};\n";
    text += "\ntemplate <class Real>\nconstexpr const auto& " + table.function + "() {\n  return " +
            table.table + "<Real>;\n}\n";
  }
  return text + "\n}  // namespace magicmass::generated\n";
}

}  // namespace magicmass::codegen
