#include <algorithm>

#include <ginac/ginac.h>

#include "algebra/tactics.hpp"

namespace algebra {
namespace {
using GiNaC::ex;

/// Kernel terms as GiNaC's and back: each atom is a symbol, a square root one of known square.
class Translation {
public:
  ex symbol_of(Expr atom) {
    if (const auto it = symbols.find(atom); it != symbols.end()) return it->second;
    const GiNaC::symbol s("x" + std::to_string(atoms.size()));
    atoms.emplace_back(s, atom);
    symbols.emplace(atom, s);
    if (is_call(atom, "sqrt")) roots.emplace_back(s, to_ginac(atom.arg(0)));
    return s;
  }
  ex to_ginac(Expr e) {
    switch (e.op()) {
      case Op::Num:
        return GiNaC::numeric(cln::cl_N(e.value()));
      case Op::Add:
      case Op::Mul: {
        GiNaC::exvector parts;
        for (const Expr& a : e.args()) parts.push_back(to_ginac(a));
        return e.op() == Op::Add ? ex(GiNaC::add(parts)) : ex(GiNaC::mul(parts));
      }
      case Op::Pow:
        return GiNaC::pow(to_ginac(e.arg(0)), e.exponent());
      default:
        return is_call(e, "inv") ? 1 / to_ginac(e.arg(0)) : symbol_of(e);
    }
  }
  /// numerator/denominator without common factor, no root in the denominator.
  std::pair<ex, ex> quotient(const ex& e) const {
    ex numerator = e.normal().numer();
    ex denominator = e.normal().denom();
    for (const auto& [root, square] : roots) {
      const ex d = reduced(denominator), with = d.coeff(root, 1);
      const ex conjugate = with.is_zero() ? ex(1) : d.coeff(root, 0) - with * root;
      numerator = reduced(numerator * conjugate);
      denominator = reduced(d * conjugate);
    }
    const ex whole = (numerator / denominator).normal();
    return {reduced(whole.numer()), reduced(whole.denom())};
  }
  /// With s^2 for t where s is the root of a symbol t, so that both are one unknown for lsolve.
  ex in_roots(ex e) const {
    for (const auto& [root, square] : roots)
      if (GiNaC::is_a<GiNaC::symbol>(square)) e = e.subs(square == GiNaC::pow(root, 2));
    return e;
  }
  Expr to_kernel(const ex& e) const {
    if (GiNaC::is_a<GiNaC::numeric>(e))
      return cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(e).to_cl_N());
    if (GiNaC::is_a<GiNaC::power>(e))
      return power(to_kernel(e.op(0)), GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int());
    Exprs parts;
    for (const ex& part : e) parts.push_back(to_kernel(part));
    if (GiNaC::is_a<GiNaC::add>(e)) return sum(parts);
    if (GiNaC::is_a<GiNaC::mul>(e)) return product(parts);
    for (const auto& [symbol, atom] : atoms)
      if (e.is_equal(symbol)) return atom;
    refuse("GiNaC gave something that is no polynomial");
  }

private:
  std::vector<std::pair<GiNaC::symbol, Expr>> atoms;
  std::map<Expr, ex> symbols;
  std::vector<std::pair<ex, ex>> roots;  // of symbols, inner ones first

  ex reduced(const ex& e) const {  // squares of roots by what they are
    ex out = e.expand();
    for (auto it = roots.rbegin(); it != roots.rend(); ++it) {
      const auto& [root, square] = *it;
      ex sum = out.coeff(root, 0) + out.coeff(root, 1) * root;
      for (int k = 2; k <= out.degree(root); ++k)
        sum += out.coeff(root, k) * GiNaC::pow(square, k / 2) * GiNaC::pow(root, k % 2);
      out = sum.expand();
    }
    return out;
  }
};

/// A polynomial as number * product of powers of factors: sign and order do not depend on GiNaC's.
struct Factored {
  cln::cl_RA number = 1;
  std::vector<std::pair<Polynomial, int>> factors = {};
};
Factored factored(const ex& e, const Translation& translation) {
  const ex product = GiNaC::factor(e);
  const std::size_t count = GiNaC::is_a<GiNaC::mul>(product) ? product.nops() : 1;
  Factored out;
  for (std::size_t i = 0; i < count; ++i) {
    const ex factor = count > 1 ? product.op(i) : product;
    const bool is_power = GiNaC::is_a<GiNaC::power>(factor);
    const int exponent = is_power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
    Polynomial p = polynomial(translation.to_kernel(is_power ? factor.op(0) : factor));
    if (p.empty()) return {0, {}};
    cln::cl_RA content = 0;
    for (const auto& [monomial, q] : p) content = gcd(numerator(content), numerator(q));
    if (p.begin()->second < 0) content = -content;
    p = scaled(p, 1 / content);
    out.number = out.number * cln::expt(content, exponent);
    if (p.size() > 1 || !p.begin()->first.empty()) out.factors.emplace_back(p, exponent);
  }
  std::ranges::sort(out.factors, {}, [](const auto& factor) {
    return std::pair(factor.first.size(), factor.first.begin()->first);
  });
  return out;
}
Expr product_of(Exprs factors) {
  std::erase(factors, Expr(1));
  return factors.empty() ? Expr(1) : product(factors);
}
class Simplifier {
public:
  explicit Simplifier(const Exprs& collected_atoms) : collect(collected_atoms) {}

  Expr simplified(Expr t) try {
    return from_ginac(translation.to_ginac(t));
  } catch (const std::logic_error& problem) {  // a quotient by 0
    refuse(std::string("GiNaC cannot simplify: ") + problem.what());
  }
  Expr from_ginac(const ex& e) {
    const auto [numerator, denominator] = translation.quotient(e);
    const Factored over = factored(numerator, translation);
    const Factored under = factored(denominator, translation);
    cln::cl_RA number = over.number / under.number;
    if (number == 0) return 0;
    Exprs factors;
    for (const auto& [p, k] : over.factors) {
      const bool has_minus = coefficients_in(p).begin()->second.begin()->second < 0;
      const cln::cl_RA sign = has_minus ? -1 : 1;
      number = number * cln::expt(sign, k);
      factors.push_back(power(collected(scaled(p, sign)), k));
    }
    factors.insert(factors.begin(), Expr(number));
    Exprs divisors;
    for (const auto& [p, k] : under.factors) divisors.push_back(power(expression(p), k));
    const Expr whole = product_of(factors);
    return divisors.empty() ? whole : whole / product_of(divisors);
  }
  Translation translation;

private:
  Exprs collect;

  /// p as a sum of coefficient * powers of the collected atoms; each coefficient is factored again.
  std::map<Monomial, Polynomial> coefficients_in(const Polynomial& p) const {
    std::map<Monomial, Polynomial> coefficients;
    for (const auto& [monomial, q] : p) {
      Monomial key, rest;
      for (const auto& factor : monomial)
        (is_among(factor.first, collect) ? key : rest).push_back(factor);
      coefficients[key] = coefficients[key] + Polynomial{{rest, q}};
    }
    return coefficients;
  }
  Expr collected(const Polynomial& p) const {
    const auto coefficients = coefficients_in(p);
    if (coefficients.size() == 1) return expression(p);
    Exprs terms;
    for (const auto& [key, coefficient] : coefficients) {
      const Expr factor = Simplifier({}).simplified(expression(coefficient));
      terms.push_back(product_of({factor, expression({{key, 1}})}));
    }
    return sum(terms);
  }
};
}  // namespace

Exprs solve(const Exprs& equations, const Exprs& unknowns, const Exprs& collect) try {
  Simplifier simplifier(collect);
  GiNaC::lst symbols;
  for (const Expr& u : unknowns) symbols.append(simplifier.translation.symbol_of(u));
  std::vector<ex> numerators;
  for (const Expr& e : equations) {
    const ex difference = simplifier.translation.to_ginac(e.arg(0) - e.arg(1));
    numerators.push_back(simplifier.translation.quotient(difference).first);
  }
  GiNaC::lst system;
  for (const ex& e : numerators) system.append(simplifier.translation.in_roots(e) == 0);
  Exprs out;
  for (const ex& is : GiNaC::lsolve(system, symbols))
    out.push_back(simplifier.from_ginac(is.rhs()));
  bool found = out.size() == unknowns.size();
  for (const Expr& value : out)
    for (const Expr& u : unknowns) found = found && free_variables(value).count(u) == 0;
  if (!found) refuse("the equations do not determine the unknowns");
  return out;
} catch (const std::logic_error& problem) {
  refuse(std::string("GiNaC cannot solve for the unknowns: ") + problem.what());
}
Expr simplified(Expr term, const Exprs& collect) {
  if (!is_matrix(term)) return Simplifier(collect).simplified(term);
  Exprs out;
  for (const Expr& e : entries(term)) out.push_back(simplified(e, collect));
  return matrix(term.cols(), out);
}
}  // namespace algebra
