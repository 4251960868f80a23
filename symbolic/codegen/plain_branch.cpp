// SPDX-License-Identifier: GPL-2.0-or-later
// Definitions, functions that are called more than once, outputs.
#include "codegen/plain_branch.hpp"

#include "codegen/emit_plain.hpp"
#include "codegen/program.hpp"
#include "codegen/text.hpp"

namespace codegen {
namespace {
using kernel::Expr;
using kernel::Theorem;
using kernel::Theorems;

/// The definitions that the outputs need, in order, then the outputs.
Theorems needed(const Theorems& definitions, const Theorems& outputs) {
  std::set<Expr> live;
  const auto visit = [&](const auto& self, Expr e) -> void {
    live.insert(e);
    for (Expr a : e.args()) self(self, a);
  };
  for (const Theorem& t : outputs) visit(visit, t.conclusion().arg(1));
  Theorems r = outputs;
  for (auto t = definitions.rbegin(); t != definitions.rend(); ++t) {
    if (live.count(t->conclusion().arg(0)) == 0) continue;
    visit(visit, t->conclusion().arg(1));
    r.insert(r.begin(), *t);
  }
  return r;
}
std::string place(int k, int columns) {
  return "_" + std::to_string(k / columns + 1) + std::to_string(k % columns + 1);
}
}  // namespace

PlainBranch::PlainBranch(const PlainForm& f, const Case& c, const Theorems& outputs)
    : used(needed(c.definitions, outputs)),
      domain{f.quantity, c, false, [this](Expr e) { return PlainPrinter(printer).print(e).range; }},
      form(f) {
  for (const Input& i : form.quantity.inputs) {
    const std::string name = identifier(i.variable.name());
    const bool is_whole = i.variable.sort() == kernel::Sort::Int;
    printer.names[i.variable] = {is_whole ? "Number(" + name + ")" : name, range_of(i, c, false)};
  }
  for (const Theorem& t : used) find_shared(t.conclusion().arg(1));
  for (std::size_t k = 0; k + outputs.size() < used.size(); ++k) define(used[k]);
  for (const Theorem& t : outputs) results.push_back(output(t));
}
/// Functions that are called more than once.
void PlainBranch::find_shared(Expr e) {
  if (PlainPrinter::is_function(e) && !seen.insert(e).second) {
    shared.insert(e);
    return;
  }
  for (Expr a : e.args()) find_shared(a);
}
/// A line for each function in e that is shared, then one for e.
Printed PlainBranch::line(const std::string& name, Expr e) {
  const auto compute_shared = [&](const auto& self, Expr x) -> void {
    if (printer.names.count(x) > 0) return;
    for (Expr a : x.args()) self(self, a);
    if (x == e || shared.count(x) == 0) return;
    lines += "    // " + shown(form.quantity, x) + "\n";
    printer.names[x] = line(x.name() + "_" + std::to_string(++count), x);
  };
  compute_shared(compute_shared, e);
  for (const Doubling& d : form.doublings) lines += call_doubling(d, e, printer);
  // Ranges are of doubles: of an exact form those of its inputs alone are known.
  printer.is_exact = form.form == "exact";
  const Printed value = printer.print(e);
  printer.is_exact = false;
  lines += "    const Number " + name + " = " + without_brackets(value.text) + ";\n";
  return {name, value.range};
}
void PlainBranch::define(const Theorem& t) {
  const Expr left = checked_head(domain, t);
  const Expr right = t.conclusion().arg(1);
  lines += "    // " + shown(form.quantity, t.conclusion()) + "\n";
  if (!kernel::is_matrix(left)) {
    printer.names[left] = line(identifier(left.name()), right);
    return;
  }
  for (int k = 0; k < right.rows() * right.cols(); ++k) {
    const int row = k / right.cols();
    const int col = k % right.cols();
    const Expr e = kernel::entry(right, row, col);
    const bool is_known = e.op() == kernel::Op::Num || printer.names.count(e) > 0;
    printer.names[kernel::entry(left, row, col)] =
        is_known ? printer.print(e) : line(left.name() + place(k, right.cols()), e);
  }
}
std::string PlainBranch::output(const Theorem& t) {
  const Expr left = checked_head(domain, t);
  if (printer.names.count(left) == 0) define(t);
  if (!kernel::is_matrix(left)) return printer.names.at(left).text;
  std::vector<std::string> rows;
  for (int row = 0; row < left.rows(); ++row) {
    std::vector<std::string> entries;
    for (int col = 0; col < left.cols(); ++col) {
      entries.push_back(printer.names.at(kernel::entry(left, row, col)).text);
    }
    rows.push_back("{" + joined(entries, ", ") + "}");
  }
  return "{" + joined(rows, ", ") + "}";
}
}  // namespace codegen
