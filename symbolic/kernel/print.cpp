// The printer. Each piece is printed with its level; what binds less than it must gets brackets.
#include <algorithm>
#include <optional>
#include <sstream>
#include <tuple>

#include <cln/rational_io.h>

#include "kernel/names.hpp"

namespace kernel {
namespace {
enum Level { Every, Implies, Or, And, Relation, Sum, Minus, Product, Power, Atom };

struct Piece {
  std::string words;
  int level = Atom;
};

std::string bracketed(const Piece& p, int least) {
  return p.level < least ? "(" + p.words + ")" : p.words;
}
// inv(d) or inv(d)^k as operator/ makes it: shown below the line of a fraction.
bool is_inverse(Expr e) {
  const Expr base = e.op() == Op::Pow ? e.arg(0) : e;
  if (!is_call(base, "inv")) return false;
  const Op of = base.arg(0).op();
  return of != Op::Num && of != Op::Mul && of != Op::Pow;
}
Expr inverted(Expr e) {
  return e.op() == Op::Pow ? power(e.arg(0).arg(0), e.exponent()) : e.arg(0);
}

class Printer {
public:
  Piece print(Expr e) {
    if (is_inverse(e))
      if (const auto fraction = print_fraction(e)) return *fraction;
    // What stands between two arguments, how strongly these must bind, and how the whole does.
    static const std::map<Op, std::tuple<const char*, Level, Level>> between{
        {Op::Eq, {" = ", Sum, Relation}},
        {Op::Lt, {" < ", Sum, Relation}},
        {Op::Le, {" <= ", Sum, Relation}},
        {Op::And, {" and ", Relation, And}},
        {Op::Or, {" or ", Relation, Or}},
        {Op::Imp, {" implies ", Or, Implies}},
        {Op::Iff, {" if and only if ", Or, Implies}}};
    if (const auto it = between.find(e.op()); it != between.end()) {
      const auto& [words, least, level] = it->second;
      return {joined(e.args(), words, least), level};
    }
    switch (e.op()) {
      case Op::Num:
        return {digits(e.value()), e.value() < 0 ? Minus : e.sort() == Sort::Real ? Product : Atom};
      case Op::Var:
        return {e.name()};
      case Op::Bound:
        return {bound_name(e)};
      case Op::Fun:
        return print_function(e);
      case Op::Add:
        return print_sum(e);
      case Op::Mul:
        return print_product(e);
      case Op::Pow:
        return {at_least(Atom, e.arg(0)) + "^" + std::to_string(e.exponent()), Power};
      case Op::Not:
        if (e.arg(0).op() == Op::Eq) return {joined(e.arg(0).args(), " != ", Sum), Relation};
        return {"not " + at_least(Atom, e.arg(0)), Relation};
      case Op::All:
        return print_all(e);
      case Op::Matrix:
        return print_matrix(e);
      case Op::Times:
        return {at_least(Product, e.arg(0)) + " " + at_least(Power, e.arg(1)), Product};
      case Op::Transpose:
        return {at_least(Atom, e.arg(0)) + "^T", Power};
      case Op::MatrixPower:
        return print_matrix_power(e);
      case Op::Entry:
        return print_entry(e);
      case Op::Det:
        return {"det(" + at_least(Sum, e.arg(0)) + ")"};
      default:
        refuse("no such operation");
    }
  }

private:
  std::vector<std::string> names = {};  // of the bound variables, outermost first

  std::string at_least(int level, Expr e) { return bracketed(print(e), level); }
  std::string joined(const Exprs& es, std::string_view between, int level) {
    std::string out;
    for (Expr e : es) out += std::string(out.empty() ? "" : between) + at_least(level, e);
    return out;
  }
  std::string bound_name(Expr e) {
    const std::size_t i = std::size_t(e.index());
    return i < names.size() ? names[names.size() - 1 - i] : "?" + std::to_string(i - names.size());
  }
  std::string chain(const Exprs& factors) {
    std::string out = at_least(Power, factors[0]);
    for (std::size_t i = 1; i < factors.size(); ++i) {
      const bool under = is_inverse(factors[i]);
      out += (under ? "/" : "*") + at_least(Power, under ? inverted(factors[i]) : factors[i]);
    }
    return out;
  }
  // As a fraction with its sign in front, if operators - * / make this very tree from it.
  std::optional<Piece> print_fraction(Expr e) {
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
    std::string words = (number < 0 ? "-" : "") + chain(top);
    if (!under.empty()) {
      const int level = under.size() > 1 ? Product : Atom;
      words += "/" + bracketed({joined(under, "*", Power), level}, Power);
    }
    return Piece{words, number < 0 ? Minus : Product};
  }
  Piece print_product(Expr e) {
    if (auto fraction = print_fraction(e)) return *fraction;
    Exprs factors = e.args();
    Piece out{"", Product};
    if (factors[0].op() == Op::Num) {
      out = {digits(factors[0].value()) + "*", factors[0].value() < 0 ? Minus : Product};
      factors.erase(factors.begin());
    }
    out.words += chain(factors);
    return out;
  }
  Piece print_sum(Expr e) {
    std::string out;
    for (Expr a : e.args()) {
      const std::string term = at_least(Minus, a);
      out += out.empty() ? term : term[0] == '-' ? " - " + term.substr(1) : " + " + term;
    }
    return {out, Sum};
  }

  // An index or a matrix's exponent that stands without brackets.
  bool is_short(Expr e) {
    if (e.op() == Op::Num) return e.value() >= 0 && e.sort() == Sort::Int;
    return e.op() == Op::Var || e.op() == Op::Bound;
  }
  std::string print_index(const std::string& name, const Exprs& index) {
    const std::string words = joined(index, ", ", Sum);
    const bool plain = index.size() == 1 && is_short(index[0]) &&
                       words.find('_') == std::string::npos && !is_known(stem(name) + words);
    return stem(name).substr(name.size()) + (plain ? words : "(" + words + ")");
  }
  Piece print_function(Expr e) {
    const Signature& s = *signature(e.name());
    const Exprs args = e.args();
    const bool hide = std::equal(s.params.begin(), s.params.end(), args.begin());
    Exprs index;
    std::string plain;
    for (std::size_t i = hide ? s.params.size() : 0; i < args.size(); ++i)
      if (s.args[i] == Sort::Int)
        index.push_back(args[i]);
      else
        plain += (plain.empty() ? "" : s.separator(i)) + at_least(Sum, args[i]);
    std::string words = e.name();
    if (!index.empty()) words += print_index(e.name(), index);
    if (!plain.empty()) words += "(" + plain + ")";
    return {words};
  }

  Piece print_matrix(Expr e) {
    std::string out;
    for (int i = 0; i < e.rows() * e.cols(); ++i) {
      if (i > 0) out += i % e.cols() == 0 ? "; " : ", ";
      out += at_least(Sum, e.arg(std::size_t(i)));
    }
    return {"[" + out + "]"};
  }
  Piece print_matrix_power(Expr e) {
    const std::string exponent = at_least(Sum, e.arg(1));
    const bool plain = is_short(e.arg(1)) && exponent != "T";  // A^T is the transpose
    return {at_least(Atom, e.arg(0)) + "^" + (plain ? exponent : "(" + exponent + ")"), Power};
  }
  Piece print_entry(Expr e) {
    const int cols = e.arg(0).cols();
    return {at_least(Atom, e.arg(0)) + "[" + std::to_string(e.index() / cols + 1) + "," +
            std::to_string(e.index() % cols + 1) + "]"};
  }

  // A name for the bound variable that is nothing else here: x, x', x2, ...; x100 where x is none.
  std::string fresh(Expr quantified) {
    const std::string wanted = quantified.name();
    const std::set<Expr> free = free_variables(quantified);
    const auto taken = [&](const std::string& name) {
      if (std::find(names.begin(), names.end(), name) != names.end()) return true;
      if (!why_no_variable(name, quantified.bound_sort()).empty()) return true;
      return std::any_of(free.begin(), free.end(), [&](Expr v) { return v.name() == name; });
    };
    if (!taken(wanted)) return wanted;
    const std::string start = wanted.substr(0, std::min<std::size_t>(wanted.find('\''), 40));
    std::string out = start + "'";
    for (int k = 2; taken(out); ++k) out = (k < 100 ? start : "x") + std::to_string(k);
    return out;
  }
  Piece print_all(Expr e) {
    const std::string name = fresh(e);
    names.push_back(name);
    std::string range;
    Expr body = e.arg(0);
    const bool from = body.op() == Op::Imp && body.arg(0).op() == Op::Le;
    if (from && body.arg(0).arg(1).op() == Op::Bound && body.arg(0).arg(1).index() == 0) {
      range = " >= " + at_least(Sum, body.arg(0).arg(0));
      body = body.arg(1);
    }
    const std::string sort = e.bound_sort() == Sort::Int ? "integer " : "real ";
    const std::string words = "for every " + sort + name + range + ": " + at_least(Every, body);
    names.pop_back();
    return {words, Every};
  }
};
}  // namespace

std::string digits(const cln::cl_RA& q) {
  std::ostringstream out;
  cln::print_rational(out, 10, q);
  return out.str();
}
std::string text(Expr e) {
  if (e.loose()) refuse("a tree with a loose index is not printed");
  if (e.weight() > 200000) refuse("a tree of more than 200000 nodes is not printed");
  return Printer().print(e).words;
}
std::string brief(Expr e) {
  if (e.weight() > 5000) return "a tree of " + std::to_string(e.weight()) + " nodes";
  const std::string words = Printer().print(e).words;
  return words.size() <= 200 ? words : words.substr(0, 200) + " ...";
}
}  // namespace kernel
