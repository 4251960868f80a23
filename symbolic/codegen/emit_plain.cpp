// SPDX-License-Identifier: GPL-2.0-or-later
// One function template a quantity, one branch a case; others are refused at run time.
#include "codegen/emit_plain.hpp"

#include <algorithm>

#include "codegen/exact.hpp"
#include "codegen/lower.hpp"
#include "codegen/plain_text.hpp"
#include "codegen/text.hpp"
#include "kernel/print.hpp"

namespace codegen {
namespace {
using kernel::Expr;
using kernel::Theorem;

/// "alpha >= Number(0x1p-300) && ..."; exact forms are of numbers that need have no order.
std::string guard(const PlainForm& f, const Case& c) {
  std::vector<std::string> parts;
  for (const Input& i : f.quantity.inputs) {
    if (f.form == "exact" && !i.is_whole()) continue;
    const std::string name = i.name();
    const Interval r = range_of(i, c, false);
    const auto end = [&](double x) {
      return i.is_whole() ? kernel::digits(exact(x)) : "Number(" + hex(x) + ")";
    };
    parts.push_back(name + " >= " + end(r.low) + " && " + name + " <= " + end(r.high));
  }
  return parts.empty() ? "true" : joined(parts, " && ");
}
/// A line a guard: without it a named value is outside of what the formula is for.
std::string guard_lines(const std::string& function, const Case& c) {
  std::string lines;
  for (const Condition& g : c.guards) {
    const std::string name = identifier(g.name);
    lines += "    if (!(" + name + " > Number(" + hex(g.range.low) + ") && " + name + " < Number(" +
             hex(g.range.high) + ")))\n      throw std::domain_error(\"" + function + ": " + name +
             " must be between " + hex(g.range.low) + " and " + hex(g.range.high) + "\");\n";
  }
  return lines;
}
std::string output_name(const Theorem& t) { return identifier(t.conclusion().arg(0).name()); }

/// The outputs that are wanted (none named: all) and the definitions those need, other outputs
/// among them.
Quantity wanted_part(const Quantity& q, const std::set<std::string>& wanted) {
  Quantity r = q;
  for (Case& c : r.cases) {
    const Case whole = c;
    kernel::Theorems definitions = whole.definitions;
    c = {c.name, c.where, {}, {}, {}, {}};
    std::set<Expr> live;
    const auto visit = [&](const auto& self, Expr e) -> void {
      live.insert(kernel::substitute(e, q.units));
      for (Expr a : e.args()) self(self, a);
    };
    for (const Theorem& t : whole.outputs) {
      const bool is_wanted = wanted.empty() || wanted.count(output_name(t)) != 0;
      (is_wanted ? c.outputs : definitions).push_back(t);
      if (is_wanted) visit(visit, t.conclusion().arg(1));
    }
    if (!c.outputs.empty()) c.guards = whole.guards;
    const auto is_guarded = [&](Expr head) {
      return std::any_of(c.guards.begin(), c.guards.end(),
                         [&](const Condition& g) { return g.name == head.name(); });
    };
    for (auto t = definitions.rbegin(); t != definitions.rend(); ++t) {
      const Expr head = t->conclusion().arg(0);
      if (live.count(kernel::substitute(head, q.units)) == 0 && !is_guarded(head)) continue;
      visit(visit, t->conclusion().arg(1));
      c.definitions.insert(c.definitions.begin(), *t);
    }
  }
  check_outputs(r);
  return r;
}
/// "a, b, c", or "{{..}, {..}, {..}}" of a matrix.
std::string results(const Program& p, PlainText& text, Expr first) {
  const std::size_t columns = kernel::is_matrix(first) ? std::size_t(first.cols()) : 0;
  std::vector<std::string> values;
  std::vector<std::string> rows;
  for (const Result& r : p.results) {
    if (r.kind == Result::guard) continue;
    values.push_back(text.use(r.node));
    if (values.size() != columns) continue;
    rows.push_back("{" + joined(values, ", ") + "}");
    values.clear();
  }
  return columns > 0 ? "{" + joined(rows, ", ") + "}" : joined(values, ", ");
}

std::string array_of(const std::string& type, int size) {
  return "std::array<" + type + ", " + std::to_string(size) + ">";
}

class Function {
public:
  const Quantity q;  ///< no outputs: nothing is wanted here
  std::string doublings, code;
  std::vector<std::string> outputs;
  std::vector<Claim> claims;

  Function(const PlainForm& form, const Ids& all_ids, const std::set<std::string>& wanted)
      : q(wanted_part(form.quantity, wanted)), f(form), ids(all_ids) {
    for (const Output& o : outputs_of(q.cases[0])) outputs.push_back(o.name);
    if (outputs.empty()) return;
    for (const Case& c : q.cases) branch(c);
    write();
  }

private:
  const PlainForm& f;
  const Ids& ids;
  std::string branches, type;
  std::vector<std::string> domains, theorems;
  std::set<std::string> functions;  // of <cmath>

  std::string function_name() const {
    return f.form == "matrices" ? q.name : q.name + "_" + f.form;
  }
  void branch(const Case& c) {
    const bool is_exact = f.form == "exact";
    const Program p = lower_plain(q, c, is_exact);
    PlainText text(p);
    const Expr first = c.outputs[0].conclusion().arg(0);
    branches += "  if (" + guard(f, c) + ") {\n" + p.calls + text.lines() +
                guard_lines(function_name(), c) + "    return {" + results(p, text, first) +
                "};\n  }\n";
    for (const std::string& function : text.functions)
      functions.insert("  using std::" + function + ";");
    doublings = p.functions;
    domains.push_back(domain_in_words(q, c, is_exact));
    claims.push_back({c.name, domains.back(), {}, ids_of(c, ids)});
    for (const std::string& id : claims.back().theorems) {
      if (std::find(theorems.begin(), theorems.end(), id) == theorems.end()) theorems.push_back(id);
    }
    type = kernel::is_matrix(first) ? array_of(array_of("Number", first.cols()), first.rows())
                                    : capital(q.name) + capital(f.form) + "<Number>";
  }
  void write() {
    const bool is_matrix = f.form == "matrices";
    const std::string name = function_name();
    std::vector<std::string> parameters;
    for (const Input& i : q.inputs) {
      parameters.push_back((i.is_whole() ? "std::int64_t " : "const Number& ") + i.name());
    }
    if (!is_matrix) {
      code += "template <class Number>\nstruct " + capital(q.name) + capital(f.form) +
              " {\n  Number " + joined(outputs, ", ") + ";\n};\n";
    }
    const std::string of_paper = q.labels.empty() ? "" : " (" + q.labels + ")";
    code += "/// " + q.name + of_paper + ": " + joined(outputs, ", ") +
            ". Domain: " + joined(domains, "; or ") + ".\n";
    if (!theorems.empty()) code += "/// Theorems: " + joined(theorems, ", ") + ".\n";
    code +=
        "template <class Number>\n" + type + " " + name + "(" + joined(parameters, ", ") + ") {\n";
    for (const std::string& line : functions) code += line + "\n";
    const std::string between = domains.size() + q.inputs.size() > 2 ? "\"\n      \"" : "";
    code += branches + "  throw std::domain_error(\"" + name + ": allowed: " + between +
            joined(domains, "; or " + between) + "\");\n}\n";
  }
};
}  // namespace

Emitted emit_plain(const std::vector<PlainForm>& forms, const Ids& ids,
                   const std::set<std::string>& wanted) {
  if (forms.empty()) throw Refused("no form to print");
  const std::string& form = forms[0].form;
  const bool is_exact = form == "exact";
  Emitted result{(is_exact ? "exact/" : "plain/") + form + ".hpp", "", {}};
  std::string body;
  std::set<std::string> all;
  std::set<std::string> missing = wanted;
  for (const PlainForm& f : forms) {
    if (f.form != form) throw Refused("two forms in one header: " + form + ", " + f.form);
    for (const Theorem& t : f.quantity.cases.at(0).outputs) all.insert(output_name(t));
    const Function w(f, ids, wanted);
    if (w.outputs.empty()) continue;
    body += (body.find(w.doublings) == std::string::npos ? w.doublings : "") + w.code;
    for (const std::string& name : w.outputs) missing.erase(name);
    result.manifest.push_back(manifest_entry(w.q, form, result.path, w.claims));
  }
  if (!missing.empty()) {
    throw Refused("no output is called " + *missing.begin() +
                  "; allowed: " + joined({all.begin(), all.end()}, ", "));
  }
  std::vector<std::string> includes;
  for (const auto& [used, header] : {std::pair("std::array<", "<array>"),
                                     {"std::bit_width(", "<bit>"},
                                     {"  using std::", "<cmath>"},
                                     {"std::int64_t", "<cstdint>"},
                                     {"std::domain_error(", "<stdexcept>"},
                                     {"std::pair<", "<utility>"}}) {
    if (body.find(used) != std::string::npos) includes.push_back(header);
  }
  const std::string numbers =
      is_exact ? "any field, without error"
               : "any real type of double's precision and exponents, or better, with <cmath>'s "
                 "functions; each operation is rounded as the type rounds";
  result.header = broken(
      opening("// The " + form + (form == "matrices" ? "" : " forms") + ", for " + numbers +
                  ". Outside of its domain a function throws std::domain_error.",
              includes) +
      "\nnamespace magicmass::generated {\n" + body + "}  // namespace magicmass::generated\n");
  return result;
}
}  // namespace codegen
