// One function template a quantity, one branch a case; others are refused at run time.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "codegen/emit.hpp"

namespace codegen {
namespace {

/// In numbers of float's size an end's size is at most that, and at least one by it.
double in_float(double end, double most) {
  return end == 0 ? 0 : std::copysign(std::clamp(std::fabs(end), 1 / most, most), end);
}
/// "alpha >= Number(0x1p-300) && ...", "" where nothing is tested: a field need have no order.
std::string guard(const PlainForm& f, const Case& c) {
  Words parts;
  for (const Input& i : f.quantity.inputs) {
    if (f.form == "exact" && !i.is_whole()) continue;
    const auto number = [&](double x) { return i.is_whole() ? kernel::digits(exact(x)) : hex(x); };
    const auto end = [&](double x) {
      const std::string all = number(x), other = number(in_float(x, f.most_in_float));
      if (all == other && i.is_whole()) return all;
      const std::string choice = all == other ? "" : "sizeof(Number) > 4 ? " + all + " : ";
      return (i.is_whole() ? "(" : "Number(") + choice + other + ")";
    };
    const Interval r = range_of(i, c, false);
    parts.push_back(i.name() + " >= " + end(r.low) + " && " + i.name() + " <= " + end(r.high));
  }
  return joined(parts, " && ");
}
/// Whether what is allowed is said where it is thrown; what takes more than a line, in the comment.
bool is_short(const std::string& allowed) { return allowed.size() + 12 <= columns; }
/// The exception where that does not hold.
std::string unless(const std::string& condition, const std::string& start, std::string end) {
  const std::string thrown = "    throw std::domain_error(\"" + start, next = "\"\n        \"";
  const auto has_room = [&](std::size_t before) { return before + end.size() + 3 <= columns; };
  if (!is_short(end)) end = "what its comment says";
  return "  if (!(" + condition + "))\n" + thrown + (has_room(thrown.size()) ? "" : next) + end +
         "\");\n";
}
std::string output_name(const Theorem& t) { return identifier(t.conclusion().arg(0).name()); }

/// The outputs that are wanted (none named: all) and definitions that those need, outputs as well.
Quantity wanted_part(Quantity q, const std::set<std::string>& wanted) {
  for (Case& c : q.cases) {
    std::set<Expr> live;
    const auto visit = [&](const auto& self, Expr e) -> void {
      live.insert(kernel::substitute(e, q.units));
      for (Expr a : e.args()) self(self, a);
    };
    // In their order: what one output needs may be another, or a value that has a guard.
    c.definitions.insert(c.definitions.end(), c.outputs.begin(), c.outputs.end());
    std::erase_if(c.outputs, [&](const Theorem& t) {
      return !wanted.empty() && !wanted.contains(output_name(t));
    });
    if (c.outputs.empty()) c.guards.clear();
    for (const Theorem& t : c.outputs) visit(visit, t.conclusion());
    Theorems needed;
    for (auto t = c.definitions.rbegin(); t != c.definitions.rend(); ++t) {
      const Expr head = t->conclusion().arg(0);
      const bool is_live = live.count(kernel::substitute(head, q.units)) > 0;
      if (!is_live && std::ranges::count(c.guards, head.name(), &Condition::name) == 0) continue;
      visit(visit, t->conclusion().arg(1));
      needed.insert(needed.begin(), *t);
    }
    c.definitions = needed;
  }
  check_outputs(q);
  return q;
}
/// "a, b, c", or "{{..}, {..}, {..}}" of a matrix.
std::string results(const Program& p, PlainText& text, Expr first) {
  Words values;
  for (const Result& r : p.results)
    if (r.kind != Result::guard) values.push_back(text.use(r.node));
  if (!kernel::is_matrix(first)) return joined(values, ", ");
  Words rows;
  for (auto v = values.begin(); v != values.end(); v += first.cols())
    rows.push_back("{" + joined({v, v + first.cols()}, ", ") + "}");
  return "{" + joined(rows, ", ") + "}";
}
/// An id without a chapter is of the one before it.
std::string listed(Words ids) {
  std::string chapter;
  for (std::string& id : ids) {
    const std::string of = id.substr(0, id.find('.') + 1);
    id = id.substr(of == chapter ? of.size() : 0);
    chapter = of;
  }
  return joined(ids, ", ");
}
std::string array_of(const std::string& type, int size) {
  return "std::array<" + type + ", " + std::to_string(size) + ">";
}

/// A function's code, to the header, and what the manifest says of it, if an output is wanted.
void emit_function(const PlainForm& f, const Ids& ids, const std::set<std::string>& wanted,
                   Emitted& e, std::set<std::string>& functions) {
  const Quantity q = wanted_part(f.quantity, wanted);
  Words all, ceilings;
  for (const Output& o : outputs_of(q.cases[0])) {
    all.push_back(o.name);
    if (o.is_whole) ceilings.push_back(o.name);
  }
  if (all.empty()) return;
  const bool is_matrix = f.form == "matrices";
  const std::string name = is_matrix ? q.name : q.name + "_" + f.form;
  const std::string structure = capital(q.name) + capital(f.form);
  const Expr first = q.cases[0].outputs[0].conclusion().arg(0);
  std::string code;
  Words domains, counts, parameters;
  bool is_in_comment = true;
  const bool is_exact = f.form == "exact", is_float = f.most_in_float < infinity;
  for (const Case& c : q.cases) {
    const Program p = lower(q, c, is_exact ? Numbers::field : Numbers::plain);
    PlainText text(p);
    domains.push_back(domain_in_words(q, c, is_exact));
    Quantity single = q;
    for (auto& [variable, range, wide, zero] : single.inputs)
      range = {in_float(range.low, f.most_in_float), in_float(range.high, f.most_in_float)};
    if (is_float) lower(single, c, Numbers::single);  // for what it refuses
    counts.push_back(operation_counts(p) + (p.calls.empty() ? "" : ", and those of the calls"));
    std::string guards;  // outside of them a named value is not what the formula is for
    for (const Condition& g : c.guards) {
      const std::string value = identifier(g.name), low = hex(g.range.low),
                        high = hex(g.range.high);
      guards += unless(value + " > Number(" + low + ") && " + value + " < Number(" + high + ")",
                       name + ": allowed: ", value + " between " + low + " and " + high);
    }
    const std::string body =
        p.calls + text.lines() + guards + "  return {" + results(p, text, first) + "};\n";
    functions.merge(text.functions);
    if (e.header.find(p.doubling) == std::string::npos) e.header += p.doubling;
    const std::string inside = guard(f, c);
    if (&c != &q.cases.back()) {
      code += "  if (" + inside + ") {\n";
      std::istringstream lines(body);
      for (std::string line; std::getline(lines, line);)
        code += (line.empty() ? "" : "  ") + line + "\n";
      code += "  }\n";
      continue;
    }
    const std::string of_float = is_float ? "; floats within " + hex(f.most_in_float) : "",
                      allowed = joined(domains, "; or ") + of_float;
    is_in_comment = inside.empty() || !is_short(allowed);
    if (!inside.empty()) code += unless(inside, name + ": allowed: ", allowed);
    code += body;
  }
  for (const Input& i : q.inputs)
    parameters.push_back((i.is_whole() ? "std::int64_t " : "const Number& ") + i.name());
  const std::string outputs = joined(all, ", ");
  const std::string of_paper = q.labels.empty() ? "" : " (" + q.labels + ")";
  const std::string theorems = listed(ids_of(q.cases, ids));
  if (!is_matrix)
    e.header += "template <class Number> struct " + structure + " { Number " + outputs + "; };\n";
  e.header += "/// " + q.name + of_paper + (is_matrix ? ": " + outputs : "") +
              (is_in_comment ? ". Domain: " + joined(domains, "; or ") : "") +
              (theorems.empty() ? "" : ". Theorems: " + theorems) +
              ". Operations: " + joined(counts, "; or ");
  if (!ceilings.empty())
    e.header +=
        ". Ceilings of rounded numbers, maybe off by one at thresholds and by more above 2^50: " +
        joined(ceilings, ", ");
  e.header += ".\ntemplate <class Number> requires(!std::" +
              std::string(is_exact   ? "is_arithmetic_v<Number>)\n"
                          : is_float ? "integral<Number> && sizeof(Number) >= 4)  // 1.0, not 1\n"
                                     : "integral<Number> && sizeof(Number) > 4)  // nor 1.0f\n") +
              (is_matrix ? array_of(array_of("Number", first.cols()), first.rows())
                         : structure + "<Number>") +
              " " + name + "(" + joined(parameters, ", ") + ") {\n";
  e.header += code + "}\n";
  e.manifest.push_back(manifest_entry(q, f.form, e.path, ids));
}
}  // namespace

Emitted emit_plain(const std::vector<PlainForm>& forms, const Ids& ids,
                   const std::set<std::string>& wanted, const std::string& more) {
  const std::string& form = forms.at(0).form;
  const bool is_exact = form == "exact";
  Emitted result{(is_exact ? "exact/" : "plain/") + form + ".hpp", "", {}};
  std::set<std::string> all, missing = wanted, functions;  // of <cmath>
  for (const PlainForm& f : forms) {
    for (const Theorem& t : f.quantity.cases.at(0).outputs) all.insert(output_name(t));
    emit_function(f, ids, wanted, result, functions);
  }
  result.header += more;
  if (!functions.empty())
    result.header = "using std::" + joined({functions.begin(), functions.end()}, ", std::") +
                    ";\n" + result.header;
  for (const std::string& name : all) missing.erase(name);
  if (!missing.empty())
    throw Refused("no output is called " + *missing.begin() +
                  "; allowed: " + joined({all.begin(), all.end()}, ", "));
  Words includes;
  for (const auto& [used, header] : {std::pair("std::array<", "<array>"),
                                     {"std::bit_width(", "<bit>"},
                                     {"using std::", "<cmath>"},
                                     {"std::integral<", "<concepts>"},
                                     {"std::int64_t", "<cstdint>"},
                                     {"std::domain_error(", "<stdexcept>"},
                                     {"std::is_arithmetic_v<", "<type_traits>"},
                                     {"std::pair<", "<utility>"}})
    if (result.header.find(used) != std::string::npos) includes.push_back(header);
  const std::string most = hex(forms[0].most_in_float);
  const std::string of_float =
      most == "inf" ? "" : ", and float, whose domains end at " + most + " and at one by that";
  const std::string numbers =
      is_exact
          ? "any field, without error; doubles are no field, and refused: closed, product "
            "and tangent are for them. A whole number outside of its domain throws "
            "std::domain_error; others are not tested: a field need have no order."
          : "real types at least as wide as double" + of_float +
                ". No bound is derived: terms that cancel leave their absolute error; n times an "
                "angle has n times its error. Outside of a domain std::domain_error is thrown.";
  result.header =
      broken(opening("// The " + form + (form == "matrices" ? "" : " forms") + ", for " + numbers,
                     includes) +
             "\nnamespace magicmass::generated {\n" + result.header +
             "}  // namespace magicmass::generated\n");
  return result;
}
}  // namespace codegen
