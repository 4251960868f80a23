// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/cosine_polynomial.hpp"

namespace magicmass::algebraic {
namespace {

using cln::cl_I;

/// p(x^n)
Polynomial spread(const Polynomial& p, long n) {
  Polynomial result;
  result.coefficients.resize(static_cast<std::size_t>(p.degree() * n) + 1);
  for (std::size_t i = 0; i < p.coefficients.size(); ++i)
    result.coefficients[i * static_cast<std::size_t>(n)] = p.coefficients[i];
  return result;
}

}  // namespace

// Phi_(p n)(x) is Phi_n(x^p) if the prime p divides n, else Phi_n(x^p)/Phi_n(x).
Polynomial cyclotomic_polynomial(long m) {
  Polynomial result{{-1, 1}};
  long repeated = 1;
  for (long p = 2; m > 1; ++p) {
    if (p * p > m) p = m;
    if (m % p != 0) continue;
    result = exact_quotient(spread(result, p), result);
    for (m /= p; m % p == 0; m /= p) repeated *= p;
  }
  return spread(result, repeated);
}

// For m > 2, Phi_m is its own reverse and of even degree 2d: Phi_m(x) = x^d P(x + 1/x), where P collects the pairs
// x^k + x^-k = V_k(x + 1/x), V_k(y) = y V_(k-1)(y) - V_(k-2)(y). P vanishes at 2 cos(2 pi/m) = x + 1/x. It is the
// minimal polynomial: x is of degree at most 2 over that cosine and of degree 2d over the rational numbers. So are
// the others, as the map x -> x^j of conjugates takes one cosine to the other.
Polynomial cosine_polynomial(long m) {
  if (m == 1) return {{-2, 1}};
  if (m == 2) return {{2, 1}};
  const Polynomial phi = cyclotomic_polynomial(m);
  const auto d = static_cast<std::size_t>(phi.degree() / 2);
  Polynomial result;
  result.coefficients.resize(d + 1);
  result.coefficients[0] = phi.coefficients[d];
  std::vector<cl_I> before(d + 1);
  std::vector<cl_I> now(d + 1);
  before[0] = 2;
  now[1] = 1;
  for (std::size_t k = 1; k <= d; ++k) {
    const cl_I& pairs = phi.coefficients[d + k];
    if (!cln::zerop(pairs))
      for (std::size_t i = k % 2; i <= k; i += 2)
        result.coefficients[i] = result.coefficients[i] + pairs * now[i];
    // V_(k+1) over V_(k-1); powers of the other parity are 0 in both
    if (k < d)
      for (std::size_t i = (k + 1) % 2; i <= k + 1; i += 2)
        before[i] = (i > 0 ? now[i - 1] : cl_I(0)) - before[i];
    before.swap(now);
  }
  return result;
}

}  // namespace magicmass::algebraic
