// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/surd.hpp"

#include <algorithm>
#include <sstream>

#include <cln/integer.h>
#include <cln/integer_io.h>
#include <ginac/ginac.h>

namespace magicmass::algebraic {
namespace {

using cln::cl_I;
using cln::cl_RA;

std::string integer_text(const cl_I& n) {
  std::ostringstream out;
  out << n;
  return out.str();
}

/// The term without its sign: 2*sqrt(3), sqrt(5)/2, 2/sqrt(5) for 2/5 sqrt(5).
std::string unsigned_text(const SurdTerm& term) {
  const cl_I above = cln::abs(cln::numerator(term.coefficient));
  const cl_I below = cln::denominator(term.coefficient);
  const std::string root = "sqrt(" + to_text(term.radicand) + ")";
  if (term.radicand.terms.empty() && below == term.radicand.rational)
    return integer_text(above) + "/" + root;
  return (above == 1 ? "" : integer_text(above) + "*") + root +
         (below == 1 ? "" : "/" + integer_text(below));
}

Surd scaled(Surd surd, const cl_RA& factor) {
  surd.rational = surd.rational * factor;
  for (SurdTerm& term : surd.terms) term.coefficient = term.coefficient * factor;
  return surd;
}

/// The largest s with s^2 dividing n whose primes are small.
cl_I square_part(cl_I n) {
  cl_I root = 1;
  for (long p = 2; p < 100; ++p)
    for (const cl_I square = p * p; cln::zerop(cln::mod(n, square)); root = root * p)
      n = cln::exquo(n, square);
  return root;
}

}  // namespace

std::string to_text(const Surd& surd) {
  std::vector<std::pair<bool, std::string>> parts;  // is negative, the rest
  const auto put_rational = [&] {
    if (cln::zerop(surd.rational)) return;
    const cl_RA size = cln::abs(surd.rational);
    const cl_I below = cln::denominator(size);
    parts.emplace_back(
        cln::minusp(surd.rational),
        integer_text(cln::numerator(size)) + (below == 1 ? "" : "/" + integer_text(below)));
  };
  // What is positive in front, the rational number first unless it is negative.
  if (cln::plusp(surd.rational)) put_rational();
  for (const bool negative : {false, true})
    for (const SurdTerm& term : surd.terms)
      if (cln::minusp(term.coefficient) == negative)
        parts.emplace_back(negative, unsigned_text(term));
  if (cln::minusp(surd.rational)) put_rational();
  std::string result;
  for (const auto& [negative, part] : parts)
    result += (result.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ")) + part;
  return result.empty() ? "0" : result;
}

GiNaC::ex expression(const Surd& surd) {
  GiNaC::ex result = GiNaC::numeric(surd.rational);
  for (const SurdTerm& term : surd.terms)
    result += GiNaC::numeric(term.coefficient) * GiNaC::sqrt(expression(term.radicand));
  return result;
}

Surd sum(Surd x, const Surd& y) {
  x.rational = x.rational + y.rational;
  for (const SurdTerm& term : y.terms) {
    const std::string radicand = to_text(term.radicand);
    const auto same = std::find_if(x.terms.begin(), x.terms.end(), [&](const SurdTerm& other) {
      return to_text(other.radicand) == radicand;
    });
    if (same == x.terms.end())
      x.terms.push_back(term);
    else
      same->coefficient = same->coefficient + term.coefficient;
  }
  std::erase_if(x.terms, [](const SurdTerm& term) { return cln::zerop(term.coefficient); });
  return x;
}

Surd square_root(const Surd& radicand, int sign) {
  // radicand = content * rest with integers without a common divisor in rest; content = (a b)/b^2
  cl_I above = cln::numerator(radicand.rational);
  cl_I below = cln::denominator(radicand.rational);
  for (const SurdTerm& term : radicand.terms) {
    above = cln::gcd(above, cln::numerator(term.coefficient));
    below = cln::lcm(below, cln::denominator(term.coefficient));
  }
  above = cln::abs(above);
  const cl_I s = square_part(above * below);
  const cl_RA outside = cl_RA(s) / below;
  Surd whole{0, {{sign * outside, scaled(radicand, 1 / (outside * outside))}}};
  if (radicand.terms.empty()) {
    if (whole.terms[0].radicand.rational == 1) return {sign * outside, {}};
    return whole;
  }
  // Only what divides both: squares of integers out of the root, or of the denominator alone.
  const cl_I t = square_part(above);
  Surd inside{0, {{sign * cl_RA(t), scaled(radicand, cl_RA(1) / (t * t))}}};
  return to_text(inside).size() <= to_text(whole).size() ? inside : whole;
}

}  // namespace magicmass::algebraic
