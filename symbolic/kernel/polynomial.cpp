// Polynomials, and the canonical form of a formula.
#include "kernel/polynomial.hpp"

#include <numeric>
#include <unordered_map>

namespace kernel {
namespace {
constexpr unsigned max_bits = 1000000;
void add(Polynomial& p, Monomial m, const cln::cl_RA& q) {
  const auto it = p.try_emplace(std::move(m), 0).first;
  it->second = it->second + q;
  if (it->second == 0) p.erase(it);
}
cln::cl_RA bounded(const cln::cl_RA& q) {
  const cln::cl_I n = cln::numerator(q), d = cln::denominator(q);
  if (cln::integer_length(n) > max_bits || cln::integer_length(d) > max_bits)
    refuse("a number of more than a million bits");
  return q;
}
Monomial times(const Monomial& a, const Monomial& b) {
  Monomial out;
  out.reserve(a.size() + b.size());
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() || j != b.end()) {
    if (j == b.end() || (i != a.end() && i->first < j->first)) {
      out.push_back(*i++);
    } else if (i == a.end() || j->first < i->first) {
      out.push_back(*j++);
    } else {
      if (i->second + j->second > max_exponent) refuse("an exponent above 1000000");
      out.emplace_back(i->first, i->second + j->second);
      ++i;
      ++j;
    }
  }
  return out;
}
Polynomial atomic(Expr e) { return {{{{e, 1}}, 1}}; }

Polynomial raised(Polynomial base, int exponent) {
  Polynomial out = one();
  for (int k = exponent; k > 0; k /= 2) {
    if (k % 2 == 1) out = out * base;
    if (k > 1) base = base * base;
  }
  return out;
}
Exprs all_canonical(const Exprs& es) {
  Exprs out;
  for (Expr e : es) out.push_back(canonical(e));
  return out;
}
// A name or power with canonical arguments, anything else as its entries: equal in value.
Expr canonical_matrix(Expr a) {
  if (a.op() == Op::Fun) return fun(a.name(), all_canonical(a.args()));
  if (a.op() == Op::MatrixPower) return power(canonical_matrix(a.arg(0)), canonical(a.arg(1)));
  return matrix(a.cols(), all_canonical(entries(a)));
}
Expr computed_canonical(Expr e) {
  if (e.sort() == Sort::Matrix) return canonical_matrix(e);
  if (e.sort() != Sort::Bool) return expression(polynomial(e));
  if (e.op() == Op::Eq && e.arg(0).sort() == Sort::Matrix)
    return logic_and(all_canonical(entry_equations(e)));
  return with_args(e, all_canonical(e.args()));
}
// Expanded by the first row that is left.
Polynomial determinant(Expr a, int row, const std::vector<int>& cols) {
  if (cols.empty()) return one();
  Polynomial out;
  for (std::size_t k = 0; k < cols.size(); ++k) {
    std::vector<int> rest = cols;
    rest.erase(rest.begin() + std::ptrdiff_t(k));
    const Polynomial minor = polynomial(entry(a, row, cols[k])) * determinant(a, row + 1, rest);
    out = k % 2 == 0 ? std::move(out) + minor : std::move(out) - minor;
  }
  return out;
}
Polynomial determinant(Expr a) {
  if (a.rows() > 6) refuse("a determinant of more than 6 rows");
  std::vector<int> cols(std::size_t(a.cols()));
  std::iota(cols.begin(), cols.end(), 0);
  return determinant(a, 0, cols);
}
Polynomial of_function(Expr t) {
  const Exprs args = all_canonical(t.args());
  if (t.name() != "inv" || args[0].op() != Op::Num || args[0].value() == 0)
    return atomic(fun(t.name(), args));
  return scaled(one(), 1 / args[0].value());
}
Polynomial computed(Expr t) {
  Polynomial p;
  switch (t.op()) {
    case Op::Num:
      return scaled(one(), t.value());
    case Op::Var:
    case Op::Bound:
      return atomic(t);
    case Op::Add:
      for (Expr a : t.args()) p = std::move(p) + polynomial(a);
      return p;
    case Op::Mul:
      p = one();
      for (Expr a : t.args()) p = p * polynomial(a);
      return p;
    case Op::Pow:
      return raised(polynomial(t.arg(0)), t.exponent());
    case Op::Entry:
      return atomic(with_args(t, {canonical_matrix(t.arg(0))}));
    case Op::Det:
      return determinant(t.arg(0));
    case Op::Fun:
      if (t.sort() != Sort::Matrix) return of_function(t);
      [[fallthrough]];
    default:
      refuse("not a polynomial: " + brief(t));
  }
}
}  // namespace

Polynomial one() { return {{{}, 1}}; }
int degree(const Monomial& m, Expr atom) {
  for (const auto& [a, k] : m)
    if (a == atom) return k;
  return 0;
}
Expr youngest_inverse(const Polynomial& p, const std::function<bool(Expr)>& is_known) {
  Expr out;
  for (const auto& [m, q] : p)
    for (const auto& [a, k] : m)
      if (is_call(a, "inv") && is_known(a.arg(0)) && (!out || out < a)) out = a;
  return out;
}
Polynomial operator+(Polynomial a, const Polynomial& b) {
  for (const auto& [m, q] : b) add(a, m, q);
  return a;
}
Polynomial operator-(Polynomial a, const Polynomial& b) { return std::move(a) + scaled(b, -1); }
Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.size() * b.size() > 1000000) refuse("a product of more than a million monomials");
  Polynomial p;
  for (const auto& [m, q] : a)
    for (const auto& [n, r] : b) add(p, times(m, n), bounded(q * r));
  return p;
}
Polynomial scaled(const Polynomial& a, const cln::cl_RA& q) {
  Polynomial p;
  if (q == 0) return p;
  for (const auto& [m, r] : a) p.emplace_hint(p.end(), m, bounded(q * r));
  return p;
}

const Polynomial& polynomial(Expr t) {
  static std::unordered_map<std::size_t, Polynomial> known;  // by id
  if (const auto it = known.find(t.id()); it != known.end()) return it->second;
  return known.emplace(t.id(), computed(t)).first->second;
}
Expr expression(const Polynomial& p) {
  Exprs terms;
  for (const auto& [m, q] : p) {
    Exprs factors;
    if (q != 1 || m.empty()) factors.push_back(Expr(q));
    for (const auto& [a, k] : m) factors.push_back(power(a, k));
    terms.push_back(product(factors));
  }
  return terms.empty() ? Expr(0) : sum(terms);
}

Expr canonical(Expr e) {
  static std::unordered_map<std::size_t, Expr> known;  // by id
  if (const auto it = known.find(e.id()); it != known.end()) return it->second;
  return known.emplace(e.id(), computed_canonical(e)).first->second;
}
}  // namespace kernel
