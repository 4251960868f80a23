// Terms into nodes: fractions, powers of two, ceilings.

#include "codegen/lower.hpp"

namespace codegen {

namespace {
Exprs factors_of(Expr e) { return e.op() == kernel::Op::Mul ? e.args() : Exprs{e}; }
/// Numbers, what is above and what is below the line.
struct Fraction {
  cln::cl_RA factor = 1;
  Exprs above = {};
  Exprs below = {};
};
Fraction fraction(const Exprs& factors) {
  Fraction r;
  for (Expr f : factors) {
    const bool is_inverse = is_call(f, "inv");
    for (Expr g : is_inverse ? factors_of(f.arg(0)) : Exprs{f})
      if (g.op() != kernel::Op::Num)
        (is_inverse ? r.below : r.above).push_back(g);
      else if (is_inverse && g.value() == 0)
        throw Refused("a divisor that is 0");
      else
        r.factor = is_inverse ? r.factor / g.value() : r.factor * g.value();
  }
  return r;
}
}  // namespace

int Builder::build(Expr e) {
  if (const auto found = nodes.find(e); found != nodes.end()) return found->second;
  return nodes[e] = made(e);
}
int Builder::made(Expr e) {
  if (e.op() == kernel::Op::Num) return constant(e.value());
  if (e.op() == kernel::Op::Mul) return product(e.args());
  if (e.op() == kernel::Op::Fun) return function(e);
  if (e.op() == kernel::Op::Var) throw Refused(kernel::text(e) + " is no input");
  if (e.op() != kernel::Op::Add && e.op() != kernel::Op::Pow)
    throw Refused("no operation for " + kernel::text(e));
  const int first = build(e.arg(0));
  int r = first;
  for (std::size_t k = 1; e.op() == kernel::Op::Add && k < e.size(); ++k)
    r = sum(r, build(e.arg(k)));
  for (int k = 1; e.op() == kernel::Op::Pow && k < e.exponent(); ++k) r = product(r, first);
  return r;
}
int Builder::function(Expr e) {
  static const std::map<std::string, Op> operations{
      {"inv", Op::quotient}, {"pi", Op::constant}, {"sqrt", Op::root},
      {"sin", Op::sine},     {"cos", Op::cosine},  {"atan", Op::arc_tangent},
      {"ceil", Op::ceiling}, {"pow", Op::power},   {"turn", Op::turn}};
  const auto found = operations.find(e.name());
  if (found == operations.end()) throw Refused("no definition of " + kernel::text(e));
  const Op op = found->second;
  if (op == Op::quotient) return product({e});
  if (numbers == Numbers::field) throw Refused("no operation of a field: " + kernel::text(e));
  if ((op == Op::power || op == Op::turn) && (is_plain() || !recursions.contains(e.name())))
    throw Refused("no definition of " + kernel::text(e));
  if (op == Op::power) return power(build(e.arg(0)), build(e.arg(1)));
  if (op == Op::turn) return turn(build(e.arg(0)));
  if (op == Op::constant) return constant(1, true);
  const Expr x = e.arg(0);
  if (op == Op::root && x.op() == kernel::Op::Pow && x.exponent() == 2)
    return unary(Op::size, build(x.arg(0)));
  if (op == Op::ceiling && !is_plain()) return ceiling(x);
  const int k = build(x);
  if (is_plain() || op == Op::sine || op == Op::cosine) return unary(op, k);
  if (op == Op::root) return product(k, unary(Op::reciprocal_root, k));
  const auto square = squares.find(k);
  if (square == squares.end())
    throw Refused("an arctangent needs a fact about the square: " + kernel::text(e));
  return arc_tangent(k, square->second);
}

/// Whole numbers above and below, a sign before it all.
int Builder::plain_product(const Exprs& factors) {
  const Fraction f = fraction(factors);
  const cln::cl_I above = cln::abs(cln::numerator(f.factor));
  const cln::cl_I below = cln::denominator(f.factor);
  int p = above == 1 && !f.above.empty() ? -1 : constant(above);
  for (Expr e : f.above) p = p < 0 ? build(e) : product(p, build(e));
  for (Expr e : f.below) p = quotient(p, build(e));
  if (below != 1) p = quotient(p, constant(below));
  return scaled(p, f.factor < 0 ? -1 : 1);
}
int Builder::product(const Exprs& factors) {
  if (is_plain()) return plain_product(factors);
  const Fraction f = fraction(factors);
  if (f.factor == 0) return constant(0);
  double power = 1;
  std::vector<int> over, below;
  for (Expr e : f.above) over.push_back(build(e));
  for (Expr e : f.below) {
    const bool is_root = is_call(e, "sqrt") && e.arg(0).op() != kernel::Op::Pow;
    const int k = build(is_root ? e.arg(0) : e);
    (is_root ? over : below).push_back(is_root ? unary(Op::reciprocal_root, k) : k);
  }
  if (is_double(f.factor) && is_power_of_2(codegen::nearest(f.factor)))
    power = codegen::nearest(f.factor);
  else
    over.push_back(constant(f.factor));
  std::erase_if(over, [&](int k) {
    return program[k].op == Op::constant && !program[k].of_pi && program[k].value == 1;
  });
  std::stable_partition(over.begin(), over.end(), [&](int k) { return !program[k].is_exact; });
  int p = -1;
  for (int k : over) {
    const Node n = program[k];
    if (p >= 0 && n.is_exact) {
      // The power of two goes into a number that is scaled exactly, once.
      p = product(p, scaled(k, power));
      power = 1;
      continue;
    }
    const bool is_scaled = n.op == Op::scale && over.size() > 1;
    if (is_scaled) power *= n.factor;
    const int factor = is_scaled ? n.of[0] : k;
    p = p < 0 ? factor : product(p, factor);
  }
  for (int k : below) p = quotient(p < 0 ? constant(1) : p, k);
  if (p < 0) return constant(f.factor);
  return scaled(p, power);
}
/// ceil(p/q + c), c a whole number or half of an odd one.
int Builder::ceiling(Expr x) {
  const bool has_c = x.op() == kernel::Op::Add && x.size() == 2 && x.arg(1).op() == kernel::Op::Num;
  const cln::cl_RA c = has_c ? x.arg(1).value() : cln::cl_RA(0);
  const Fraction f = fraction(factors_of(has_c ? x.arg(0) : x));
  if (f.below.empty() || cln::denominator(c) > 2)
    throw Refused("not of the form ceil(p/q + c), c half of a whole number: " + kernel::text(x));
  Exprs above = f.above;
  above.insert(above.begin(), Expr(f.factor));
  const int p = product(above), q = product(f.below);
  if (cln::denominator(c) == 1) return ceiling(p, q, c);
  return sum(nearest(p, q), constant(c + cln::cl_RA(1) / 2));
}
}  // namespace codegen
