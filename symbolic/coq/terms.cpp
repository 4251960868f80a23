// SPDX-License-Identifier: GPL-2.0-or-later
// One line of Coq for each operation of the kernel.
#include <set>

#include "coq/script.hpp"
#include "kernel/print.hpp"

namespace coq {
using kernel::Expr;
using kernel::Exprs;
using kernel::Op;

std::string name(const std::string& kernel_name) {
  static const std::map<std::string, std::string> own = {{"inv", "/"}, {"pi", "PI"}};
  static const std::set<std::string> taken = {
      "R",     "PI",     "isint",      "toN",    "fromN", "least",  "entry",  "dot",   "table",
      "munit", "mtimes", "mtranspose", "mpow",   "det",   "as",     "at",     "cofix", "else",
      "end",   "exists", "exists2",    "fix",    "for",   "forall", "fun",    "if",    "in",
      "let",   "match",  "mod",        "nat",    "O",     "Prop",   "return", "S",     "Set",
      "then",  "Type",   "using",      "where",  "with",  "Z",      "list",   "fst",   "snd",
      "and",   "or",     "not",        "square", "minus", "half"};
  if (const auto it = own.find(kernel_name); it != own.end()) return it->second;
  return kernel_name + (taken.count(kernel_name) != 0 ? "'k" : "");
}
std::string spaced(const Names& names) {
  std::string out;
  for (const std::string& n : names) out += " " + n;
  return out;
}

namespace {
std::string rational(const cln::cl_RA& q) {
  const std::string above = kernel::digits(cln::cl_RA(cln::numerator(q)));
  if (cln::denominator(q) == 1) return q < 0 ? "(" + above + ")" : above;
  return "(" + above + " / " + kernel::digits(cln::cl_RA(cln::denominator(q))) + ")";
}
std::string sizes(std::initializer_list<int> of) {
  std::string out;
  for (const int k : of) out += std::to_string(k) + " ";
  return out;
}
class Printer {
public:
  Printer(Names names, const Atoms& of) : bound(std::move(names)), atoms(of) {}
  std::string print(Expr e) {
    if (const auto it = atoms.find(e); it != atoms.end()) return it->second;
    switch (e.op()) {
      case Op::Num:
        return rational(e.value());
      case Op::Var:
        return name(e.name());
      case Op::Bound:
        return bound.at(bound.size() - 1 - std::size_t(e.index()));
      case Op::Fun:
        return e.size() == 0 ? name(e.name()) : joined(e, "(" + name(e.name()) + " ", " ", ")");
      case Op::Add:
        return joined(e, "(", " + ", ")");
      case Op::Mul:
        return joined(e, "(", " * ", ")");
      case Op::Pow:
        return joined(e, "(", "", " ^ " + std::to_string(e.exponent()) + ")");
      case Op::Not:
        return joined(e, "(~ ", "", ")");
      case Op::All:
        return quantified(e);
      default:
        return e.sort() == kernel::Sort::Bool ? relation(e) : matrix(e);
    }
  }

private:
  std::string joined(Expr e, const std::string& before, const std::string& between,
                     const std::string& after) {
    std::string out;
    for (Expr a : e.args()) out += (out.empty() ? before : between) + print(a);
    return out + after;
  }
  std::string relation(Expr e) {
    static const std::map<Op, std::string> signs = {
        {Op::Eq, " = "},   {Op::Lt, " < "},   {Op::Le, " <= "},  {Op::And, " /\\ "},
        {Op::Or, " \\/ "}, {Op::Imp, " -> "}, {Op::Iff, " <-> "}};
    return joined(e, "(", signs.at(e.op()), ")");
  }
  std::string quantified(Expr e) {
    const std::string v = "q'" + std::to_string(bound.size());
    const bool integer = e.bound_sort() == kernel::Sort::Int;
    bound.push_back(v);
    const std::string body = print(e.arg(0));
    bound.pop_back();
    return "(forall " + v + " : R, " + (integer ? "isint " + v + " -> " : "") + body + ")";
  }
  std::string matrix(Expr e) {
    const Expr a = e.arg(0);
    switch (e.op()) {
      case Op::Matrix:
        return joined(e, "[", "; ", "]");
      case Op::Times:
        return joined(e, "(mtimes " + sizes({a.rows(), a.cols(), e.cols()}), " ", ")");
      case Op::Transpose:
        return joined(e, "(mtranspose " + sizes({a.rows(), a.cols()}), "", ")");
      case Op::MatrixPower:
        return "(mpow " + sizes({a.rows()}) + print(a) + " (toN " + print(e.arg(1)) + "))";
      case Op::Entry:
        return "(entry " + print(a) + " " + std::to_string(e.index()) + ")";
      default:
        return "(det " + sizes({a.rows()}) + print(a) + ")";
    }
  }

  Names bound;
  const Atoms& atoms;
};
}  // namespace

std::string text(Expr e, const Names& bound, const Atoms& atoms) {
  return Printer(bound, atoms).print(e);
}
Names loose_names(Expr e) {
  Names out;
  for (int k = e.loose(); k > 0; --k) out.push_back("b'" + std::to_string(k - 1));
  return out;
}
Names names_of(const Exprs& variables) {
  Names out;
  for (Expr v : variables) out.push_back(name(v.name()));
  return out;
}
Exprs variables_of(const Exprs& es) {
  std::set<Expr> all;
  for (Expr e : es) all.merge(kernel::free_variables(e));
  return {all.begin(), all.end()};
}
}  // namespace coq
