// SPDX-License-Identifier: GPL-2.0-or-later
// Prints terms as they stand in the theorems.
#include "codegen/emit_plain.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "codegen/program.hpp"
#include "codegen/text.hpp"
#include "kernel/print.hpp"

namespace codegen {
namespace {
using kernel::Expr;
using kernel::Op;

class Printer {
public:
  std::map<Expr, std::string> names;
  std::set<std::string> functions;

  std::string print(Expr e, bool in_product = false) {
    if (const auto found = names.find(e); found != names.end()) return found->second;
    switch (e.op()) {
      case Op::Num:
        return number(e.value());
      case Op::Add: {
        std::string s;
        for (Expr a : e.args()) s += (s.empty() ? "" : " + ") + print(a, !s.empty());
        return in_product ? "(" + s + ")" : s;
      }
      case Op::Mul: {
        std::string above;
        std::string below;
        for (Expr a : e.args()) {
          const bool is_inverse = a.op() == Op::Fun && a.name() == "inv";
          std::string& side = is_inverse ? below : above;
          const std::string factor = print(is_inverse ? a.arg(0) : a, true);
          side += is_inverse ? " / " + factor : (side.empty() ? "" : " * ") + factor;
        }
        return "(" + (above.empty() ? number(1) : above) + below + ")";
      }
      case Op::Pow: {
        const std::string base = print(e.arg(0), true);
        std::string p = base;
        for (int k = 1; k < e.exponent(); ++k) p += " * " + base;
        return "(" + p + ")";
      }
      case Op::Fun:
        return call(e);
      default:
        throw Refused("no plain form of " + kernel::text(e));
    }
  }

private:
  static std::string number(const cln::cl_RA& q) {
    const std::string above = "Number(" + kernel::digits(cln::numerator(q)) + ")";
    if (cln::denominator(q) == 1) return above;
    return "(" + above + " / Number(" + kernel::digits(cln::denominator(q)) + "))";
  }
  std::string call(Expr e) {
    const std::string f = e.name();
    if (f == "inv") return "(" + number(1) + " / " + print(e.arg(0), true) + ")";
    if (f == "pi") {
      functions.insert("atan");
      return "(Number(4) * atan(Number(1)))";
    }
    const bool is_known = f == "sqrt" || f == "sin" || f == "cos" || f == "atan" || f == "ceil";
    if (!is_known) throw Refused("no definition of " + kernel::text(e));
    functions.insert(f);
    return f + "(" + print(e.arg(0)) + ")";
  }
};
/// The definitions that the outputs need, in order.
kernel::Theorems needed(const Case& c) {
  std::set<Expr> live;
  const auto visit = [&](const auto& self, Expr e) -> void {
    live.insert(e);
    for (Expr a : e.args()) self(self, a);
  };
  for (const kernel::Theorem& t : c.outputs) visit(visit, t.conclusion().arg(1));
  kernel::Theorems r;
  for (auto t = c.definitions.rbegin(); t != c.definitions.rend(); ++t) {
    if (live.count(t->conclusion().arg(0)) == 0) continue;
    visit(visit, t->conclusion().arg(1));
    r.insert(r.begin(), *t);
  }
  return r;
}
std::string without_outer(const std::string& s) {
  int depth = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    depth += s[k] == '(' ? 1 : s[k] == ')' ? -1 : 0;
    if (depth == 0 && k + 1 < s.size()) return s;
  }
  return s.substr(1, s.size() - 2);
}
}  // namespace

PlainHeader emit_plain(const Quantity& q, const std::string& form) {
  const std::string type = capital(q.name) + capital(form);
  Text body;
  std::set<std::string> functions;
  std::string fields;
  for (const Case& c : q.cases) {
    Printer printer;
    std::vector<std::string> parameters;
    for (const Input& i : q.inputs) {
      const std::string name = identifier(i.variable.name());
      printer.names[i.variable] = name;
      parameters.push_back("[[maybe_unused]] const Number& " + name);
    }
    Text lines;
    const auto value = [&](const kernel::Theorem& t) {
      const Expr f = t.conclusion();
      lines.line("  // " + kernel::text(f));
      lines.line("  const Number " + identifier(f.arg(0).name()) + " = " +
                 without_outer(printer.print(f.arg(1))) + ";");
      printer.names[f.arg(0)] = identifier(f.arg(0).name());
    };
    for (const kernel::Theorem& t : needed(c)) value(t);
    std::vector<std::string> outputs;
    for (const kernel::Theorem& t : c.outputs) {
      if (printer.names.count(t.conclusion().arg(0)) == 0) value(t);
      outputs.push_back(printer.names.at(t.conclusion().arg(0)));
    }
    const std::string declared = "  Number " + joined(outputs, ";\n  Number ") + ";\n";
    if (!fields.empty() && fields != declared) {
      throw Refused("the cases of " + q.name + " do not have the same outputs");
    }
    fields = declared;
    std::vector<std::string> conditions;
    for (const kernel::Theorem& t : c.outputs) {
      for (Expr h : t.hypotheses()) {
        const std::string text = kernel::text(h);
        const bool is_new =
            std::find(conditions.begin(), conditions.end(), text) == conditions.end();
        if (is_new) conditions.push_back(text);
      }
    }
    body.line("/// " + q.name + ", " + c.name +
              (conditions.empty() ? "" : ": where " + joined(conditions, ", ")) + ".");
    body.line("template <class Number>");
    body.line(type + "<Number> " + q.name + "_" + form + "_" + c.name + "(" +
              joined(parameters, ", ") + ") {");
    for (const std::string& f : printer.functions) body.line("  using std::" + f + ";");
    body.block(lines.str());
    body.line("  return {" + joined(outputs, ", ") + "};");
    body.line("}");
    functions.insert(printer.functions.begin(), printer.functions.end());
  }
  const bool is_exact = functions.empty();
  const std::string numbers = is_exact ? "any field" : "any real type with <cmath>'s functions";
  Text t;
  t.block(opening("// " + q.name + ", " + form + " form, from " + q.labels + ", for " + numbers +
                      "; each operation is rounded as the type rounds.",
                  is_exact ? std::vector<std::string>{} : std::vector<std::string>{"<cmath>"}));
  t.line("");
  t.line("namespace magicmass::generated {");
  t.line("template <class Number>");
  t.block("struct " + type + " {\n" + fields + "};\n");
  t.block(body.str());
  t.line("}  // namespace magicmass::generated");
  return {is_exact ? "exact" : "plain", t.str()};
}
}  // namespace codegen
