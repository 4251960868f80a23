// SPDX-License-Identifier: GPL-2.0-or-later
// The printer. Each piece is printed with its level; bracketed() is the only place that adds
// brackets.

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>

#include <cln/rational_io.h>

#include "kernel/names.hpp"

namespace kernel {
namespace {
enum Level { Every, Implies, Or, And, Relation, Sum, Minus, Product, Power, Atom };

struct Piece {
  std::string words;
  int level = Atom;
};
using Names = std::vector<std::string>;  // of the bound variables, outermost first
Piece print(Expr e, const Names& names);

std::string bracketed(const Piece& p, int least) {
  return p.level < least ? "(" + p.words + ")" : p.words;
}
std::string at_least(int level, Expr e, const Names& names) {
  return bracketed(print(e, names), level);
}
std::string joined(const Exprs& es, std::string_view between, int level, const Names& names) {
  std::string out;
  for (Expr e : es) out += std::string(out.empty() ? "" : between) + at_least(level, e, names);
  return out;
}

std::string bound_name(Expr e, const Names& names) {
  const std::size_t i = std::size_t(e.index());
  return i < names.size() ? names[names.size() - 1 - i] : "?" + std::to_string(i - names.size());
}

// inv(d) or inv(d)^k as operator/ makes it: shown below the line of a fraction.
bool is_inverse(Expr e) {
  const Expr base = e.op() == Op::Pow ? e.arg(0) : e;
  if (base.op() != Op::Fun || base.name() != "inv") return false;
  const Op of = base.arg(0).op();
  return of != Op::Num && of != Op::Mul && of != Op::Pow;
}
Expr inverted(Expr e) {
  return e.op() == Op::Pow ? power(e.arg(0).arg(0), e.exponent()) : e.arg(0);
}
std::string chain(const Exprs& factors, const Names& names) {
  std::string out = at_least(Power, factors[0], names);
  for (std::size_t i = 1; i < factors.size(); ++i) {
    const bool under = is_inverse(factors[i]);
    const Expr shown = under ? inverted(factors[i]) : factors[i];
    out += (under ? "/" : "*") + at_least(Power, shown, names);
  }
  return out;
}
// As a fraction with its sign in front, if operators - * / make this very tree from it.
std::optional<Piece> print_fraction(Expr e, const Names& names) {
  Exprs top = e.op() == Op::Mul ? e.args() : Exprs{e};
  Exprs under;
  cln::cl_RA number = 1;
  if (top[0].op() == Op::Num) {
    number = top[0].value();
    top.erase(top.begin());
  }
  while (!top.empty() && is_inverse(top.back())) {
    under.insert(under.begin(), inverted(top.back()));
    top.pop_back();
  }
  const cln::cl_RA above = cln::abs(cln::numerator(number));
  const cln::cl_RA below = cln::denominator(number);
  if (above != 1 || top.empty()) top.insert(top.begin(), Expr(above));
  if (below != 1) under.insert(under.begin(), Expr(below));
  Expr rebuilt = product(top);
  if (!under.empty()) rebuilt = rebuilt / product(under);
  if (number < 0) rebuilt = -rebuilt;
  if (!(rebuilt == e)) return {};
  std::string words = (number < 0 ? "-" : "") + chain(top, names);
  if (!under.empty()) {
    const int level = under.size() > 1 ? Product : Atom;
    words += "/" + bracketed({joined(under, "*", Power, names), level}, Power);
  }
  return Piece{words, number < 0 ? Minus : Product};
}
Piece print_product(Expr e, const Names& names) {
  if (auto fraction = print_fraction(e, names)) return *fraction;
  Exprs factors = e.args();
  Piece out{"", Product};
  if (factors[0].op() == Op::Num) {
    out = {digits(factors[0].value()) + "*", factors[0].value() < 0 ? Minus : Product};
    factors.erase(factors.begin());
  }
  out.words += chain(factors, names);
  return out;
}
Piece print_sum(Expr e, const Names& names) {
  std::string out;
  for (Expr a : e.args()) {
    const std::string term = at_least(Minus, a, names);
    out += out.empty() ? term : term[0] == '-' ? " - " + term.substr(1) : " + " + term;
  }
  return {out, Sum};
}

// An index or a matrix's exponent that stands without brackets.
bool is_short(Expr e) {
  if (e.op() == Op::Num) return e.value() >= 0 && e.sort() == Sort::Int;
  return e.op() == Op::Var || e.op() == Op::Bound;
}
std::string print_index(const std::string& name, const Exprs& index, const Names& names) {
  const std::string words = joined(index, ", ", Sum, names);
  const bool plain = index.size() == 1 && is_short(index[0]) &&
                     words.find('_') == std::string::npos && !is_known(stem(name) + words);
  return stem(name).substr(name.size()) + bracketed({words, plain ? Atom : Sum}, Atom);
}
Piece print_function(Expr e, const Names& names) {
  const Signature& s = *signature(e.name());
  const Exprs args = e.args();
  const bool hide = std::equal(s.params.begin(), s.params.end(), args.begin());
  Exprs index, plain;
  for (std::size_t i = hide ? s.params.size() : 0; i < args.size(); ++i)
    (s.args[i] == Sort::Int ? index : plain).push_back(args[i]);
  std::string words = e.name();
  if (!index.empty()) words += print_index(e.name(), index, names);
  if (!plain.empty()) words += "(" + joined(plain, ", ", Sum, names) + ")";
  return {words};
}

Piece print_matrix(Expr e, const Names& names) {
  std::string out;
  for (int i = 0; i < e.rows() * e.cols(); ++i) {
    if (i > 0) out += i % e.cols() == 0 ? "; " : ", ";
    out += at_least(Sum, e.arg(std::size_t(i)), names);
  }
  return {"[" + out + "]"};
}
Piece print_matrix_power(Expr e, const Names& names) {
  const std::string exponent = at_least(Sum, e.arg(1), names);
  const bool plain = is_short(e.arg(1)) && exponent != "T";  // A^T is the transpose
  return {at_least(Atom, e.arg(0), names) + "^" + bracketed({exponent, plain ? Atom : Sum}, Atom),
          Power};
}
Piece print_entry(Expr e, const Names& names) {
  const int cols = e.arg(0).cols();
  return {at_least(Atom, e.arg(0), names) + "[" + std::to_string(e.index() / cols + 1) + "," +
          std::to_string(e.index() % cols + 1) + "]"};
}

// A name for the bound variable that is nothing else here: x, x', x2, x3, ...
std::string fresh(Expr quantified, const Names& names) {
  const std::string wanted = quantified.name();
  const std::set<Expr> free = free_variables(quantified);
  const auto taken = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return true;
    if (!why_no_variable(name, quantified.bound_sort()).empty()) return true;
    return std::any_of(free.begin(), free.end(), [&](Expr v) { return v.name() == name; });
  };
  if (!taken(wanted)) return wanted;
  const std::string start = wanted.substr(0, wanted.find('\''));
  std::string out = start + "'";
  for (int k = 2; taken(out); ++k) out = start + std::to_string(k);
  return out;
}
Piece print_all(Expr e, const Names& names) {
  Names inner = names;
  inner.push_back(fresh(e, names));
  std::string range;
  Expr body = e.arg(0);
  const bool from = body.op() == Op::Imp && body.arg(0).op() == Op::Le;
  if (from && body.arg(0).arg(1).op() == Op::Bound && body.arg(0).arg(1).index() == 0) {
    range = " >= " + at_least(Sum, body.arg(0).arg(0), inner);
    body = body.arg(1);
  }
  const std::string sort = e.bound_sort() == Sort::Int ? "integer " : "real ";
  return {"for every " + sort + inner.back() + range + ": " + at_least(Every, body, inner), Every};
}
Piece print_not(Expr f, const Names& names) {
  if (f.op() == Op::Eq) return {joined(f.args(), " != ", Sum, names), Relation};
  return {"not " + at_least(Atom, f, names), Relation};
}

Piece print(Expr e, const Names& names) {
  if (is_inverse(e))
    if (const auto fraction = print_fraction(e, names)) return *fraction;
  switch (e.op()) {
    case Op::Num:
      return {digits(e.value()), e.value() < 0 ? Minus : e.sort() == Sort::Real ? Product : Atom};
    case Op::Var:
      return {e.name()};
    case Op::Bound:
      return {bound_name(e, names)};
    case Op::Fun:
      return print_function(e, names);
    case Op::Add:
      return print_sum(e, names);
    case Op::Mul:
      return print_product(e, names);
    case Op::Pow:
      return {at_least(Atom, e.arg(0), names) + "^" + std::to_string(e.exponent()), Power};
    case Op::Not:
      return print_not(e.arg(0), names);
    case Op::All:
      return print_all(e, names);
    case Op::Matrix:
      return print_matrix(e, names);
    case Op::Times:
      return {at_least(Product, e.arg(0), names) + " " + at_least(Power, e.arg(1), names), Product};
    case Op::Transpose:
      return {at_least(Atom, e.arg(0), names) + "^T", Power};
    case Op::MatrixPower:
      return print_matrix_power(e, names);
    case Op::Entry:
      return print_entry(e, names);
    case Op::Det:
      return {"det(" + at_least(Sum, e.arg(0), names) + ")"};
    case Op::Eq:
      return {joined(e.args(), " = ", Sum, names), Relation};
    case Op::Lt:
      return {joined(e.args(), " < ", Sum, names), Relation};
    case Op::Le:
      return {joined(e.args(), " <= ", Sum, names), Relation};
    case Op::And:
      return {joined(e.args(), " and ", Relation, names), And};
    case Op::Or:
      return {joined(e.args(), " or ", Relation, names), Or};
    case Op::Imp:
      return {joined(e.args(), " implies ", Or, names), Implies};
    case Op::Iff:
      return {joined(e.args(), " if and only if ", Or, names), Implies};
  }
  refuse("no such operation");
}
}  // namespace

std::string digits(const cln::cl_RA& q) {
  std::ostringstream out;
  cln::print_rational(out, 10, q);
  return out.str();
}
std::string text(Expr e) {
  if (e.loose()) refuse("a tree with a loose index is not printed");
  if (e.weight() > 200000) refuse("a tree of more than 200000 nodes is not printed");
  return print(e, {}).words;
}
std::string brief(Expr e) {
  if (e.weight() > 5000) return "a tree of " + std::to_string(e.weight()) + " nodes";
  const std::string words = print(e, {}).words;
  return words.size() <= 200 ? words : words.substr(0, 200) + " ...";
}
}  // namespace kernel
