// SPDX-License-Identifier: GPL-2.0-or-later
// The fields that scenes need: of a square root, and of the cosine in magic and deficient ratios.
#include <map>
#include <utility>

#include <cln/float.h>
#include <cln/real.h>

#include "magicmass/errors.hpp"
#include "magicmass/reference/number_field.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_RA;
using Polynomial = std::vector<cl_I>;

/// a / b for monic b that divides a.
Polynomial quotient(Polynomial a, const Polynomial& b) {
  Polynomial result(a.size() - b.size() + 1);
  for (std::size_t i = result.size(); i-- > 0;) {
    result[i] = a[i + b.size() - 1];
    for (std::size_t j = 0; j < b.size(); ++j) a[i + j] = a[i + j] - result[i] * b[j];
  }
  return result;
}

/// x^n - 1 is the product of the cyclotomic polynomials of n's divisors.
Polynomial cyclotomic(std::int64_t n) {
  Polynomial result(static_cast<std::size_t>(n) + 1, cl_I(0));
  result.front() = -1;
  result.back() = 1;
  for (std::int64_t divisor = 1; divisor < n; ++divisor)
    if (n % divisor == 0) result = quotient(result, cyclotomic(divisor));
  return result;
}

/// Palindromic c of even degree: c(x)/x^(degree/2) as a polynomial in y = x + 1/x.
Polynomial in_sum_with_inverse(const Polynomial& c) {
  const std::size_t half = c.size() / 2;
  Polynomial before{cl_I(2)};         // x^0 + x^-0
  Polynomial here{cl_I(0), cl_I(1)};  // x + 1/x
  Polynomial result(half + 1, cl_I(0));
  result[0] = c[half];
  for (std::size_t i = 1; i <= half; ++i) {
    for (std::size_t j = 0; j < here.size(); ++j) result[j] = result[j] + c[half + i] * here[j];
    Polynomial next(here.size() + 1, cl_I(0));
    for (std::size_t j = 0; j < here.size(); ++j) next[j + 1] = here[j];
    for (std::size_t j = 0; j < before.size(); ++j) next[j] = next[j] - before[j];
    before = std::exchange(here, next);
  }
  return result;
}

cl_RA dyadic(long exponent) { return cln::recip(cl_RA(cln::ash(cl_I(1), exponent))); }

}  // namespace

FieldPointer quadratic_field(const cl_I& radicand) {
  const Enclosure root = [radicand](long precision) {
    cl_I below;
    cln::isqrt(cln::ash(radicand, 2 * precision), &below);
    return Interval(cl_RA(below) * dyadic(precision), cl_RA(below + 1) * dyadic(precision),
                    precision);
  };
  return std::make_shared<const NumberField>(Polynomial{-radicand, cl_I(0), cl_I(1)}, root,
                                             "Q(sqrt(" + to_text(radicand) + "))");
}

std::int64_t cosine_degree(std::int64_t denominator) {
  std::int64_t totient = 2 * denominator;
  std::int64_t rest = totient;
  for (std::int64_t p = 2; p * p <= rest; ++p) {
    if (rest % p != 0) continue;
    totient -= totient / p;
    while (rest % p == 0) rest /= p;
  }
  if (rest > 1) totient -= totient / rest;
  return totient / 2;
}

FieldPointer cosine_field(std::int64_t denominator) {
  // As in secant_less_one: CLN's cosine has 64 bits more than asked for, and 2^32 of its last places are allowed.
  const Enclosure generator = [denominator](long precision) {
    const auto digits =
        static_cast<unsigned long>(static_cast<double>(precision + 64) * 0.30103) + 2;
    const cln::cl_F angle =
        cln::pi(cln::float_format(digits)) / cl_I(static_cast<long>(denominator));
    const cl_RA twice = 2 * cln::rational(cln::cos(angle));
    return Interval(twice - dyadic(precision + 30), twice + dyadic(precision + 30), precision);
  };
  return std::make_shared<const NumberField>(in_sum_with_inverse(cyclotomic(2 * denominator)),
                                             generator,
                                             "Q(cos(pi/" + std::to_string(denominator) + "))");
}

}  // namespace magicmass::reference
