// SPDX-License-Identifier: GPL-2.0-or-later
// The header of a quantity: its cases between its structures and the choice among them.
#include "codegen/emit.hpp"

namespace codegen {
namespace {
std::string structure(const std::string& name, const Words& members) {
  return "struct " + name + " {\n" + joined(members, "\n") + "\n};\n";
}
/// In their order, as many as stand beside each other on a line.
Words members(const std::vector<Output>& all, const std::string& before, const std::string& star) {
  Words lines;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string name = star + all[k].name;
    if (k > 0 && all[k].is_whole == all[k - 1].is_whole)
      lines.back().insert(lines.back().size() - 1, ", " + name);
    else
      lines.push_back(fields(before + (all[k].is_whole ? "std::int64_t" : "double"), {name}));
  }
  return lines;
}
/// Inputs, outputs, and columns of both.
std::string structures(const Quantity& q) {
  const std::string Q = capital(q.name);
  const std::vector<Output> out = outputs_of(q.cases[0]);
  std::vector<Output> in;
  Words values;
  std::string set;
  for (const Input& i : q.inputs) {
    in.push_back({i.name(), i.is_whole()});
    values.push_back(i.name() + "[row]");
  }
  for (const Output& o : out) set += "    " + o.name + "[row] = out." + o.name + ";\n";
  const std::string values_of =
      structure(Q + "Inputs", members(in, "", "")) + structure(Q + "Outputs", members(out, "", ""));
  if (!q.has_arrays) return values_of;
  Words columns = members(in, "const ", "*");
  const Words pointers = members(out, "", "*");
  columns.insert(columns.end(), pointers.begin(), pointers.end());
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
    visits += "    if (" + condition(q, c) + ")\n      return f.template operator()<" + Q +
              capital(c.name) + ">();\n";
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
      "\nnamespace magicmass::generated::inline MAGICMASS_TARGET {\n"
      "using namespace arithmetic;\n" +
      structures(q) + e.header + "/// What its callers need to know of " + q.name + ".\nstruct " +
      Q + " {\n  using Inputs = " + Q + "Inputs;\n  using Outputs = " + Q + "Outputs;\n" +
      of_arrays +
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
