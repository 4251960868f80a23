// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/polynomial.hpp"

#include <stdexcept>

#include "answers/motion.hpp"
#include "kernel/print.hpp"

namespace answers {
namespace {

/// p over q, which divides it and whose first coefficient is 1.
Polynomial quotient(Polynomial p, const Polynomial& q) {
  Polynomial out(p.size() - q.size() + 1, 0);
  for (std::size_t i = out.size(); i-- > 0;) {
    out[i] = p[i + q.size() - 1];
    for (std::size_t j = 0; j < q.size(); ++j) p[i + j] = p[i + j] - out[i] * q[j];
  }
  return out;
}
/// p(x^n)
Polynomial at_power(const Polynomial& p, std::size_t n) {
  Polynomial out((p.size() - 1) * n + 1, 0);
  for (std::size_t i = 0; i < p.size(); ++i) out[i * n] = p[i];
  return out;
}
/// Phi_m, whose roots are the primitive m-th roots of 1: for a prime p, Phi_np(x) is Phi_n(x^p) if
/// p divides n, else Phi_n(x^p)/Phi_n(x).
Polynomial cyclotomic(int m) {
  Polynomial phi{-1, 1};
  for (int n = 1, p = 2; n < m; ++p) {
    for (; m / n % p == 0; n *= p) {
      const Polynomial of_power = at_power(phi, std::size_t(p));
      phi = n % p == 0 ? of_power : quotient(of_power, phi);
    }
  }
  return phi;
}
cln::cl_RA value(const Polynomial& p, const cln::cl_RA& x) {
  cln::cl_RA sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
  return sum;
}

/// The polynomial of least degree that sec(2 pi/m) - 1 is a root of, for m >= 5.
// z = e^(2 pi i/m) is a root of the cyclotomic polynomial, which is irreducible and reads the same
// from both ends: it is z^D times a sum of z^j + z^-j, and so a polynomial of degree D in
// y = z + 1/z = 2 cos(2 pi/m), which is irreducible as well (D = phi(m)/2 is the degree of y). Then
// x = 2/y - 1 is a root of the sum of c_j 2^j (x + 1)^(D - j), irreducible since x generates the
// same field.
Polynomial polynomial_of_secant(int m) {
  const Polynomial circle = cyclotomic(m);
  const std::size_t degree = circle.size() / 2;
  Polynomial next(degree + 1, 0), last(degree + 1, 0);  // by Clenshaw: z^j + z^-j in y
  for (std::size_t j = degree + 1; j-- > 0;) {
    Polynomial now(degree + 1, 0);
    for (std::size_t i = 0; i <= degree; ++i)
      now[i] = (i == 0 ? circle[degree + j] : next[i - 1]) - (j == 0 ? 2 : 1) * last[i];
    last = next;
    next = now;
  }
  Polynomial p{0};
  for (std::size_t j = 0; j <= degree; ++j) {  // times (x + 1), plus the next coefficient
    p.push_back(0);
    for (std::size_t i = p.size() - 1; i > 0; --i) p[i] = p[i] + p[i - 1];
    p[0] = p[0] + cln::ash(next[j], static_cast<long>(j));
  }
  p.pop_back();
  cln::cl_I factor = 0;
  for (const cln::cl_I& c : p) factor = cln::gcd(factor, c);
  if (p.back() < 0) factor = -factor;
  for (cln::cl_I& c : p) c = cln::exquo(c, factor);
  return p;
}

}  // namespace

Polynomial polynomial_of_ratio(int k, bool is_magic) {
  const Polynomial p = polynomial_of_secant(is_magic ? 4 * k + 2 : 4 * k + 4);
  const Ball root =
      ball_of(is_magic ? notation::Alpha(notation::Magic{k}) : notation::Deficient{k});
  if (value(p, root.low()) * value(p, root.high()) > 0)
    throw std::logic_error("no root: " + text_of(p) + " at " + std::to_string(k));
  return p;
}

std::string text_of(const Polynomial& p) {
  std::string out;
  for (std::size_t i = p.size(); i-- > 0;) {
    if (p[i] == 0) continue;
    const std::string power = i == 0 ? "" : i == 1 ? "x" : "x^" + std::to_string(i);
    const std::string size = kernel::digits(cln::abs(p[i]));
    out += out.empty() ? (p[i] < 0 ? "-" : "") : (p[i] < 0 ? " - " : " + ");
    out += power.empty() ? size : size == "1" ? power : size + "*" + power;
  }
  return out;
}

}  // namespace answers
