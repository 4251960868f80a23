// SPDX-License-Identifier: GPL-2.0-or-later
// A quantity's header: inputs, outputs, columns, its cases, and which case a row belongs to.
#include "codegen/emit_evaluator.hpp"

#include "codegen/emit_case.hpp"
#include "codegen/text.hpp"

namespace codegen {
namespace {
struct Field {
  std::string type, name;
};
std::string structure(const std::string& name, const std::vector<Field>& fields) {
  std::string s = "struct " + name + " {\n";
  for (const Field& f : fields) s += "  " + f.type + " " + f.name + ";\n";
  return s + "};\n";
}
}  // namespace

Evaluator emit_evaluator(const Quantity& q, const Ids& ids) {
  if (q.cases.empty()) throw Refused(q.name + " has no case");
  std::vector<EmittedCase> cases;
  for (const Case& c : q.cases) cases.push_back(emit_case(q, c));
  const EmittedCase& main = cases[0];
  for (const EmittedCase& c : cases) {
    check_outputs(q, main.whole, c.whole);
    check_outputs(q, main.real, c.real);
  }

  const std::string Q = capital(q.name);
  std::vector<Field> inputs;
  std::vector<Field> outputs;
  std::vector<Field> columns;
  std::vector<std::string> in_names;
  for (const Input& i : q.inputs) {
    const bool is_whole = i.is_whole();
    const std::string type = is_whole ? "std::int64_t" : "double";
    const std::string name = i.name();
    inputs.push_back({type, name});
    columns.push_back({"const " + type + "*", name});
    in_names.push_back(name + "[row]");
  }
  for (const std::string& name : main.whole) outputs.push_back({"std::int64_t", name});
  for (const std::string& name : main.real) outputs.push_back({"double", name});
  std::string set;
  for (const Field& f : outputs) {
    columns.push_back({f.type + "*", f.name});
    set += "    " + f.name + "[row] = out." + f.name + ";\n";
  }

  Text t;
  t.block(opening(
      "// " + q.name + " in DoubleDouble, from " + q.labels +
          ". Bounds: errors.txt beside this file.\n// Only for rows whose inputs are in "
          "a case and whose doubt is 0; all others are left to the caller.",
      {"<cstddef>", "<cstdint>", "", "\"magicmass/arithmetic/functions.hpp\"",
       "\"magicmass/arithmetic/rounding_test.hpp\"", "\"magicmass/evaluators/polynomials.hpp\""}));
  t.line("");
  t.line("namespace magicmass::generated::inline MAGICMASS_TARGET {");
  t.block(structure(Q + "Inputs", inputs));
  t.block(structure(Q + "Outputs", outputs));
  std::string s = structure(Q + "Columns", columns);
  s = s.substr(0, s.size() - 3);
  s += "  [[gnu::always_inline]] " + Q + "Inputs get(std::size_t row) const {\n    return {" +
       joined(in_names, ", ") +
       "};\n  }\n  [[gnu::always_inline]] void set(std::size_t row, const " + Q +
       "Outputs& out) const {\n" + set + "  }\n};\n";
  t.block(s);
  Evaluator e;
  std::string visits;
  std::vector<Claim> claims;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const std::string name = Q + capital(q.cases[k].name);
    t.block(cases[k].code);
    e.errors += cases[k].errors;
    visits += "    if (" + condition(q, q.cases[k]) + ") {\n      return f.template operator()<" +
              name + ">();\n    }\n";
    claims.push_back({q.cases[k].name, domain_in_words(q, q.cases[k]), cases[k].bounds,
                      ids_of(q.cases[k], ids)});
  }
  t.block(
      "/// What loops over rows need to know of " + q.name + ".\nstruct " + Q +
      " {\n  using Inputs = " + Q + "Inputs;\n  using Outputs = " + Q +
      "Outputs;\n  using Columns = " + Q + "Columns;\n  template <class Tier, class N>\n" +
      "  using Main = " + Q + capital(q.cases[0].name) + "<Tier, N>;\n" +
      "  /// f.operator()<Case>() of the case that holds the inputs, or 1: a doubt. The domain\n" +
      "  /// is that of doubles, or (wide) of a number type without over- and underflow.\n" +
      "  template <bool is_wide, class F>\n" +
      "  [[gnu::always_inline]] static double visit(const Inputs& in, F f) {\n" + visits +
      "    return 1.0;\n  }\n};\n");
  t.line("}  // namespace magicmass::generated::inline MAGICMASS_TARGET");
  e.header = t.str();
  std::vector<std::string> names = main.whole;
  names.insert(names.end(), main.real.begin(), main.real.end());
  e.manifest = manifest_entry(q, "evaluator", "evaluators/" + q.name + ".hpp", names, claims);
  return e;
}
}  // namespace codegen
