// SPDX-License-Identifier: GPL-2.0-or-later
// One function template a quantity, one branch a case; others are refused at run time.
#include "codegen/emit_plain.hpp"

#include "codegen/exact.hpp"
#include "codegen/plain_branch.hpp"
#include "codegen/program.hpp"
#include "codegen/text.hpp"
#include "kernel/print.hpp"

namespace codegen {
namespace {
using kernel::Expr;
using kernel::Theorem;
using kernel::Theorems;

bool is_whole(const Input& i) { return i.variable.sort() == kernel::Sort::Int; }
/// "alpha >= Number(0x1p-300) && ..."; exact forms are of numbers that need have no order.
std::string guard(const PlainForm& f, const Case& c) {
  std::vector<std::string> parts;
  for (const Input& i : f.quantity.inputs) {
    if (f.form == "exact" && !is_whole(i)) continue;
    const std::string name = identifier(i.variable.name());
    const Interval r = range_of(i, c, false);
    const auto end = [&](double x) {
      return is_whole(i) ? kernel::digits(exact(x)) : "Number(" + hex(x) + ")";
    };
    parts.push_back(name + " >= " + end(r.low) + " && " + name + " <= " + end(r.high));
  }
  return parts.empty() ? "true" : joined(parts, " && ");
}
/// "alpha from 0x1p-300 to 0x1p+40, n from 0 to 1024"
std::string allowed(const PlainForm& f, const Case& c) {
  std::vector<std::string> parts;
  for (const Input& i : f.quantity.inputs) {
    const Interval r = range_of(i, c, false);
    const auto end = [&](double x) { return is_whole(i) ? kernel::digits(exact(x)) : hex(x); };
    const bool is_any = f.form == "exact" && !is_whole(i);
    parts.push_back(identifier(i.variable.name()) +
                    (is_any ? " > 0" : " from " + end(r.low) + " to " + end(r.high)));
  }
  return joined(parts, ", ");
}
std::string output_name(const Theorem& t) { return identifier(t.conclusion().arg(0).name()); }

struct Written {
  std::string doublings, code;
  bool has_functions = false;
  std::vector<std::string> outputs;
  std::vector<Claim> claims;
};
Written write_function(const PlainForm& f, const Ids& ids, const std::set<std::string>& wanted) {
  const Quantity& q = f.quantity;
  Written w;
  const std::string own_type = capital(q.name) + capital(f.form);
  std::string type = own_type + "<Number>";
  std::string branches;
  std::vector<std::string> domains;
  Theorems used;
  std::set<std::string> functions;
  for (const Case& c : q.cases) {
    Theorems outputs;
    std::vector<std::string> names;
    for (const Theorem& t : c.outputs) {
      if (!wanted.empty() && wanted.count(output_name(t)) == 0) continue;
      outputs.push_back(t);
      names.push_back(output_name(t));
    }
    if (outputs.empty()) return {};
    if (!w.outputs.empty() && w.outputs != names) {
      throw Refused("the cases of " + q.name + " do not have the same outputs");
    }
    w.outputs = names;
    const PlainBranch b(f, c, outputs);
    functions.insert(b.printer.functions.begin(), b.printer.functions.end());
    used.insert(used.end(), b.used.begin(), b.used.end());
    branches += "  if (" + guard(f, c) + ") {\n" + b.lines + "    return {" +
                joined(b.results, ", ") + "};\n  }\n";
    domains.push_back(allowed(f, c));
    w.claims.push_back({c.name, domains.back(), {}, ids_of(b.used, ids)});
    if (w.doublings.empty()) {
      for (const Doubling& d : f.doublings) w.doublings += emit_doubling(d, b.domain);
    }
    const Expr first = outputs[0].conclusion().arg(0);
    if (kernel::is_matrix(first)) {
      type = "std::array<std::array<Number, " + std::to_string(first.cols()) + ">, " +
             std::to_string(first.rows()) + ">";
    }
  }
  const bool is_matrix = f.form == "matrices";
  const std::string name = is_matrix ? q.name : q.name + "_" + f.form;
  std::vector<std::string> parameters;
  for (const Input& i : q.inputs) {
    parameters.push_back((is_whole(i) ? "std::int64_t " : "const Number& ") +
                         identifier(i.variable.name()));
  }
  w.has_functions = !functions.empty();
  const std::vector<std::string> theorems = ids_of(used, ids);
  Text t;
  if (!is_matrix) {
    t.block("template <class Number>\nstruct " + own_type + " {\n  Number " +
            joined(w.outputs, ", ") + ";\n};\n");
  }
  t.line("/// " + q.name + " (" + q.labels + "): " + joined(w.outputs, ", ") +
         ". Domain: " + joined(domains, "; or ") + ".");
  if (!theorems.empty()) t.line("/// Theorems: " + joined(theorems, ", ") + ".");
  t.block("template <class Number>\n" + type + " " + name + "(" + joined(parameters, ", ") + ") {");
  for (const std::string& function : functions) t.line("  using std::" + function + ";");
  t.block(branches);
  const std::string between = domains.size() + q.inputs.size() > 2 ? "\"\n      \"" : "";
  t.block("  throw std::domain_error(\"" + name + ": allowed: " + between +
          joined(domains, "; or " + between) + "\");\n}\n");
  w.code = t.str();
  return w;
}
}  // namespace

PlainHeader emit_plain(const std::vector<PlainForm>& forms, const Ids& ids,
                       const std::set<std::string>& wanted) {
  if (forms.empty()) throw Refused("no form to print");
  const std::string& form = forms[0].form;
  const bool is_exact = form == "exact";
  PlainHeader result{(is_exact ? "exact/" : "plain/") + form + ".hpp", "", {}};
  std::string body;
  std::set<std::string> doublings;
  std::set<std::string> all;
  std::set<std::string> missing = wanted;
  bool has_functions = false;
  for (const PlainForm& f : forms) {
    if (f.form != form) throw Refused("two forms in one header: " + form + ", " + f.form);
    for (const Theorem& t : f.quantity.cases.at(0).outputs) all.insert(output_name(t));
    const Written w = write_function(f, ids, wanted);
    if (w.outputs.empty()) continue;
    const bool is_new = !w.doublings.empty() && doublings.insert(w.doublings).second;
    body += (is_new ? w.doublings : "") + w.code;
    has_functions = has_functions || w.has_functions;
    for (const std::string& name : w.outputs) missing.erase(name);
    result.manifest.push_back(manifest_entry(f.quantity, form, result.path, w.outputs, w.claims));
  }
  if (!missing.empty()) {
    throw Refused("no output is called " + *missing.begin() +
                  "; allowed: " + joined({all.begin(), all.end()}, ", "));
  }
  std::vector<std::string> includes;
  if (form == "matrices") includes.push_back("<array>");
  if (!doublings.empty()) includes.push_back("<bit>");
  if (has_functions) includes.push_back("<cmath>");
  includes.insert(includes.end(), {"<cstdint>", "<stdexcept>"});
  if (!doublings.empty()) includes.push_back("<utility>");
  const std::string numbers =
      is_exact ? "any field, without error"
               : "any real type of double's precision and exponents, or better, with <cmath>'s "
                 "functions; each operation is rounded as the type rounds";
  Text t;
  t.block(opening("// The " + form + (form == "matrices" ? "" : " forms") + ", for " + numbers +
                      ". Outside of its domain a function throws std::domain_error.",
                  includes));
  t.block("\nnamespace magicmass::generated {\n" + body + "}  // namespace magicmass::generated\n");
  result.header = t.str();
  return result;
}
}  // namespace codegen
