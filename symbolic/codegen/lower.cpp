// SPDX-License-Identifier: GPL-2.0-or-later
// Reads theorems: hypotheses against intervals, definitions and outputs into nodes, facts.
#include "codegen/lower.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "codegen/builder.hpp"
#include "codegen/exact.hpp"
#include "kernel/names.hpp"
#include "kernel/print.hpp"

namespace codegen {
namespace {
using kernel::Expr;
using kernel::Exprs;
using kernel::Theorem;

class Reader {
public:
  Builder builder;

  Reader(const Quantity& quantity, const Case& which, bool is_wide)
      : q(quantity), c(which), wide(is_wide) {
    builder.is_wide = is_wide;
    for (const Input& input : q.inputs) {
      const std::string name = input.variable.name();
      const Interval range = range_of(input, c, wide);
      if (!(range.low >= 0)) throw Refused(name + " may be negative");
      if (input.variable.op() != kernel::Op::Var) throw Refused(name + " is no variable");
      nodes[input.variable] =
          builder.input(identifier(name), input.variable.sort() == kernel::Sort::Int, range);
    }
    for (const Condition& w : c.where) {
      const auto is_it = [&](const Input& i) { return i.variable.name() == w.name; };
      if (std::none_of(q.inputs.begin(), q.inputs.end(), is_it)) {
        throw Refused("a condition on " + w.name + ", which is no input");
      }
    }
    for (const Fact& fact : c.facts) {
      const Expr f = fact.formula;
      if (f.op() == kernel::Op::Eq && f.arg(0).op() == kernel::Op::Pow &&
          f.arg(0).exponent() == 2) {
        squares.insert_or_assign(f.arg(0).arg(0), fact);
      }
    }
  }
  void define(const Theorem& t) {
    const Expr name = head(t);
    const int k = build(t.conclusion().arg(1));
    nodes[name] = k;
    Node& n = builder.program[k];
    if (n.name.empty() && n.op != Op::constant) {
      n.name = identifier(name.name());
      n.formula = kernel::text(t.conclusion());
    }
    named[name.name()] = k;
    if (const auto square = squares.find(name); square != squares.end()) {
      const Expr as = square->second.formula.arg(1);
      if (nodes.count(as) > 0) narrow_by_square(k, square->second);
    }
    // Guards first: a fact's hypotheses may rest on them.
    for (const Condition& g : c.guards) {
      if (g.name != name.name()) continue;
      builder.narrow(k, g.range);
      builder.program.guards.push_back({k, g.range});
    }
    for (const Fact& f : c.facts) use_fact(f, name);
  }
  void output(const Theorem& t) {
    const Expr left = head(t);
    const int k = build(t.conclusion().arg(1));
    const bool is_whole = left.sort() == kernel::Sort::Int;
    if (is_whole && !builder[k].is_whole) throw Refused(left.name() + " is not known to be whole");
    if (is_whole && !wide && builder[k].range.size() > 0x1p51) {
      throw Refused(left.name() + " may be above 2^51");
    }
    auto& list = is_whole ? builder.program.whole_outputs : builder.program.outputs;
    list.push_back({identifier(left.name()), k});
  }
  void check_all_used() const {
    for (const Condition& g : c.guards) {
      if (named.count(g.name) == 0)
        throw Refused("a guard on " + g.name + ", which has no definition");
    }
    for (const Fact& f : c.facts) {
      if (used.count(f.formula) == 0) {
        throw Refused("a fact that no definition is about: " + kernel::text(f.formula));
      }
    }
  }

private:
  const Quantity& q;
  const Case& c;
  bool wide;
  std::map<Expr, int> nodes;
  std::map<std::string, int> named;
  std::map<Expr, Fact> squares;
  std::set<Expr> used;

  Interval range(Expr e) { return builder[build(e)].range; }

  /// A theorem's left side, after all that is to be checked of it.
  Expr head(const Theorem& t) {
    const Expr f = t.conclusion();
    if (f.op() != kernel::Op::Eq || f.arg(0).op() != kernel::Op::Fun) {
      throw Refused("not of the form name(params) = term: " + kernel::text(f));
    }
    check_hypotheses(t.hypotheses(), f);
    const Exprs parameters = kernel::signature(f.arg(0).name())->params;
    for (std::size_t k = 0; k < f.arg(0).size(); ++k) {
      const Expr argument = f.arg(0).arg(k);
      const auto unit = k < parameters.size() ? q.units.find(parameters[k]) : q.units.end();
      if (unit == q.units.end() || !(unit->second == argument)) check_argument(argument, f);
    }
    return f.arg(0);
  }
  void check_argument(Expr argument, Expr formula) const {
    for (const Input& input : q.inputs) {
      if (argument == input.variable) return;
      const Interval r = range_of(input, c, wide);
      const bool is_number = argument.op() == kernel::Op::Num;
      if (is_number && r.is_point() && exact(r.low) == argument.value()) return;
    }
    throw Refused(kernel::text(argument) + " is no input here: " + kernel::text(formula));
  }
  void check_hypotheses(const Exprs& hypotheses, Expr conclusion) {
    for (Expr h : hypotheses) {
      if (!holds(h)) {
        throw Refused("the intervals of case " + c.name + " do not give " + kernel::text(h) +
                      ", which is needed for " + kernel::text(conclusion));
      }
    }
  }
  /// Whether a formula follows from the intervals; a name that is not defined here is not known.
  bool holds(Expr f) {
    const auto all_hold = [&](Expr g) { return holds(g); };
    const Exprs parts = f.args();
    if (f.op() == kernel::Op::And) return std::all_of(parts.begin(), parts.end(), all_hold);
    if (f.op() != kernel::Op::Lt && f.op() != kernel::Op::Le && f.op() != kernel::Op::Eq)
      return false;
    try {
      const Interval l = range(f.arg(0));
      const Interval r = range(f.arg(1));
      if (f.op() == kernel::Op::Lt) return l.high < r.low;
      if (f.op() == kernel::Op::Le) return l.high <= r.low;
      return l.is_point() && r.is_point() && l.low == r.low;
    } catch (const Refused&) {
      return false;
    }
  }

  void narrow_by_square(int k, const Fact& t) {
    check_hypotheses(t.hypotheses, t.formula);
    const Interval size = root(range(t.formula.arg(1)));
    builder.narrow(k, builder[k].range.low >= 0 ? size : Interval{-size.high, size.high});
    used.insert(t.formula);
  }
  static bool mentions(Expr e, Expr what) {
    if (e == what) return true;
    const Exprs args = e.args();
    return std::any_of(args.begin(), args.end(), [&](Expr a) { return mentions(a, what); });
  }
  bool is_known(Expr e) const { return nodes.count(e) > 0; }
  /// p <= q, once its last name is defined: an end of a range, or which of two sizes is larger.
  void use_fact(const Fact& t, Expr last) {
    const Expr f = t.formula;
    if (f.op() == kernel::Op::Eq) return;
    if (f.op() != kernel::Op::Le && f.op() != kernel::Op::Lt) {
      throw Refused("not of the form p <= q or p^2 = q: " + kernel::text(f));
    }
    const Expr small = f.arg(0);
    const Expr large = f.arg(1);
    if (!mentions(f, last)) return;
    const bool of_names = small.op() == kernel::Op::Fun && large.op() == kernel::Op::Fun;
    if (of_names && small.size() > 0 && large.size() > 0) {
      if (!is_known(small) || !is_known(large)) return;
      check_hypotheses(t.hypotheses, f);
      const int s = nodes.at(small);
      const int l = nodes.at(large);
      if (!(builder[s].range.low >= 0)) throw Refused("of unknown sign: " + kernel::text(small));
      builder.program.facts.push_back({s, l, !t.of_computed.empty()});
      builder.narrow(s, {0, builder[l].range.high});
    } else if (small == last) {
      check_hypotheses(t.hypotheses, f);
      builder.narrow(nodes.at(small), {builder[nodes.at(small)].range.low, range(large).high});
    } else if (large == last) {
      check_hypotheses(t.hypotheses, f);
      builder.narrow(nodes.at(large), {range(small).low, builder[nodes.at(large)].range.high});
    } else {
      return;
    }
    used.insert(f);
  }

  int build(Expr e) {
    if (const auto found = nodes.find(e); found != nodes.end()) return found->second;
    return nodes[e] = made(e);
  }
  int made(Expr e) {
    switch (e.op()) {
      case kernel::Op::Num:
        return builder.constant(e.value());
      case kernel::Op::Add: {
        int s = build(e.arg(0));
        for (std::size_t k = 1; k < e.size(); ++k) s = builder.sum(s, build(e.arg(k)));
        return s;
      }
      case kernel::Op::Mul:
        return product(e.args());
      case kernel::Op::Pow: {
        const int base = build(e.arg(0));
        int p = base;
        for (int k = 1; k < e.exponent(); ++k) p = builder.product(p, base);
        return p;
      }
      case kernel::Op::Fun:
        return function(e);
      case kernel::Op::Var:
        throw Refused(kernel::text(e) + " is no input");
      default:
        throw Refused("no operation for " + kernel::text(e));
    }
  }
  int function(Expr e) {
    const std::string f = e.name();
    if (f == "pi" && e.size() == 0) return builder.constant(1, true);
    if (f == "inv") return product({e});
    if (f == "sqrt") {
      const Expr x = e.arg(0);
      if (x.op() == kernel::Op::Pow && x.exponent() == 2) {
        return builder.unary(Op::size, build(x.arg(0)));
      }
      const int k = build(x);
      return builder.product(k, builder.unary(Op::reciprocal_root, k));
    }
    if (f == "sin") return builder.unary(Op::sine, build(e.arg(0)));
    if (f == "cos") return builder.unary(Op::cosine, build(e.arg(0)));
    if (f == "atan") return arc_tangent(e);
    if (f == "ceil") return ceiling(e.arg(0));
    throw Refused("no definition of " + kernel::text(e));
  }
  int arc_tangent(Expr e) {
    const auto square = squares.find(e.arg(0));
    if (square == squares.end()) {
      throw Refused("an arctangent needs a fact about the square: " + kernel::text(e));
    }
    const int t = build(e.arg(0));
    narrow_by_square(t, square->second);
    return builder.arc_tangent(t, build(square->second.formula.arg(1)));
  }

  /// Numbers, what is above and what is below the line.
  struct Fraction {
    cln::cl_RA factor = 1;
    Exprs above = {};
    Exprs below = {};
  };
  static Fraction fraction(const Exprs& factors) {
    Fraction r;
    for (Expr f : factors) {
      const bool is_inverse = f.op() == kernel::Op::Fun && f.name() == "inv";
      if (f.op() == kernel::Op::Num) {
        r.factor = r.factor * f.value();
      } else if (!is_inverse) {
        r.above.push_back(f);
      } else {
        const Expr x = f.arg(0);
        const Exprs inner = x.op() == kernel::Op::Mul ? x.args() : Exprs{x};
        for (Expr g : inner) {
          if (g.op() != kernel::Op::Num) {
            r.below.push_back(g);
          } else if (g.value() != 0) {
            r.factor = r.factor / g.value();
          } else {
            throw Refused("a divisor that is 0");
          }
        }
      }
    }
    return r;
  }
  int product(const Exprs& factors) {
    const Fraction f = fraction(factors);
    double power = 1;
    std::vector<int> numbers;
    std::vector<int> exact_ones;
    const auto take = [&](int k) { (builder[k].is_exact ? exact_ones : numbers).push_back(k); };
    std::vector<int> below;
    for (Expr e : f.above) take(build(e));
    for (Expr e : f.below) {
      const bool is_root = e.op() == kernel::Op::Fun && e.name() == "sqrt";
      const bool is_size = is_root && e.arg(0).op() == kernel::Op::Pow;
      if (is_root && !is_size) {
        take(builder.unary(Op::reciprocal_root, build(e.arg(0))));
      } else {
        below.push_back(build(e));
      }
    }
    if (is_double(f.factor) && is_power_of_2(nearest(f.factor))) {
      power = nearest(f.factor);
    } else {
      take(builder.constant(f.factor));
    }
    int p = -1;
    const auto multiply = [&](int k) {
      const Node& n = builder[k];
      const bool is_scaled = n.op == Op::scale || n.op == Op::exact_scale;
      if (is_scaled && numbers.size() + exact_ones.size() > 1) {
        power *= n.factor;
        k = n.of[0];
      }
      p = p < 0 ? k : builder.product(p, k);
    };
    for (int k : numbers) multiply(k);
    for (int k : exact_ones) {
      // The power of two goes into a number that is scaled exactly, once.
      if (p >= 0) {
        k = builder.scaled(k, power);
        power = 1;
        p = builder.product(p, k);
      } else {
        multiply(k);
      }
    }
    for (int k : below) p = builder.quotient(p < 0 ? builder.constant(1) : p, k);
    if (p < 0) return builder.constant(f.factor);
    return builder.scaled(p, power);
  }
  /// ceil(p/q + c), c a whole number or half of an odd one.
  int ceiling(Expr x) {
    const Exprs terms = x.op() == kernel::Op::Add ? x.args() : Exprs{x};
    cln::cl_RA c_ = 0;
    Exprs rest;
    for (Expr t : terms) {
      if (t.op() == kernel::Op::Num) {
        c_ = c_ + t.value();
      } else {
        rest.push_back(t);
      }
    }
    if (rest.size() != 1) throw Refused("not of the form ceil(p/q + c): " + kernel::text(x));
    const bool is_product = rest[0].op() == kernel::Op::Mul;
    const Fraction f = fraction(is_product ? rest[0].args() : Exprs{rest[0]});
    Exprs above = f.above;
    above.insert(above.begin(), Expr(f.factor));
    if (f.below.empty()) throw Refused("not of the form ceil(p/q + c): " + kernel::text(x));
    const int p = product(above);
    const int q_ = product(f.below);
    if (cln::denominator(c_) == 1) return builder.ceiling(p, q_, c_);
    if (cln::denominator(c_) == 2) {
      const int k = builder.nearest(p, q_);
      return builder.sum(k, builder.constant(c_ + cln::cl_RA(1) / 2));
    }
    throw Refused("not of the form ceil(p/q + c), c half of a whole number: " + kernel::text(x));
  }
};
}  // namespace

Interval range_of(const Input& input, const Case& which, bool is_wide) {
  Interval r = is_wide ? input.wide_range : input.range;
  for (const Condition& w : which.where) {
    if (w.name == input.variable.name()) r = meet(r, w.range);
  }
  return r;
}

Program lower(const Quantity& quantity, const Case& which, bool is_wide) {
  Reader reader(quantity, which, is_wide);
  for (const Theorem& t : which.definitions) reader.define(t);
  for (const Theorem& t : which.outputs) reader.output(t);
  reader.check_all_used();
  return named(in_stages(without_dead_code(reader.builder.program)));
}
}  // namespace codegen
