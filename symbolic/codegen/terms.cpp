// SPDX-License-Identifier: GPL-2.0-or-later
// Terms into nodes: fractions, powers of two, ceilings.
#include "codegen/builder.hpp"
#include "codegen/exact.hpp"
#include "kernel/print.hpp"

namespace codegen {
using kernel::Expr;
using kernel::Exprs;

/// Numbers, what is above and what is below the line.
struct Terms::Fraction {
  cln::cl_RA factor = 1;
  Exprs above = {};
  Exprs below = {};
};

int Terms::build(Expr e) {
  if (const auto found = nodes.find(e); found != nodes.end()) return found->second;
  return nodes[e] = made(e);
}
int Terms::made(Expr e) {
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
int Terms::function(Expr e) {
  static const std::map<std::string, Op> operations{
      {"inv", Op::quotient}, {"pi", Op::constant},      {"sqrt", Op::root},   {"sin", Op::sine},
      {"cos", Op::cosine},   {"atan", Op::arc_tangent}, {"ceil", Op::ceiling}};
  const auto found = operations.find(e.name());
  if (found == operations.end()) throw Refused("no definition of " + kernel::text(e));
  const Op op = found->second;
  if (op == Op::quotient) return product({e});
  if (builder.numbers == Numbers::field) {
    throw Refused("no operation of a field: " + kernel::text(e));
  }
  if (op == Op::constant) return builder.constant(1, true);
  if (op == Op::root) return square_root(e.arg(0));
  if (op == Op::arc_tangent && !builder.is_plain()) return arc_tangent(e);
  if (op == Op::ceiling && !builder.is_plain()) return ceiling(e.arg(0));
  return builder.unary(op, build(e.arg(0)));
}
int Terms::square_root(Expr x) {
  if (x.op() == kernel::Op::Pow && x.exponent() == 2) {
    return builder.unary(Op::size, build(x.arg(0)));
  }
  const int k = build(x);
  if (builder.is_plain()) return builder.unary(Op::root, k);
  return builder.product(k, builder.unary(Op::reciprocal_root, k));
}
int Terms::arc_tangent(Expr e) {
  const int t = build(e.arg(0));
  const auto square = squares.find(t);
  if (square == squares.end()) {
    throw Refused("an arctangent needs a fact about the square: " + kernel::text(e));
  }
  return builder.arc_tangent(t, square->second);
}

Terms::Fraction Terms::fraction(const Exprs& factors) {
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
/// Whole numbers above and below, a sign before it all.
int Terms::plain_product(const Fraction& f) {
  const cln::cl_I above = cln::abs(cln::numerator(f.factor));
  const cln::cl_I below = cln::denominator(f.factor);
  int p = above == 1 && !f.above.empty() ? -1 : builder.constant(above);
  for (Expr e : f.above) p = p < 0 ? build(e) : builder.product(p, build(e));
  for (Expr e : f.below) p = builder.quotient(p, build(e));
  if (below != 1) p = builder.quotient(p, builder.constant(below));
  return builder.scaled(p, f.factor < 0 ? -1 : 1);
}
int Terms::product(const Exprs& factors) {
  const Fraction f = fraction(factors);
  if (builder.is_plain()) return plain_product(f);
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
    const bool is_scaled = n.op == Op::scale;
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
int Terms::ceiling(Expr x) {
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
}  // namespace codegen
