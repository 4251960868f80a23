// SPDX-License-Identifier: GPL-2.0-or-later
// The header of a quantity: its cases between its structures and the choice among them.
#include "codegen/emit.hpp"
#include "codegen/text.hpp"

namespace codegen {
namespace {
std::string structure(const std::string& name, const Words& members) {
  return "struct " + name + " {\n" + joined(members, "\n") + "\n};\n";
}
/// Inputs, outputs, and columns of both.
std::string structures(const Quantity& q) {
  const std::string Q = capital(q.name);
  Words inputs, outputs, columns, values;
  std::string set;
  for (const Input& i : q.inputs) {
    const std::string type = i.is_whole() ? "std::int64_t" : "double";
    inputs.push_back(fields(type, {i.name()}));
    columns.push_back(fields("const " + type + "*", {i.name()}));
    values.push_back(i.name() + "[row]");
  }
  for (const Output& o : outputs_of(q.cases[0])) {
    const std::string type = o.is_whole ? "std::int64_t" : "double";
    outputs.push_back(fields(type, {o.name}));
    columns.push_back(fields(type + "*", {o.name}));
    set += "    " + o.name + "[row] = out." + o.name + ";\n";
  }
  const std::string values_of = structure(Q + "Inputs", inputs) + structure(Q + "Outputs", outputs);
  if (!q.has_arrays) return values_of;
  columns.push_back(inlined + Q + "Inputs get(std::size_t row) const { return {" +
                    joined(values, ", ") + "}; }");
  columns.push_back(inlined + "void set(std::size_t row, const " + Q + "Outputs& out) const {\n" +
                    set + "  }");
  return values_of + structure(Q + "Columns", columns);
}
}  // namespace

Emitted emit_evaluator(const Quantity& q, const Ids& ids) {
  check_outputs(q);
  const std::string Q = capital(q.name);
  Emitted e{"evaluators/" + q.name + ".hpp", "", {}};
  std::string visits;
  std::vector<Words> bounds;
  for (const Case& c : q.cases) {
    bounds.push_back(emit_case(q, c, e));
    visits += "    if (" + condition(q, c) + ") {\n      return f.template operator()<" + Q +
              capital(c.name) + ">();\n    }\n";
  }
  const std::string of_arrays =
      !q.has_arrays ? ""
                    : "  using Columns = " + Q +
                          "Columns;\n  template <class Tier, class N>\n  using Main = " + Q +
                          capital(q.cases[0].name) + "<Tier, N>;\n";
  e.header = broken(
      opening("// " + q.name + " in DoubleDouble, from " + q.labels +
                  ". Bounds: errors.txt beside this file.\n// Only for rows whose inputs are in "
                  "a case and whose doubt is 0; all others are left to the caller.",
              {"<cstddef>", "<cstdint>", "", "\"magicmass/arithmetic/functions.hpp\"",
               "\"magicmass/arithmetic/rounding_test.hpp\"",
               "\"magicmass/evaluators/polynomials.hpp\""}) +
      "\nnamespace magicmass::generated::inline MAGICMASS_TARGET {\n" + structures(q) + e.header +
      "/// What its callers need to know of " + q.name + ".\nstruct " + Q +
      " {\n  using Inputs = " + Q + "Inputs;\n  using Outputs = " + Q + "Outputs;\n" + of_arrays +
      "  /// f.operator()<Case>() of the case that holds the inputs, or 1: a doubt. The domain\n"
      "  /// is that of doubles, or (wide) of a number type without over- and underflow.\n"
      "  template <bool is_wide, class F>\n"
      "  [[gnu::always_inline]] static double visit(const Inputs& in, F f) {\n" +
      visits +
      "    return 1.0;\n  }\n};\n"
      "}  // namespace magicmass::generated::inline MAGICMASS_TARGET\n");
  e.manifest = {manifest_entry(q, "evaluator", e.path, ids, bounds)};
  return e;
}
}  // namespace codegen
