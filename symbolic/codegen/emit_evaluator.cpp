// A quantity's header: structures, cases (bounds of all tiers, members, stages, tests), choice.
#include <algorithm>

#include "codegen/emit.hpp"
#include "codegen/errors.hpp"

namespace codegen {
namespace {
const std::string inlined = "  [[gnu::always_inline]] ";
/// "  double a, b;"
std::string fields(const std::string& type, const Words& names) {
  return "  " + type + " " + joined(names, ", ") + ";";
}
/// Both ends as C++, with what stands between them; a wide domain's where that is so.
std::string range_in_code(Interval r, Interval wide, const std::string& is_wide,
                          const std::string& between) {
  const auto end = [&](double narrow, double wide_end) {
    if (narrow == wide_end) return hex(narrow);
    return "(" + is_wide + " ? " + hex(wide_end) + " : " + hex(narrow) + ")";
  };
  return end(r.low, wide.low) + between + end(r.high, wide.high);
}

class CaseEmitter {
public:
  Words outputs;  // Accurate's bounds of those, in words

  CaseEmitter(const Quantity& quantity, const Case& which, Emitted& emitted)
      : q(quantity), c(which), result(emitted), p(lower(quantity, which, Numbers::doubles)) {
    name = capital(q.name) + capital(c.name);
    bounds();
    structure();
  }

private:
  const Quantity& q;
  const Case& c;
  Emitted& result;
  Program p;
  std::string name;
  Analysis accurate;
  Words bounds_of;        // outputs and signs, as C++
  Words rows = Words(4);  // constants of those, as Tier::number says
  std::size_t width = 0;  // of a row

  bool is_tested(const Result& r) const { return r.kind != Result::real || q.is_tested; }
  void line(const std::string& code) { result.header += code + "\n"; }

  void bounds() {
    Plan plan;
    constexpr double u = 0x1p-53;
    // Accurate first: it makes the plan. Ziv's bounds are reckoned at u = 2^-180, and are in units.
    const NumberType types[] = {
        {u, &tiers()[1]}, {u, &tiers()[0]}, {u, &tiers()[2]}, {0x1p-180, nullptr}};
    for (const NumberType& t : types) {
      const bool is_wide = !t.is_pair();
      const Program program = is_wide ? lower(q, c, Numbers::wide) : p;
      Analysis a = analyse(program, t, plan);
      describe(program, t, a);
      std::vector<double> constants;
      Words here;
      for (std::size_t i = 0; i < a.outputs.size(); ++i) {
        if (!is_tested(p.results[i])) a.outputs[i].clear();
        here.push_back(in_code(program, a.outputs[i], constants));
      }
      if (t.name() == "Accurate") {
        accurate = a;
        bounds_of = here;
        width = constants.size();
      }
      if (bounds_of != here)
        throw Refused("bounds of " + name + " differ in form for " + t.name() + ": " +
                      joined(here, "; "));
      Words row;
      for (double x : constants) row.push_back(hex(is_wide ? x / t.u : x));
      rows[is_wide ? 3 : std::size_t(t.tier - &tiers()[0])] = "{" + joined(row, ", ") + "}";
    }
  }
  void describe(const Program& program, const NumberType& t, const Analysis& a) {
    std::string& e = result.errors;
    e += "\n" + name + ", " + t.name() + "\n";
    for (const std::string& step : a.steps) e += "  " + step + "\n";
    for (std::size_t i = 0; i < a.outputs.size(); ++i) {
      const Result& r = p.results[i];
      if (r.kind == Result::guard) continue;
      const std::string bound = r.name + ": " + in_words(program, a.outputs[i]);
      const bool is_output = r.kind == Result::real || r.kind == Result::whole;
      e += (is_output ? "  OUTPUT " : "  SIGN ") + bound + "\n";
      if (is_output && t.name() == "Accurate") outputs.push_back(bound);
    }
  }

  /// Nodes that a later stage takes.
  std::set<int> members() const {
    std::set<int> found;
    const auto keep = [&](int k, int stage) {
      if (p[k].name.starts_with('-')) k = p[k].of[0];
      const Op op = p[k].op;
      if (p[k].stage < stage && op != Op::input && op != Op::constant) found.insert(k);
    };
    for (const Node& n : p.nodes)
      for (int o : n.of) keep(o, n.stage);
    for (const Form& f : accurate.outputs)
      for (const auto& [sizes, k] : f)
        for (int v : sizes) keep(v, 3);
    for (const Result& r : p.results) keep(r.node, r.kind == Result::whole ? 4 : 3);
    return found;
  }

  void structure() {
    Words theorems;
    for (const Theorem& t : c.outputs) theorems.push_back(shown(q, t.conclusion()));
    result.header += "/// " + q.name + ", " + c.name + ": " + domain_in_words(q, c) +
                     ". Theorems: " + joined(theorems, "; ") + ". ";
    std::map<std::string, Words> facts;  // by what they rest on
    for (const Fact& f : c.facts) {
      const std::string computed = f.of_computed.empty() ? "" : "; and: " + f.of_computed;
      facts[f.argument + computed].push_back(shown(q, f.formula));
    }
    for (const auto& [why, formulas] : facts)
      result.header += joined(formulas, ", ") + ": " + why + ". ";
    line("Operations: " + operation_counts(p) + ".");
    line("template <class Tier, class N> struct " + name + " {\n  using T = typename N::Value;");
    const std::set<int> kept = members();
    Words exact, numbers, results{"doubt{}"};
    for (const Input& i : q.inputs) exact.push_back(i.name());
    for (int k : kept) (p[k].is_exact ? exact : numbers).push_back(p[k].name);
    for (const Result& r : p.results)
      if (r.kind == Result::real) results.push_back(r.name);
    line(fields("T", exact));
    line(fields("typename N::Result", results));
    if (!numbers.empty()) line(fields("N", numbers));
    if (width > 0) {
      line("  static constexpr double bounds[4][" + std::to_string(width) + "] = {" +
           joined(rows, ", ") + "};\n  static constexpr const double* E = bounds[Tier::number];");
    }
    inputs_and_outputs();
    for (int stage = 1; stage <= 3; ++stage) stage_function(stage, kept);
    line("};");
  }
  /// A row's; and rows of arrays, a register at a time, where the quantity has them.
  void inputs_and_outputs() {
    const std::string Q = capital(q.name);
    Words set, values;
    std::string loads, in_case;
    for (const Input& i : q.inputs) {
      const std::string x = i.name();
      const Interval r = range_of(i, c, false);
      const std::string load = std::string("load<") + (i.is_whole() ? "SimdMask" : "Simd") +
                               ">(columns." + x + " + row)";
      set.push_back(x + (i.is_whole() ? "(N::whole(in." : "(N::all(in.") + x + "))");
      loads += "    " + x + " = " + (i.is_whole() ? "to_real(" + load + ")" : load) + ";\n";
      in_case += " & (" + x + " >= " + hex(r.low) + ") & (" + x + " <= " + hex(r.high) + ")";
      if (i.is_whole()) in_case += " & (to_whole(" + x + ") == " + load + ")";
    }
    for (const Result& r : p.results) {
      const bool is_whole = r.kind == Result::whole;
      if (!is_whole && r.kind != Result::real) continue;
      values.push_back(is_whole ? "N::to_whole(" + as_plain(p, r.node) + ")" : r.name);
    }
    line(inlined + "explicit " + name + "(const " + Q + "Inputs& in) : " + joined(set, ", ") +
         " {}");
    line(inlined + Q + "Outputs outputs() const { return {" + joined(values, ", ") + "}; }");
    if (!q.has_arrays || &c != &q.cases[0]) return;
    result.header += "  " + name + "() = default;\n" + inlined + "SimdMask load_inputs(const " + Q +
                     "Columns& columns, std::size_t row) {\n" + loads + "    return " +
                     in_case.substr(3) + ";\n  }\n";
  }
  void stage_function(int stage, const std::set<int>& kept) {
    line(inlined + "void stage_" + std::to_string(stage) + "() {");
    std::set<int> paired;
    for (int k = 0; k < p.size(); ++k) {
      const Node& n = p[k];
      const bool has_line = n.op != Op::input && n.op != Op::constant && n.name[0] != '-';
      if (n.stage != stage || !has_line) continue;
      const bool is_function = n.op == Op::sine || n.op == Op::cosine;
      if (is_function && paired.insert(n.of[0]).second) line("    " + sine_and_cosine(p, n));
      const std::string type = kept.count(k) > 0 ? "" : n.is_exact ? "const T " : "const N ";
      result.header +=
          commented("    " + type + n.name + " = " + right_side(p, n) + ";", purpose(p, k));
    }
    if (stage == 3) tests();
    const bool is_empty = result.header.ends_with("{\n");
    if (is_empty) result.header.pop_back();
    line(is_empty ? "}" : "  }");
  }
  void tests() {
    for (std::size_t i = 0; i < p.results.size(); ++i) {
      const Result& r = p.results[i];
      if (r.kind == Result::whole) continue;
      const std::string x = as_number(p, r.node);
      const std::string test = "    doubt = doubt + doubt_of_";
      if (r.kind == Result::real) {
        line("    " + r.name + " = " + rounded(r, x, i) + ";");
      } else if (r.kind != Result::guard) {
        line(test + "sign(" + x + ", " + bound_of(i) + ");");
      } else {
        const auto g = std::ranges::find(c.guards, r.name, &Condition::name);
        const std::string ends = range_in_code(g->of(false), g->of(true), "N::is_wide", ", ");
        line(test + "range(" + x + ", " + ends + ");");
      }
    }
  }
  std::string rounded(const Result& r, const std::string& x, std::size_t i) const {
    if (p[r.node].is_exact) return "N::to_result(" + as_plain(p, r.node) + ")";
    if (!is_tested(r)) return "rounded(" + x + ")";
    return "rounded_by<Tier>(" + x + ", " + bound_of(i) + ", doubt)";
  }
  std::string bound_of(std::size_t i) const {
    const std::string& code = bounds_of[i];
    if (code.empty()) return "T{}";
    return code.find(' ') == std::string::npos ? "N::magnitude_of(N::all(" + code + "))" : code;
  }
};
/// "in.alpha >= 0x1p-300 && ..." of the case, in both domains.
std::string condition(const Quantity& q, const Case& c) {
  Words parts;
  for (const Input& i : q.inputs) {
    const std::string v = "in." + i.name();
    const std::string value = i.is_whole() ? "double(" + v + ")" : v;
    const std::string zero = i.may_be_zero ? "(" + value + " == 0 || " : "";
    parts.push_back(zero + value + " >= " +
                    range_in_code(range_of(i, c, false), range_of(i, c, true), "is_wide",
                                  (zero.empty() ? "" : ")") + (" && " + value) + " <= "));
  }
  return joined(parts, " && ");
}
std::string structure(const std::string& name, const Words& members) {
  const std::string all = joined(members, "\n");
  return "struct " + name + " {" +
         (members.size() == 1 ? all.substr(1) + " };\n" : "\n" + all + "\n};\n");
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
  for (const Output& o : out) set += "    store(" + o.name + " + row, out." + o.name + ");\n";
  const std::string values_of =
      structure(Q + "Inputs", members(in, "", "")) + structure(Q + "Outputs", members(out, "", ""));
  if (!q.has_arrays) return values_of;
  Words columns = members(in, "const ", "*");
  const Words pointers = members(out, "", "*");
  columns.insert(columns.end(), pointers.begin(), pointers.end());
  columns.push_back(inlined + Q + "Inputs get(std::size_t row) const { return {" +
                    joined(values, ", ") + "}; }");
  columns.push_back(inlined + "void set(std::size_t row, const auto& out) const {\n" + set + "  }");
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
    bounds.push_back(CaseEmitter(q, c, e).outputs);
    visits += "    if (" + condition(q, c) + ")\n      return f.template operator()<" + Q +
              capital(c.name) + ">();\n";
  }
  const std::string of_arrays = q.has_arrays ? ", " + Q + "Columns" : "";
  const std::string main = q.has_arrays ? "  template <class Tier, class N> using Main = " + Q +
                                              capital(q.cases[0].name) + "<Tier, N>;\n"
                                        : "";
  e.header =
      broken(opening("// " + q.name + " in DoubleDouble" +
                         (q.labels.empty() ? "" : ", from " + q.labels) + ". Bounds: errors.txt.",
                     {"\"magicmass/evaluators/polynomials.hpp\""}) +
             "\nnamespace magicmass::generated::inline MAGICMASS_TARGET {\n" + structures(q) +
             e.header + "struct " + Q + " : Evaluator<" + Q + "Inputs, " + Q + "Outputs" +
             of_arrays + "> {\n" + main +
             "  template <bool is_wide, class F>\n"
             "  [[gnu::always_inline]] static double visit(const Inputs& in, F f) {\n" +
             visits +
             "    return 1.0;\n  }\n};\n"
             "}  // namespace magicmass::generated::inline MAGICMASS_TARGET\n");
  e.manifest = {manifest_entry(q, "evaluator", e.path, ids, bounds)};
  return e;
}
}  // namespace codegen
