// SPDX-License-Identifier: GPL-2.0-or-later
// Bounds of all tiers, members, stages, tests of one case.
#include "codegen/emit_case.hpp"

#include <set>

#include "codegen/builder.hpp"
#include "codegen/errors.hpp"
#include "codegen/exact.hpp"
#include "codegen/print_node.hpp"
#include "codegen/text.hpp"
#include "kernel/print.hpp"

namespace codegen {
namespace {
const std::string inlined = "  [[gnu::always_inline]] ";

struct TypeOfNumber {
  std::string tier;
  NumberType type;
};
/// Accurate first: it makes the plan. Ziv's bounds are reckoned at u = 2^-100, and are in units.
std::vector<TypeOfNumber> number_types() {
  constexpr double u = 0x1p-53;
  const std::vector<Tier>& t = tiers();
  return {{"Accurate", {u, &t[1]}},
          {"Fast", {u, &t[0]}},
          {"Slow", {u, &t[2]}},
          {"Ziv", {0x1p-100, nullptr}}};
}

class CaseEmitter {
public:
  EmittedCase result;

  CaseEmitter(const Quantity& quantity, const Case& which)
      : q(quantity), c(which), p(lower(quantity, which, false)) {
    name = capital(q.name) + capital(c.name);
    bounds();
    find_members();
    structure();
    for (const auto& [out, k] : p.whole_outputs) result.whole.push_back(out);
    for (const auto& [out, k] : p.outputs) result.real.push_back(out);
    result.code = text.str();
  }

private:
  const Quantity& q;
  const Case& c;
  Program p;
  std::string name;
  Text text;
  Analysis accurate;
  std::vector<std::string> outputs;  // bounds as C++
  std::vector<std::string> signs;
  bool has_bounds = false;
  std::set<int> members;  // nodes that a later stage takes

  void bounds() {
    Plan plan;
    std::string specialised;
    for (const TypeOfNumber& t : number_types()) {
      const bool is_wide = !t.type.is_pair();
      const Program program = is_wide ? lower(q, c, true) : p;
      const Analysis a = analyse(program, t.type, plan);
      std::vector<double> constants;
      std::vector<std::string> of_outputs;
      std::vector<std::string> of_signs;
      for (const Form& f : a.outputs) of_outputs.push_back(in_code(program, f, constants));
      for (const Form& f : a.positive) of_signs.push_back(in_code(program, f, constants));
      if (t.tier == "Accurate") {
        accurate = a;
        outputs = of_outputs;
        signs = of_signs;
        has_bounds = !constants.empty();
      }
      if (outputs != of_outputs || signs != of_signs) {
        throw Refused("bounds of " + name + " differ in form for " + t.tier + ": " +
                      codegen::joined(of_outputs, "; ") + codegen::joined(of_signs, "; "));
      }
      describe(program, t, a);
      if (has_bounds) specialised += specialisation(t, constants);
    }
    if (has_bounds) text.line("template <class Tier> struct " + name + "Bounds;");
    text.block(specialised);
  }
  std::string specialisation(const TypeOfNumber& t, const std::vector<double>& constants) const {
    std::string s = "template <> struct " + name + "Bounds<" + t.tier +
                    "> {\n  static constexpr double E[] = {\n";
    for (double x : constants) {
      const double printed = t.type.is_pair() ? x : x / t.type.u;
      s += "      " + hex(printed) + ",  // " + as_power_of_2(printed) + "\n";
    }
    return s + "  };\n};\n";
  }
  void describe(const Program& program, const TypeOfNumber& t, const Analysis& a) {
    std::string& e = result.errors;
    e += "\n" + name + ", " + t.tier + "\n";
    for (const std::string& step : a.steps) e += "  " + step + "\n";
    for (std::size_t i = 0; i < a.outputs.size(); ++i) {
      const std::string bound = p.outputs[i].first + ": " + in_words(program, a.outputs[i]);
      e += "  OUTPUT " + bound + "\n";
      if (t.tier == "Accurate") result.bounds.push_back(bound);
    }
    for (std::size_t i = 0; i < a.positive.size(); ++i) {
      e += "  SIGN " + p.positive[i].first + ": " + in_words(program, a.positive[i]) + "\n";
    }
  }

  void find_members() {
    const auto keep = [&](int k, int stage) {
      const Op op = p[k].op;
      if (p[k].stage < stage && op != Op::input && op != Op::constant) members.insert(k);
    };
    for (const Node& n : p.nodes) {
      for (int o : n.of) keep(o, n.stage);
    }
    for (const auto* list : {&accurate.outputs, &accurate.positive}) {
      for (const Form& f : *list) {
        for (const auto& [sizes, k] : f) {
          for (int v : sizes) keep(v, 3);
        }
      }
    }
    for (const auto* list : {&p.outputs, &p.positive}) {
      for (const auto& [out, k] : *list) keep(k, 3);
    }
    for (const auto& [out, k] : p.whole_outputs) keep(k, 4);
    for (const Guard& g : p.guards) keep(g.node, 3);
  }

  void structure() {
    text.line("/// " + q.name + ", " + c.name + ": " + domain_in_words(q, c) + ".");
    for (const kernel::Theorem& t : c.outputs) {
      text.line("/// Theorem: " + kernel::text(t.conclusion()));
    }
    for (const Fact& f : c.facts) {
      const std::string why = f.argument.empty() ? "a theorem" : f.argument;
      const std::string computed = f.of_computed.empty() ? "" : "; and: " + f.of_computed;
      text.line("/// " + kernel::text(f.formula) + ": " + why + computed);
    }
    for (const std::string& b : result.bounds) text.line("/// Accurate is off by at most " + b);
    text.line("/// Operations: " + operation_counts(p) + ".");
    text.line("template <class Tier, class N>");
    text.line("struct " + name + " {");
    text.line("  using T = typename N::Value;");
    text.line("  using R = typename N::Result;");
    for (const Input& i : q.inputs) text.line("  T " + i.name() + ";");
    text.line("  R doubt;");
    for (const auto& [out, k] : p.outputs) text.line("  R " + out + ";");
    for (int k : members) {
      text.line((p[k].is_exact ? "  T " : "  N ") + p[k].name + ";");
    }
    if (has_bounds) {
      text.line("  static constexpr const double* E = " + name + "Bounds<Tier>::E;");
    }
    inputs_and_outputs();
    for (int stage = 1; stage <= 3; ++stage) stage_function(stage);
    text.line("};");
  }
  void inputs_and_outputs() {
    const std::string Q = capital(q.name);
    text.line("  " + name + "() = default;");
    std::vector<std::string> set;
    for (const Input& i : q.inputs) {
      const std::string v = i.name();
      const bool is_whole = i.is_whole();
      set.push_back(v + (is_whole ? "(N::whole(in." : "(N::all(in.") + v + "))");
    }
    text.line(inlined + "explicit " + name + "(const " + Q + "Inputs& in)");
    text.line("      : " + codegen::joined(set, ", ") + " {}");
    text.line(inlined + "void load_inputs(const " + Q + "Columns& columns, std::size_t row) {");
    std::string in_case;
    for (const Input& i : q.inputs) {
      const std::string v = i.name();
      const bool is_whole = i.is_whole();
      const std::string from = (is_whole ? "arithmetic::SimdMask" : "arithmetic::Simd") +
                               std::string(">(columns.") + v + " + row)";
      text.line("    " + v + " = " + (is_whole ? "arithmetic::to_real(" : "") +
                "arithmetic::load<" + from + (is_whole ? ");" : ";"));
      const Interval r = range_of(i, c, false);
      in_case += " & (" + v + " >= " + hex(r.low) + ") & (" + v + " <= " + hex(r.high) + ")";
      if (is_whole) {
        in_case += " & (arithmetic::to_whole(" + v + ") == arithmetic::load<" + from + ")";
      }
    }
    text.line("  }");
    text.line(inlined + "arithmetic::SimdMask is_in_case([[maybe_unused]] const " + Q +
              "Columns& columns, [[maybe_unused]] std::size_t row) const {");
    text.line("    return " + in_case.substr(3) + ";");
    text.line("  }");
    text.line(inlined + "void store_outputs(const " + Q +
              "Columns& columns, std::size_t row) const {");
    std::vector<std::string> values;
    for (const auto& [out, k] : p.whole_outputs) {
      text.line("    arithmetic::store(columns." + out + " + row, arithmetic::to_whole(" +
                as_plain(p, k) + "));");
      values.push_back("N::to_whole(" + as_plain(p, k) + ")");
    }
    for (const auto& [out, k] : p.outputs) {
      text.line("    arithmetic::store(columns." + out + " + row, " + out + ");");
      values.push_back(out);
    }
    text.line("  }");
    text.line(inlined + Q + "Outputs outputs() const {");
    text.line("    return {" + codegen::joined(values, ", ") + "};");
    text.line("  }");
  }
  void stage_function(int stage) {
    text.line(inlined + "void stage_" + std::to_string(stage) + "() {");
    if (stage == 1) text.line("    doubt = R{};");
    std::set<int> paired;
    for (int k = 0; k < p.size(); ++k) {
      if (p[k].stage == stage) operation(k, paired);
    }
    if (stage == 3) tests();
    text.line("  }");
  }
  void operation(int k, std::set<int>& paired) {
    const Node& n = p[k];
    if (n.op == Op::input || n.op == Op::constant) return;
    if (!n.formula.empty()) text.line("    // " + n.formula);
    const bool is_function = n.op == Op::sine || n.op == Op::cosine;
    if (is_function && paired.insert(n.of[0]).second) {
      const int x = n.of[0];
      const std::string number = as_number(p, x);
      const bool is_small = p[x].range.size() <= small_angle;
      text.line("    const auto of_" + p[x].name + " = " +
                (is_small ? "sine_cosine_small<Tier>(" : "sine_cosine<Tier>(") + number + ");");
    }
    const bool is_member = members.count(k) > 0;
    const std::string type = is_member ? "" : n.is_exact ? "const T " : "const N ";
    const std::string maybe = !is_member && n.op == Op::scale ? "[[maybe_unused]] " : "";
    text.line("    " + maybe + type + n.name + " = " + right_side(p, n) + ";");
  }
  void tests() {
    for (std::size_t i = 0; i < p.outputs.size(); ++i) {
      const auto& [out, k] = p.outputs[i];
      if (p[k].is_exact) {
        text.line("    " + out + " = N::to_result(" + as_plain(p, k) + ");");
        continue;
      }
      text.line("    if constexpr (Tier::is_tested) {");
      text.line("      const auto tested = rounding_test(" + as_number(p, k) + ", " +
                bound(outputs[i]) + ");");
      text.line("      " + out + " = tested.value;");
      text.line("      doubt = doubt + tested.doubt;");
      text.line("    } else {");
      text.line("      " + out + " = rounded(" + as_number(p, k) + ");");
      text.line("    }");
    }
    for (std::size_t i = 0; i < p.positive.size(); ++i) {
      text.line("    doubt = doubt + doubt_of_sign(" + as_number(p, p.positive[i].second) + ", " +
                bound(signs[i]) + ");");
    }
    for (const Guard& g : p.guards) {
      text.line("    doubt = doubt + doubt_of_range(" + as_number(p, g.node) + ", " +
                hex(g.range.low) + ", " + hex(g.range.high) + ");");
    }
  }
  static std::string bound(const std::string& code) {
    if (code.empty()) return "T{}";
    return code.find(' ') == std::string::npos ? "N::all(" + code + ")" : code;
  }
};
}  // namespace

std::string condition(const Quantity& q, const Case& c) {
  std::vector<std::string> parts;
  for (const Input& i : q.inputs) {
    const std::string v = "in." + i.name();
    const Interval r = range_of(i, c, false);
    const Interval wide = range_of(i, c, true);
    const auto end = [](double narrow, double wide_end) {
      if (narrow == wide_end) return hex(narrow);
      return "(is_wide ? " + hex(wide_end) + " : " + hex(narrow) + ")";
    };
    const bool is_whole = i.is_whole();
    const std::string value = is_whole ? "double(" + v + ")" : v;
    parts.push_back(value + " >= " + end(r.low, wide.low) + " && " + value +
                    " <= " + end(r.high, wide.high));
  }
  return joined(parts, " && ");
}
EmittedCase emit_case(const Quantity& q, const Case& c) { return CaseEmitter(q, c).result; }
}  // namespace codegen
