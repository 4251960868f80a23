// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/formula.hpp"

#include <algorithm>

#include "kernel/names.hpp"
#include "kernel/print.hpp"

namespace render {
namespace {
using kernel::Expr;
using kernel::Exprs;
using kernel::Op;

/// How tightly a piece holds together, loosest first.
enum Level {
  Quantified,
  Implication,
  Disjunction,
  Conjunction,
  Relation,
  Sum,
  Product,
  Power,
  Atom
};

struct Piece {
  std::string text;
  int level = Atom;
  bool minus = false;  // begins with a minus sign
};

class Visitor {
public:
  explicit Visitor(const Style& the_style) : style(the_style) {}

  Piece visit(Expr e) const {
    switch (e.op()) {
      case Op::Num:
        return number(e.value());
      case Op::Var:
        return {style.name(e.name())};
      case Op::Fun:
        return function(e);
      case Op::Add:
        return sum(e);
      case Op::Mul:
      case Op::Times:
        return e.op() == Op::Mul ? product(e) : Piece{style.product(parts(e, Product)), Product};
      case Op::Pow:
        return is_inverse(e)
                   ? product(e)
                   : Piece{style.power(within(Atom, e.arg(0)), std::to_string(e.exponent())),
                           Power};
      case Op::Matrix:
        return {matrix(e)};
      case Op::Transpose:
        return {style.power(within(Atom, e.arg(0)), "T"), Power};
      case Op::MatrixPower:
        return {style.power(within(Atom, e.arg(0)), within(Sum, e.arg(1))), Power};
      case Op::Entry:
        return {style.indexed(within(Atom, e.arg(0)),
                              std::to_string(e.index() / e.arg(0).cols() + 1) + "," +
                                  std::to_string(e.index() % e.arg(0).cols() + 1))};
      case Op::Det:
        return {style.call(style.name("det"), within(Quantified, e.arg(0)))};
      default:
        return statement(e);
    }
  }

private:
  const Style& style;

  std::string within(int least, Expr e) const { return within(least, visit(e)); }
  std::string within(int least, const Piece& piece) const {
    return piece.level < least ? style.parentheses(piece.text) : piece.text;
  }
  Strings parts(Expr e, int least) const {
    Strings out;
    for (const Expr& a : e.args()) out.push_back(within(least, a));
    return out;
  }
  std::string joined(Expr e, const std::string& between, int least) const {
    std::string out;
    for (const std::string& p : parts(e, least))
      out += (out.empty() ? "" : style.word(between)) + p;
    return out;
  }
  Piece number(const cln::cl_RA& q) const {
    const bool minus = q < 0;
    const std::string over = kernel::digits(cln::abs(cln::numerator(q)));
    const std::string under = kernel::digits(cln::denominator(q));
    const std::string size = under == "1" ? over : style.fraction(over, under);
    return {(minus ? "-" : "") + size, minus ? Sum : under == "1" ? Atom : Product, minus};
  }
  Piece sum(Expr e) const {
    std::string out;
    bool minus = false;
    for (const Expr& a : e.args()) {
      const Piece p = visit(a);
      const std::string text = p.minus ? p.text.substr(1) : within(Product, p);
      if (out.empty()) minus = p.minus;
      out += out.empty() ? (p.minus ? "-" : "") : p.minus ? " - " : " + ";
      out += text;
    }
    return {out, Sum, minus};
  }
  static bool is_inverse(Expr e) {
    const Expr base = e.op() == Op::Pow ? e.arg(0) : e;
    return base.op() == Op::Fun && base.name() == "inv";
  }
  /// A quotient with its sign in front.
  Piece product(Expr e) const {
    cln::cl_RA coefficient = 1;
    Strings over;
    Strings under;
    int lone_over = Atom;
    Exprs factors = e.op() == Op::Mul ? e.args() : Exprs{e};
    flatten(factors);
    const auto divisors = std::count_if(factors.begin(), factors.end(), is_inverse);
    for (const Expr& f : factors) {
      if (f.op() == Op::Num) {
        coefficient = coefficient * f.value();
        continue;
      }
      const Expr shown = !is_inverse(f)      ? f
                         : f.op() == Op::Pow ? kernel::power(f.arg(0).arg(0), f.exponent())
                                             : f.arg(0);
      const Piece p = visit(shown);
      lone_over = p.level;
      (is_inverse(f) ? under : over).push_back(p.text);
      // Alone over or under a line nothing needs parentheses.
      const bool alone = is_inverse(f)
                             ? divisors == 1 && cln::denominator(coefficient) == 1
                             : factors.size() == 1 + std::size_t(divisors) && divisors > 0;
      if (!alone && p.level < Product + (p.minus ? 1 : 0))
        (is_inverse(f) ? under : over).back() = style.parentheses(p.text);
    }
    (void)lone_over;
    const bool minus = coefficient < 0;
    const std::string number = kernel::digits(cln::abs(cln::numerator(coefficient)));
    const std::string divisor = kernel::digits(cln::denominator(coefficient));
    if (number != "1" || over.empty()) over.insert(over.begin(), number);
    if (divisor != "1") under.insert(under.begin(), divisor);
    const std::string text = under.empty()
                                 ? style.product(over)
                                 : style.fraction(style.product(over), style.product(under));
    return {(minus ? "-" : "") + text, minus ? Sum : Product, minus};
  }
  static void flatten(Exprs& factors) {
    Exprs out;
    for (const Expr& f : factors) {
      Exprs inner = f.op() == Op::Mul ? f.args() : Exprs{f};
      if (f.op() == Op::Mul) flatten(inner);
      out.insert(out.end(), inner.begin(), inner.end());
    }
    factors = out;
  }
  Piece function(Expr e) const {
    if (e.name() == "inv") return product(e);
    if (e.name() == "sqrt") return {style.root(within(Quantified, e.arg(0)))};
    if (e.name() == "ceil") return {style.ceiling(within(Quantified, e.arg(0)))};
    const kernel::Signature& signature = *kernel::signature(e.name());
    const Exprs args = e.args();
    const bool hide = std::equal(signature.params.begin(), signature.params.end(), args.begin());
    std::string index;
    std::string plain;
    for (std::size_t i = hide ? signature.params.size() : 0; i < args.size(); ++i) {
      std::string& part = signature.args[i] == kernel::Sort::Int ? index : plain;
      part += (part.empty() ? "" : ", ") + within(Quantified, args[i]);
    }
    std::string name = e.name();
    if (name.back() == '_') name.pop_back();
    std::string text = style.name(name);
    if (!index.empty()) text = style.indexed(text, index);
    if (!plain.empty()) text = style.call(text, plain);
    return {text};
  }
  std::string matrix(Expr e) const {
    std::vector<Strings> rows(static_cast<std::size_t>(e.rows()));
    for (std::size_t i = 0; i < e.size(); ++i)
      rows[i / static_cast<std::size_t>(e.cols())].push_back(within(Quantified, e.arg(i)));
    return style.matrix(rows);
  }
  Piece statement(Expr e) const {
    switch (e.op()) {
      case Op::Eq:
        return {joined(e, " = ", Sum), Relation};
      case Op::Lt:
        return {joined(e, " < ", Sum), Relation};
      case Op::Le:
        return {joined(e, " <= ", Sum), Relation};
      case Op::Not:
        if (e.arg(0).op() == Op::Eq) return {joined(e.arg(0), " != ", Sum), Relation};
        return {style.word("not ") + within(Relation, e.arg(0)), Relation};
      case Op::And:
        return {joined(e, " and ", Conjunction + 1), Conjunction};
      case Op::Or:
        return {joined(e, " or ", Disjunction + 1), Disjunction};
      case Op::Imp:
        return {joined(e, " implies ", Implication + 1), Implication};
      case Op::Iff:
        return {joined(e, " if and only if ", Implication + 1), Implication};
      default: {  // for every v, with v as the free variable of its name
        const bool whole = e.bound_sort() == kernel::Sort::Int;
        const Expr v = whole ? kernel::integer(e.name()) : kernel::real(e.name());
        return {style.word(whole ? "for every integer " : "for every real ") +
                    style.name(e.name()) + ": " + within(Quantified, kernel::open(e, v)),
                Quantified};
      }
    }
  }
};
}  // namespace

std::string formula(Expr e, const Style& style) { return Visitor(style).visit(e).text; }
}  // namespace render
