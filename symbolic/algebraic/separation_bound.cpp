// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/separation_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <cln/real.h>

#include "algebraic/prime_powers.hpp"

namespace magicmass::algebraic {
namespace {

using cln::cl_I;
using cln::cl_RA;

// Each term is r U / L, where r > 0 is rational, U and L are algebraic integers of the term's field, and no conjugate
// of U or L exceeds 2^u or 2^l. A nonzero U has a norm of at least 1, the product of at most D conjugates, so
// |U| >= 2^(-(D-1) u) and |r U / L| >= r 2^(-(D-1) u - l). Logarithms are rounded up by far more than double errs.
struct Quotient {
  cl_RA r;
  double u;
  double l;
};

double up(double x) { return x + 1e-12 * (std::abs(x) + 1); }

/// Not below log2 x; x >= 1.
double log2_above(const cl_I& x) {
  const long excess = std::max(0L, static_cast<long>(cln::integer_length(x)) - 50);
  const double lead = cln::double_approx(cln::ash(x, -excess));
  return up(std::log2(lead + (excess > 0 ? 1 : 0)) + static_cast<double>(excess));
}

double log2_sum(double a, double b) {
  const double larger = std::max(a, b);
  return up(larger + std::log2(1 + std::exp2(std::min(a, b) - larger)));
}

Quotient sum(const Quotient& x, const Quotient& y) {
  // r = gcd(r_x, r_y): both are integer multiples of it.
  const cl_RA r = cl_RA(cln::gcd(cln::numerator(x.r), cln::numerator(y.r))) /
                  cln::lcm(cln::denominator(x.r), cln::denominator(y.r));
  const auto multiple = [&r](const cl_RA& whole) { return log2_above(cln::numerator(whole / r)); };
  return {r, log2_sum(multiple(x.r) + x.u + y.l, multiple(y.r) + y.u + x.l), up(x.l + y.l)};
}

std::optional<Quotient> power(const Quotient& x, const cl_I& exponent, const Budget& budget) {
  const cl_I n = cln::abs(exponent);
  const auto bits = static_cast<long>(cln::integer_length(cln::numerator(x.r)) +
                                      cln::integer_length(cln::denominator(x.r)));
  if (n * bits > 8 * cl_I(budget.bits)) return {};  // r^n is too long
  const double factor = cln::double_approx(n);
  const Quotient result = {cln::expt(x.r, n), up(factor * x.u), up(factor * x.l)};
  if (cln::plusp(exponent)) return result;
  return {{cln::recip(result.r), result.l, result.u}};
}

/// (a/b U/L)^(1/n) = (a b^(n-1) U L^(n-1))^(1/n) / (b L)
Quotient root(const Quotient& x, const cl_I& index) {
  const double n = cln::double_approx(index);
  const cl_I b = cln::denominator(x.r);
  const double radicand =
      log2_above(cln::numerator(x.r)) + (n - 1) * log2_above(b) + x.u + (n - 1) * x.l;
  return {cln::recip(cl_RA(b)), up(radicand / n), x.l};
}

std::optional<Quotient> quotient(const Term& term, const std::vector<Quotient>& known,
                                 const std::vector<std::size_t>& place, const Budget& budget) {
  const auto part = [&](std::size_t i) -> const Quotient& { return known[place[term.parts[i]]]; };
  Quotient result = {1, 0, 0};
  switch (term.kind) {
    case Kind::rational:
      result.r = cln::zerop(term.value) ? cl_RA(1) : cln::abs(term.value);
      break;
    case Kind::cosine:
      result = {cl_RA(1) / 2, 1, 0};
      break;  // 2 cos(2 pi t) is an algebraic integer
    case Kind::sum:
      result = part(0);
      for (std::size_t i = 1; i < term.parts.size(); ++i) result = sum(result, part(i));
      break;
    case Kind::product:
      for (std::size_t i = 0; i < term.parts.size(); ++i) {
        const Quotient& factor = part(i);
        result = {result.r * factor.r, up(result.u + factor.u), up(result.l + factor.l)};
      }
      break;
    case Kind::power:
      return power(part(0), term.exponent, budget);
    case Kind::root:
      result = root(part(0), term.exponent);
      break;
  }
  return result;
}

/// The degree of the field of all roots of rational numbers: at most the product of their indices, and at most that
/// of the common indices of p^(1/n) for each prime (or unfactored number) p under them.
class RationalRoots {
public:
  void add(const cl_RA& radicand, const cl_I& index) {
    product_ *= cln::double_approx(index);
    for (const auto& power : prime_powers(radicand)) {
      const auto same = std::find_if(indices_.begin(), indices_.end(),
                                     [&](const auto& known) { return known.first == power.first; });
      if (same == indices_.end())
        indices_.emplace_back(power.first, index);
      else
        same->second = cln::lcm(same->second, index);
    }
  }

  double degree() const {
    double by_primes = 1;
    for (const auto& [prime, index] : indices_) by_primes *= cln::double_approx(index);
    return std::min(product_, by_primes);
  }

private:
  double product_ = 1;
  std::vector<std::pair<cl_I, cl_I>> indices_;
};

}  // namespace

double totient_bound(const cl_I& m) {
  if (m > (cl_I(1) << 40)) return cln::double_approx(m);
  long rest = cln::cl_I_to_long(m);
  long totient = rest;
  for (long p = 2; p * p <= rest; p += p == 2 ? 1 : 2) {
    if (rest % p != 0) continue;
    totient -= totient / p;
    while (rest % p == 0) rest /= p;
  }
  if (rest > 1) totient -= totient / rest;
  return static_cast<double>(totient);
}

std::optional<SeparationBound> separation_bound(const Terms& terms, std::size_t id,
                                                const Budget& budget) {
  const std::vector<std::size_t> order = terms.below(id);
  std::vector<std::size_t> place(id + 1);
  std::vector<Quotient> known;
  double degree = 1;
  RationalRoots rational_roots;
  cl_I m =
      1;  // all cosines lie in the real subfield of the m-th roots of unity, of degree phi(m)/2 for m > 2
  for (const std::size_t i : order) {
    const Term& term = terms[i];
    place[i] = known.size();
    std::optional<Quotient> next = quotient(term, known, place, budget);
    if (!next) return {};
    known.push_back(std::move(*next));
    if (term.kind == Kind::root && terms[term.parts[0]].kind == Kind::rational)
      rational_roots.add(terms[term.parts[0]].value, term.exponent);
    else if (term.kind == Kind::root)
      degree *= cln::double_approx(term.exponent);
    if (term.kind == Kind::cosine) m = cln::lcm(m, cln::denominator(term.value));
  }
  degree *= rational_roots.degree();
  if (m > 2) degree *= totient_bound(m) / 2;
  const Quotient& whole = known.back();
  const double bits = (degree - 1) * whole.u + whole.l + log2_above(cln::denominator(whole.r));
  if (!(bits < 1e15) || !(degree < 1e15)) return {};
  return {{up(bits), degree}};
}

}  // namespace magicmass::algebraic
