// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/minimal_polynomial.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <cln/real.h>
#include <ginac/ginac.h>

#include "algebraic/cosine_polynomial.hpp"
#include "algebraic/decimal_text.hpp"
#include "algebraic/polynomial_value.hpp"
#include "algebraic/separation_bound.hpp"
#include "algebraic/translation.hpp"

namespace magicmass::algebraic {
namespace {

using cln::cl_I;
using cln::cl_RA;

constexpr unsigned long longest_to_factor = 2000;  // bits; GiNaC::factor cannot be interrupted

/// p_0, ..., p_count, the sums of the powers of all roots.
using PowerSums = std::vector<cl_RA>;

/// Newton's identities, for x^d + c_1 x^(d-1) + ... : p_k + c_1 p_(k-1) + ... + c_(k-1) p_1 + k c_k = 0.
PowerSums power_sums(const Polynomial& polynomial, long count) {
  const long degree = polynomial.degree();
  const cl_I& leading = polynomial.coefficients.back();
  const auto c = [&](long i) {
    return cl_RA(polynomial.coefficients[static_cast<std::size_t>(degree - i)]) / leading;
  };
  PowerSums p = {degree};
  for (long k = 1; k <= count; ++k) {
    cl_RA sum = k <= degree ? k * c(k) : cl_RA(0);
    for (long i = 1; i <= std::min(k - 1, degree); ++i)
      sum = sum + c(i) * p[static_cast<std::size_t>(k - i)];
    p.push_back(-sum);
  }
  return p;
}

Polynomial from_power_sums(const PowerSums& p) {
  const auto degree = p.size() - 1;
  std::vector<cl_RA> c = {1};
  cl_I denominator = 1;
  for (std::size_t k = 1; k <= degree; ++k) {
    cl_RA sum = 0;
    for (std::size_t i = 0; i < k; ++i) sum = sum + c[i] * p[k - i];
    c.push_back(-sum / cl_I(k));
    denominator = cln::lcm(denominator, cln::denominator(c.back()));
  }
  Polynomial result;
  for (std::size_t k = c.size(); k-- > 0;)
    result.coefficients.push_back(cln::numerator(c[k] * denominator));
  return primitive(std::move(result));
}

long allowed_degree(long degree) {
  if (degree > largest_degree)
    throw BeyondBudget("a polynomial of degree above " + std::to_string(largest_degree));
  return degree;
}

Polynomial composed_sum(const Polynomial& a, const Polynomial& b) {
  const long degree = allowed_degree(a.degree() * b.degree());
  const PowerSums p = power_sums(a, degree);
  const PowerSums q = power_sums(b, degree);
  PowerSums sums;
  for (long k = 0; k <= degree; ++k) {
    cl_RA sum = 0;
    for (long i = 0; i <= k; ++i)
      sum = sum + cln::binomial(static_cast<unsigned>(k), static_cast<unsigned>(i)) *
                      p[static_cast<std::size_t>(i)] * q[static_cast<std::size_t>(k - i)];
    sums.push_back(sum);
  }
  return from_power_sums(sums);
}

Polynomial composed_product(const Polynomial& a, const Polynomial& b) {
  const long degree = allowed_degree(a.degree() * b.degree());
  PowerSums p = power_sums(a, degree);
  const PowerSums q = power_sums(b, degree);
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = p[k] * q[k];
  return from_power_sums(p);
}

/// Of the n-th powers of the roots, n != 0.
Polynomial of_powers(const Polynomial& a, const cl_I& exponent) {
  const cl_I n = cln::abs(exponent);
  if (n * a.degree() > 1000) throw BeyondBudget("a power too large for a polynomial");
  const PowerSums p =
      power_sums(cln::minusp(exponent) ? reversed(a) : a, cln::cl_I_to_long(n) * a.degree());
  PowerSums powers;
  for (std::size_t k = 0; k < p.size(); k += static_cast<std::size_t>(cln::cl_I_to_long(n)))
    powers.push_back(p[k]);
  return from_power_sums(powers);
}

Polynomial of_roots(const Polynomial& a, const cl_I& index) {
  if (index > largest_degree) allowed_degree(largest_degree + 1);
  const long n = cln::cl_I_to_long(index);
  Polynomial result;
  result.coefficients.resize(static_cast<std::size_t>(allowed_degree(a.degree() * n)) + 1);
  for (std::size_t i = 0; i < a.coefficients.size(); ++i)
    result.coefficients[i * static_cast<std::size_t>(n)] = a.coefficients[i];
  return result;
}

std::vector<Polynomial> irreducible_factors(const Polynomial& polynomial) {
  for (const cl_I& coefficient : polynomial.coefficients)
    if (cln::integer_length(coefficient) > longest_to_factor)
      throw BeyondBudget("a polynomial with coefficients too long to factor it");
  const GiNaC::symbol x("x");
  GiNaC::ex sum = 0;
  for (std::size_t i = 0; i < polynomial.coefficients.size(); ++i)
    sum += GiNaC::numeric(polynomial.coefficients[i]) * GiNaC::pow(x, static_cast<long>(i));
  const GiNaC::ex factored = GiNaC::factor(sum);
  std::vector<Polynomial> factors;
  const auto keep = [&](const GiNaC::ex& part) {
    const GiNaC::ex factor = GiNaC::is_a<GiNaC::power>(part) ? part.op(0) : part;
    if (!factor.has(x)) return;
    const GiNaC::ex expanded = factor.expand();
    Polynomial result;
    for (int i = 0; i <= expanded.degree(x); ++i)
      result.coefficients.push_back(
          cln::the<cl_I>(GiNaC::ex_to<GiNaC::numeric>(expanded.coeff(x, i)).to_cl_N()));
    factors.push_back(primitive(std::move(result)));
  };
  if (GiNaC::is_a<GiNaC::mul>(factored))
    for (const GiNaC::ex& part : factored) keep(part);
  else
    keep(factored);
  return factors;
}

/// Of the irreducible factors exactly one vanishes at the number: they have no root in common.
Polynomial vanishing_factor(const Polynomial& polynomial, const Terms& terms, std::size_t id,
                            const Work& work) {
  std::vector<Polynomial> factors = irreducible_factors(polynomial);
  for (long precision = 64; factors.size() > 1; precision *= 2) {
    if (precision > work.budget().bits) throw BeyondBudget("roots too close to tell apart");
    try {
      const Interval x = terms.enclosure(id, precision, work);
      std::erase_if(factors, [&](const Polynomial& factor) {
        const int sign = value(factor, x, precision).sign();
        return sign == 1 || sign == -1;
      });
    } catch (const Unbounded&) {  // a divisor is not yet seen to differ from 0
    }
  }
  return factors.at(0);
}

class MinimalPolynomials {
public:
  MinimalPolynomials(Terms& terms, const Work& work) : terms_(terms), work_(work) {}

  Polynomial of(std::size_t id) {
    for (const std::size_t term : terms_.below(id))
      if (!known_.contains(term)) known_.emplace(term, made(term));
    return known_.at(id);
  }

private:
  Polynomial made(std::size_t id) {
    work_.check_time();
    const Term& term = terms_[id];
    switch (term.kind) {
      case Kind::rational:
        return {{-cln::numerator(term.value), cln::denominator(term.value)}};
      case Kind::cosine: {
        const cl_I m = cln::denominator(term.value);
        if (m > 10 * largest_degree || totient_bound(m) > 2 * largest_degree)
          allowed_degree(largest_degree + 1);
        return composed_product(cosine_polynomial(cln::cl_I_to_long(m)), {{-1, 2}});
      }
      case Kind::sum:
        return folded(id, composed_sum, &Terms::sum);
      case Kind::product:
        return folded(id, composed_product, &Terms::product);
      case Kind::power:
        return reduced(of_powers(part(term, 0), term.exponent), id);
      case Kind::root:
        return reduced(of_roots(part(term, 0), term.exponent), id);
    }
    throw std::logic_error("a kind of term that minimal_polynomial() does not know");
  }

  const Polynomial& part(const Term& term, std::size_t i) { return known_.at(term.parts[i]); }

  Polynomial reduced(const Polynomial& polynomial, std::size_t id) {
    return vanishing_factor(polynomial, terms_, id, work_);
  }

  /// Reduced after each part, so that degrees do not multiply up; the partial sum or product is a term for that.
  template <class Compose, class Make>
  Polynomial folded(std::size_t id, const Compose& compose, const Make& make) {
    const std::vector<std::size_t> parts = terms_[id].parts;
    std::size_t left = parts[0];
    Polynomial result = known_.at(left);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      left = (terms_.*make)({left, parts[i]});
      result = reduced(compose(result, known_.at(parts[i])), left);
    }
    return result;
  }

  Terms& terms_;
  const Work& work_;
  std::map<std::size_t, Polynomial> known_;
};

}  // namespace

std::optional<Polynomial> minimal_polynomial(const GiNaC::ex& constant, const Budget& budget) {
  const Work work(budget);
  Terms terms(budget);
  try {
    return MinimalPolynomials(terms, work).of(translate(constant, terms, work));
  } catch (const BeyondBudget&) {
    return {};
  }
}

std::optional<std::string> as_root(const GiNaC::ex& constant, const Budget& budget) {
  const std::optional<Polynomial> polynomial = minimal_polynomial(constant, budget);
  if (!polynomial) return {};
  if (polynomial->degree() == 1) {
    std::ostringstream number;
    number << GiNaC::numeric(-polynomial->coefficients[0] / cl_RA(polynomial->coefficients[1]));
    return "the rational number " + number.str();
  }
  const Polynomial slope = derivative(*polynomial);
  Terms terms(budget);
  const Work work(budget);
  try {
    const std::size_t term = translate(constant, terms, work);
    for (long digits = 4; 8 * digits < budget.bits; digits += digits / 2) {
      const cl_I unit = cln::expt_pos(cl_I(10), cl_I(digits));
      const long precision = 8 * digits + 64;
      std::optional<Interval> enclosed;
      try {
        enclosed = terms.enclosure(term, precision, work);
      } catch (const Unbounded&) {  // a divisor is not yet seen to differ from 0
        continue;
      }
      const Interval& x = *enclosed;
      const cl_I first = cln::truncate1(x.low().rational() * unit);
      if (cln::zerop(first) || first != cln::truncate1(x.high().rational() * unit)) continue;
      // All numbers with these decimals: the polynomial is monotonic on them, and so has one root there.
      const cl_I next = first + (cln::plusp(first) ? 1 : -1);
      const Interval all(cl_RA(cln::min(first, next)) / unit, cl_RA(cln::max(first, next)) / unit,
                         precision);
      const int sign = value(slope, all, precision).sign();
      if (sign == 1 || sign == -1)
        return "the root near " + decimal_text(first, digits) + " of " + to_text(*polynomial);
    }
  } catch (const BeyondBudget&) {
  }
  return {};
}

}  // namespace magicmass::algebraic
