// Terms, formulas and matrices by their everyday names.

#include "kernel/expr.hpp"

namespace kernel {
Expr real(const std::string& name) {
  return make({.op = Op::Var, .name = name, .variable = Sort::Real});
}
Expr integer(const std::string& name) {
  return make({.op = Op::Var, .name = name, .variable = Sort::Int});
}
Expr fun(const std::string& name, const Exprs& args) {
  return make({.op = Op::Fun, .args = args, .name = name});
}
Expr sum(const Exprs& terms) { return make({.op = Op::Add, .args = terms}); }
Expr product(const Exprs& factors) { return make({.op = Op::Mul, .args = factors}); }
Expr power(Expr base, int exponent) {
  return make({.op = Op::Pow, .args = {base}, .exponent = exponent});
}
Expr eq(Expr l, Expr r) { return make({.op = Op::Eq, .args = {l, r}}); }
Expr lt(Expr l, Expr r) { return make({.op = Op::Lt, .args = {l, r}}); }
Expr le(Expr l, Expr r) { return make({.op = Op::Le, .args = {l, r}}); }
Expr neq(Expr l, Expr r) { return logic_not(eq(l, r)); }
Expr logic_not(Expr f) { return make({.op = Op::Not, .args = {f}}); }
Expr logic_and(const Exprs& fs) { return make({.op = Op::And, .args = fs}); }
Expr logic_or(const Exprs& fs) { return make({.op = Op::Or, .args = fs}); }
Expr imp(Expr f, Expr g) { return make({.op = Op::Imp, .args = {f, g}}); }
Expr iff(Expr f, Expr g) { return make({.op = Op::Iff, .args = {f, g}}); }

namespace {
// q*a, with q multiplied into a leading number.
Expr times_number(const cln::cl_RA& q, Expr a) {
  if (a.op() == Op::Num) return Expr(cln::cl_RA(q * a.value()));
  if (a.op() != Op::Mul) return product({Expr(q), a});
  Exprs factors = a.args();
  if (factors[0].op() != Op::Num) {
    factors.insert(factors.begin(), Expr(q));
    return product(factors);
  }
  const cln::cl_RA leading = q * factors[0].value();
  factors[0] = Expr(leading);
  if (leading == 1) factors.erase(factors.begin());
  return product(factors);
}
}  // namespace
Expr operator+(Expr a, Expr b) { return sum({a, b}); }
Expr operator*(Expr a, Expr b) { return product({a, b}); }
Expr operator-(Expr a) { return times_number(-1, a); }
Expr operator-(Expr a, Expr b) { return sum({a, -b}); }
Expr operator/(Expr a, Expr b) {
  if (b.op() == Op::Mul) {
    for (Expr factor : b.args()) a = a / factor;
    return a;
  }
  if (b.op() == Op::Num) {
    if (b.value() == 0) refuse("division by 0");
    return times_number(1 / b.value(), a);
  }
  const Expr inverse =
      b.op() == Op::Pow ? power(Expr(1) / b.arg(0), b.exponent()) : fun("inv", {b});
  return a == Expr(1) ? inverse : product({a, inverse});
}
Expr sin(Expr x) { return fun("sin", {x}); }
Expr cos(Expr x) { return fun("cos", {x}); }
Expr atan(Expr x) { return fun("atan", {x}); }
Expr sqrt(Expr x) { return fun("sqrt", {x}); }
Expr ceil(Expr x) { return fun("ceil", {x}); }
Expr pi() { return fun("pi", {}); }

Expr matrix(int cols, const Exprs& entries) {
  return make({.op = Op::Matrix, .args = entries, .cols = cols});
}
Expr times(Expr a, Expr b) { return make({.op = Op::Times, .args = {a, b}}); }
Expr transpose(Expr a) { return make({.op = Op::Transpose, .args = {a}}); }
Expr power(Expr a, Expr n) { return make({.op = Op::MatrixPower, .args = {a, n}}); }
Expr det(Expr a) { return make({.op = Op::Det, .args = {a}}); }

Expr entry(Expr a, int i, int j) {
  if (a.sort() != Sort::Matrix) refuse("a matrix is needed");
  if (i < 0 || i >= a.rows() || j < 0 || j >= a.cols()) refuse("no such entry");
  const int place = i * a.cols() + j;
  if (a.op() == Op::Matrix) return a.arg(std::size_t(place));
  if (a.op() == Op::Transpose) return entry(a.arg(0), j, i);
  if (a.op() != Op::Times) return make({.op = Op::Entry, .args = {a}, .index = place});
  static std::map<std::pair<Expr, int>, Expr> known;  // else A B C D ... takes 3^n steps
  const std::pair<Expr, int> key{a, place};
  if (const auto it = known.find(key); it != known.end()) return it->second;
  Exprs terms;
  for (int k = 0; k < a.arg(0).cols(); ++k)
    terms.push_back(product({entry(a.arg(0), i, k), entry(a.arg(1), k, j)}));
  return known.emplace(key, sum(terms)).first->second;
}
Exprs entries(Expr a) {
  Exprs out;
  for (int k = 0; k < a.rows() * a.cols(); ++k) out.push_back(entry(a, k / a.cols(), k % a.cols()));
  return out;
}
Exprs entry_equations(Expr e) {
  const Exprs l = entries(e.arg(0)), r = entries(e.arg(1));
  Exprs out;
  for (std::size_t k = 0; k < l.size(); ++k) out.push_back(eq(l[k], r[k]));
  return out;
}
}  // namespace kernel
