// The one visitor of formulas: it decides structure, parentheses and signs; a notation writes them.
#pragma once

#include <algorithm>

#include "kernel/names.hpp"
#include "render/pages.hpp"

namespace render {
using Strings = std::vector<std::string>;

/// Of a variable or function: c'_n has head c, a prime, index n.
struct Name {
  std::string head;
  bool is_primed;
  std::string index;  ///< or empty
};
/// Letters that are written as words, and themselves.
inline const std::map<std::string, std::string> greek{
    {"lambda", "λ"}, {"Lambda", "Λ"}, {"Gamma", "Γ"}, {"alpha", "α"},
    {"theta", "θ"},  {"kappa", "κ"},  {"delta", "δ"}, {"beta", "β"},
    {"psi", "ψ"},    {"pi", "π"},     {"rho", "ρ"},   {"tau", "τ"}};

using kernel::Expr;
using kernel::Exprs;
using kernel::Op;

/// A name in words, as a formula has it.
std::string latex_name(const std::string& head, const std::string& index);
std::string mathml_name(const std::string& head, const std::string& index);

/// How tightly a piece holds together, loosest first.
enum Level { Quantified, Implication, Or, And, Relation, Sum, Product, Power, Atom };

struct Piece {
  std::string text;  // without its minus sign
  int level = Atom;  // with it
  bool minus = false;
};

/// What stands around a part, or two, in a notation.
struct Frame {
  std::string before = {}, between = {}, after = {};
  std::string of(const std::string& one, const std::string& other = "") const {
    return before + one + between + other + after;
  }
};
struct Frames {
  Frame number, call, fraction, root, ceiling, parentheses;
};
class Visitor {
public:
  explicit Visitor(const Frames& all) : frames(all) {}
  virtual ~Visitor() = default;
  std::string text(Expr e) const { return whole(visit(e)); }

protected:
  const Frames frames;
  // How a notation writes what is decided here.
  virtual std::string name(const Name& name) const = 0;
  virtual std::string indexed(const std::string& base, const std::string& index) const = 0;
  virtual std::string power(const std::string& base, const std::string& exponent) const = 0;
  virtual std::string matrix(const std::vector<Strings>& rows) const = 0;
  virtual std::string before_factor(const std::string& factor) const = 0;  ///< the sign
  /// What stands between terms and formulas: " + ", "-", " <= ", " and ", "for every integer ".
  virtual std::string word(const std::string& word) const = 0;
  static bool is_sign(const std::string& word) { return std::ranges::none_of(word, ::islower); }

private:
  Piece visit(Expr e) const {
    switch (e.op()) {
      case Op::Num:
        return rational(e.value());
      case Op::Var:
        return {name(e.name())};
      case Op::Fun:
        return function(e);
      case Op::Add:
        return sum(e);
      case Op::Mul:
      case Op::Times:
        return e.op() == Op::Mul ? product(e) : Piece{product(parts(e, Product)), Product};
      case Op::Pow:
        return is_inverse(e) ? product(e)
                             : Piece{power(within(Atom, e.arg(0)), number(e.exponent())), Power};
      case Op::Matrix:
        return {matrix(e)};
      case Op::Transpose:
        return {power(within(Atom, e.arg(0)), name("T")), Power};
      case Op::MatrixPower:
        return {power(within(Atom, e.arg(0)), within(Sum, e.arg(1))), Power};
      case Op::Entry:
        return {indexed(within(Atom, e.arg(0)), number(e.index() / e.arg(0).cols() + 1) +
                                                    word(",") +
                                                    number(e.index() % e.arg(0).cols() + 1))};
      case Op::Det:
        return {frames.call.of(name("det"), within(Quantified, e.arg(0)))};
      default:
        return statement(e);
    }
  }

  std::string within(int least, Expr e) const { return within(least, visit(e)); }
  std::string within(int least, const Piece& piece) const {
    return piece.level < least ? frames.parentheses.of(whole(piece)) : whole(piece);
  }
  std::string whole(const Piece& piece) const {
    return (piece.minus ? word("-") : "") + piece.text;
  }
  std::string name(const std::string& text) const {
    const bool is_primed = text.ends_with('\'');
    const std::string plain = text.substr(0, text.size() - (is_primed ? 1 : 0));
    const std::size_t end = std::min(plain.find('_'), plain.size());
    return name({plain.substr(0, end), is_primed, plain.substr(end).erase(0, 1)});
  }
  std::string number(const cln::cl_I& n) const { return frames.number.of(kernel::digits(n)); }
  Strings parts(Expr e, int least) const {
    Strings out;
    for (const Expr& a : e.args()) out.push_back(within(least, a));
    return out;
  }
  std::string joined(Expr e, const std::string& between, int least) const {
    std::string out;
    for (const std::string& p : parts(e, least)) out += (out.empty() ? "" : word(between)) + p;
    return out;
  }
  Piece rational(const cln::cl_RA& q) const {
    const std::string over = number(cln::abs(cln::numerator(q)));
    const bool is_whole = cln::denominator(q) == 1;
    return {is_whole ? over : frames.fraction.of(over, number(cln::denominator(q))),
            q < 0      ? Sum
            : is_whole ? Atom
                       : Product,
            q < 0};
  }
  Piece sum(Expr e) const {
    Piece out{"", Sum};
    for (const Expr& a : e.args()) {
      const Piece piece = visit(a);
      if (out.text.empty())
        out.minus = piece.minus;
      else
        out.text += word(piece.minus ? " - " : " + ");
      out.text += piece.minus ? piece.text : within(Product, piece);
    }
    return out;
  }
  std::string product(const Strings& factors) const {
    std::string out;
    for (const std::string& factor : factors)
      out += (out.empty() ? "" : before_factor(factor)) + factor;
    return out;
  }
  static bool is_inverse(Expr e) { return is_call(e.op() == Op::Pow ? e.arg(0) : e, "inv"); }
  /// A quotient with its sign in front.
  Piece product(Expr e) const {
    cln::cl_RA coefficient = 1;
    std::vector<Piece> over, under;
    for (const Expr& f : factors_of(e)) {
      if (f.op() == Op::Num) {
        coefficient = coefficient * f.value();
        continue;
      }
      const Expr shown = !is_inverse(f)      ? f
                         : f.op() == Op::Pow ? kernel::power(f.arg(0).arg(0), f.exponent())
                                             : f.arg(0);
      (is_inverse(f) ? under : over).push_back(visit(shown));
    }
    const cln::cl_I times = cln::abs(cln::numerator(coefficient)),
                    parts = cln::denominator(coefficient);
    if (times != 1 || over.empty()) over.insert(over.begin(), {number(times)});
    if (parts != 1) under.insert(under.begin(), {number(parts)});
    const auto line = [&](const std::vector<Piece>& all) {  // alone on it nothing needs parentheses
      Strings out;
      for (const Piece& p : all)
        out.push_back((all.size() == 1 && !under.empty()) || (p.level >= Product && !p.minus)
                          ? whole(p)
                          : frames.parentheses.of(whole(p)));
      return product(out);
    };
    const std::string text =
        under.empty() ? line(over) : frames.fraction.of(line(over), line(under));
    return {text, coefficient < 0 ? Sum : Product, coefficient < 0};
  }
  static Exprs factors_of(Expr e) {
    if (e.op() != Op::Mul) return {e};
    Exprs out;
    for (const Expr& arg : e.args()) {
      const Exprs inner = factors_of(arg);
      out.insert(out.end(), inner.begin(), inner.end());
    }
    return out;
  }
  Piece function(Expr e) const {
    if (e.name() == "inv") return product(e);
    if (e.name() == "sqrt") return {frames.root.of(within(Quantified, e.arg(0)))};
    if (e.name() == "ceil") return {frames.ceiling.of(within(Quantified, e.arg(0)))};
    const kernel::Signature& signature = *kernel::signature(e.name());
    const Exprs args = e.args();
    const bool hide = std::equal(signature.params.begin(), signature.params.end(), args.begin());
    std::string index, plain;
    for (std::size_t i = hide ? signature.params.size() : 0; i < args.size(); ++i) {
      std::string& part = signature.args[i] == kernel::Sort::Int ? index : plain;
      part += (part.empty() ? "" : word(signature.separator(i))) + within(Quantified, args[i]);
    }
    std::string text = name(e.name());
    if (!index.empty()) text = indexed(text, index);
    if (!plain.empty()) text = frames.call.of(text, plain);
    return {text};
  }
  std::string matrix(Expr e) const {
    std::vector<Strings> rows(static_cast<std::size_t>(e.rows()));
    for (std::size_t i = 0; i < e.size(); ++i)
      rows[i / static_cast<std::size_t>(e.cols())].push_back(within(Quantified, e.arg(i)));
    return matrix(rows);
  }
  Piece statement(Expr e) const {
    static const std::vector<std::tuple<Op, const char*, Level>> infix{
        {Op::Eq, " = ", Relation},
        {Op::Lt, " < ", Relation},
        {Op::Le, " <= ", Relation},
        {Op::And, " and ", And},
        {Op::Or, " or ", Or},
        {Op::Imp, " implies ", Implication},
        {Op::Iff, " if and only if ", Implication}};
    for (const auto& [op, word, level] : infix)
      if (op == e.op()) return {joined(e, word, level + 1), level};
    if (e.op() == Op::Not) {
      if (e.arg(0).op() == Op::Eq) return {joined(e.arg(0), " != ", Sum), Relation};
      return {word("not ") + within(Relation, e.arg(0)), Relation};
    }
    // For every v, with v as the free variable of its name.
    const bool whole = e.bound_sort() == kernel::Sort::Int;
    const Expr v = whole ? kernel::integer(e.name()) : kernel::real(e.name());
    return {word(whole ? "for every integer " : "for every real ") + name(e.name()) + word(": ") +
                within(Quantified, kernel::open(e, v)),
            Quantified};
  }
};
}  // namespace render
