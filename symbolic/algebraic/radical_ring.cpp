// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/radical_ring.hpp"

#include <algorithm>
#include <numeric>

#include <cln/integer.h>

#include "algebraic/cosine.hpp"

namespace magicmass::algebraic {

using cln::cl_I;
using cln::cl_RA;
using Monomial = RadicalRing::Monomial;
using Number = RadicalRing::Number;

namespace {

constexpr unsigned long longest_coefficient = 20000;  // bits

Monomial trimmed(Monomial monomial) {
  while (!monomial.empty() && monomial.back() == 0) monomial.pop_back();
  return monomial;
}

void add(Number& x, const Number& y) {
  for (const auto& [monomial, coefficient] : y) {
    RootSum& total = x[monomial];
    RootsOfUnity::add(total, coefficient);
    if (total.empty()) x.erase(monomial);
  }
}

}  // namespace

Number RadicalRing::number(const cl_RA& value) {
  if (cln::zerop(value)) return {};
  return {{Monomial{}, RootsOfUnity::number(value)}};
}

std::size_t RadicalRing::generator(long index, const Number& power) {
  const auto same = std::find_if(generators_.begin(), generators_.end(), [&](const Generator& g) {
    return g.index == index && g.power == power;
  });
  if (same != generators_.end()) return static_cast<std::size_t>(same - generators_.begin());
  generators_.push_back({index, power});
  return generators_.size() - 1;
}

Number RadicalRing::power_of_generator(std::size_t generator, long exponent, const cl_RA& factor) {
  Monomial monomial(generator + 1);
  monomial.back() = exponent;
  return {{trimmed(std::move(monomial)), RootsOfUnity::number(factor)}};
}

Number RadicalRing::sum(Number x, const Number& y) {
  add(x, y);
  return x;
}

Number RadicalRing::product(const Number& x, const Number& y) {
  Number result;
  for (const auto& [first, a] : x)
    for (const auto& [second, b] : y) {
      spent_ += static_cast<long>(a.size() * b.size());
      if (spent_ > work_.budget().terms) throw BeyondBudget("an expansion too long");
      work_.check_time();
      const RootSum coefficient = roots_.product(a, b);
      for (const auto& [exponent, value] : coefficient)
        if (cln::integer_length(cln::numerator(value)) > longest_coefficient)
          throw BeyondBudget("an expansion with numbers too long");
      if (!coefficient.empty()) add(result, product_of_monomials(first, second, coefficient));
    }
  return result;
}

Number RadicalRing::product_of_monomials(const Monomial& x, const Monomial& y,
                                         const RootSum& coefficient) {
  Monomial exponents(std::max(x.size(), y.size()));
  std::vector<std::size_t> reduced;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    exponents[i] = (i < x.size() ? x[i] : 0) + (i < y.size() ? y[i] : 0);
    if (exponents[i] < generators_[i].index) continue;
    exponents[i] -= generators_[i].index;
    reduced.push_back(i);
  }
  Number result = {{trimmed(std::move(exponents)), coefficient}};
  for (const std::size_t i : reduced) result = product(result, generators_[i].power);
  return result;
}

Number RadicalRing::power(Number x, cl_I n) {
  Number result = number(1);
  while (true) {
    if (cln::oddp(n)) result = product(result, x);
    n = cln::ash(n, -1);
    if (cln::zerop(n)) return result;
    x = product(x, x);
  }
}

Interval RadicalRing::enclosure(const Number& x, long precision) const {
  std::vector<Interval> generators;
  const auto value = [&](const Number& number) {
    Interval total(0, precision);
    for (const auto& [monomial, coefficient] : number) {
      // The coefficient is real: it is the sum of the real parts.
      Interval term(0, precision);
      for (const auto& [exponent, factor] : coefficient)
        term = algebraic::sum(
            term,
            algebraic::product({factor, precision},
                               cosine_of_turn(cl_RA(exponent) / roots_.order(), precision),
                               precision),
            precision);
      for (std::size_t i = 0; i < monomial.size(); ++i)
        if (monomial[i] > 0)
          term = algebraic::product(term, integer_power(generators[i], monomial[i], precision),
                                    precision);
      total = algebraic::sum(total, term, precision);
    }
    return total;
  };
  for (const Generator& generator : generators_) {
    work_.check_time();
    generators.push_back(real_root(value(generator.power), generator.index, precision));
  }
  return value(x);
}

bool RadicalRing::all_coefficients_vanish(const Number& x) const {
  return std::all_of(x.begin(), x.end(),
                     [&](const auto& term) { return roots_.vanishes(term.second); });
}

std::optional<int> RadicalRing::sign_of_nonzero(const Number& x) const {
  for (const long precision : {64L, 256L, 1024L}) {
    try {
      const int sign = enclosure(x, precision).sign();
      if (sign == 1 || sign == -1) return sign;
    } catch (const Unbounded&) {  // a radicand > 0 is not yet seen to be
    }
  }
  return {};
}

// Let g be the last generator in x, g^n = c. The case that is decided here is x = A + B g^k with A and B free of g.
// With d = gcd(n, k) and q = n/d, x = 0 means A = -B g^k, which implies A^q = (-B)^q c^(k/d), where g has gone. For an
// odd q the converse holds for real numbers; for an even one A and B must have opposite signs, too, or be 0.
std::optional<bool> RadicalRing::is_zero(const Number& x) {
  if (all_coefficients_vanish(x)) return true;
  std::size_t length = 0;
  for (const auto& [monomial, coefficient] : x) length = std::max(length, monomial.size());
  if (length == 0) return false;  // a sum of roots of unity, and not 0
  const std::size_t last = length - 1;
  std::map<long, Number> parts;
  for (const auto& [monomial, coefficient] : x) {
    if (roots_.vanishes(coefficient)) continue;
    const long exponent = monomial.size() == length ? monomial[last] : 0;
    Monomial others = monomial;
    if (exponent > 0) others.pop_back();
    parts[exponent].emplace(trimmed(std::move(others)), coefficient);
  }
  if (parts.size() == 1) return is_zero(parts.begin()->second);  // times g^k > 0
  if (parts.size() > 2 || parts.begin()->first != 0) return {};
  const auto& [k, B] = *parts.rbegin();
  const Number& A = parts.begin()->second;
  const long n = generators_[last].index;
  const long d = std::gcd(n, k);
  const long q = n / d;
  const Number right =
      product(power(product(B, number(-1)), q), power(generators_[last].power, k / d));
  const std::optional<bool> equal = is_zero(sum(power(A, q), product(right, number(-1))));
  if (!equal) return is_zero(B) == true ? is_zero(A) : std::nullopt;
  if (!*equal || q % 2 != 0) return equal;
  const std::optional<int> sign_of_A = sign_of_nonzero(A);
  const std::optional<int> sign_of_B = sign_of_nonzero(B);
  if (sign_of_A && sign_of_B) return *sign_of_A == -*sign_of_B;
  if (is_zero(A) == true) return true;  // and then B, as A^q = (-B)^q c^(k/d) and c > 0
  return {};
}

}  // namespace magicmass::algebraic
