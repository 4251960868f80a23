// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/root_sum.hpp"

#include <algorithm>

#include <cln/integer.h>

namespace magicmass::algebraic {
namespace {

using cln::cl_I;
using cln::cl_RA;

void add_term(RootSum& x, long exponent, const cl_RA& coefficient) {
  const auto [entry, is_new] = x.emplace(exponent, coefficient);
  if (is_new) return;
  entry->second = entry->second + coefficient;
  if (cln::zerop(entry->second)) x.erase(entry);
}

/// x y modulo m < 2^40
long times(long x, long y, long m) {
  return cln::cl_I_to_long(cln::mod(cl_I(x) * cl_I(y), cl_I(m)));
}

/// The inverse of a modulo m, prime to each other.
long inverse(long a, long m) {
  cl_I u = 0;
  cl_I v = 0;
  cln::xgcd(cl_I(a), cl_I(m), &u, &v);
  return cln::cl_I_to_long(cln::mod(u, cl_I(m)));
}

RootSum difference(RootSum x, const RootSum& y) {
  for (const auto& [exponent, coefficient] : y) add_term(x, exponent, -coefficient);
  return x;
}

/// With z = exp(2 pi i/m) and p the first prime in `factors` of m.
bool vanishes(const RootSum& x, long m, std::map<long, long> factors) {
  if (x.empty()) return true;
  if (x.size() == 1) return false;
  const auto [p, power] = *factors.begin();
  const long rest = m / p;
  if (power == 1)
    factors.erase(p);
  else
    --factors[p];
  std::map<long, RootSum> parts;
  if (power > 1) {
    // 1, z, ..., z^(p-1) are linearly independent over the field of z^p, the root of order m/p: each part must vanish.
    for (const auto& [exponent, coefficient] : x) parts[exponent % p][exponent / p] = coefficient;
    return std::all_of(parts.begin(), parts.end(),
                       [&](const auto& part) { return vanishes(part.second, rest, factors); });
  }
  // z^j is exp(2 pi i s/p) times exp(2 pi i t/(m/p)) with j = s (m/p) + t p. Over the field of the second, p being
  // prime to m/p, the p-th roots of unity have the one relation that their sum is 0: all parts must be equal.
  const long s_of_one = inverse(rest % p, p);
  const long t_of_one = rest == 1 ? 0 : inverse(p % rest, rest);
  for (const auto& [exponent, coefficient] : x)
    parts[times(exponent, s_of_one, p)][rest == 1 ? 0 : times(exponent, t_of_one, rest)] =
        coefficient;
  if (static_cast<long>(parts.size()) < p)  // equal to an empty part
    return std::all_of(parts.begin(), parts.end(),
                       [&](const auto& part) { return vanishes(part.second, rest, factors); });
  const auto least =
      std::min_element(parts.begin(), parts.end(), [](const auto& first, const auto& second) {
        return first.second.size() < second.second.size();
      });
  return std::all_of(parts.begin(), parts.end(), [&](const auto& part) {
    return vanishes(difference(part.second, least->second), rest, factors);
  });
}

}  // namespace

RootsOfUnity::RootsOfUnity(long m) : m_(m) {
  long rest = m;
  for (long p = 2; rest > 1; ++p) {
    if (p * p > rest) p = rest;
    for (; rest % p == 0; rest /= p) ++factors_[p];
  }
}

RootSum RootsOfUnity::number(const cl_RA& value) {
  if (cln::zerop(value)) return {};
  return {{0, value}};
}

RootSum RootsOfUnity::cosine(const cl_RA& turn) const {
  const long exponent = cln::cl_I_to_long(cln::mod(cln::numerator(turn * m_), cl_I(m_)));
  RootSum result;
  add_term(result, exponent, cl_RA(1) / 2);
  add_term(result, exponent == 0 ? 0 : m_ - exponent, cl_RA(1) / 2);
  return result;
}

RootSum RootsOfUnity::product(const RootSum& x, const RootSum& y) const {
  RootSum result;
  for (const auto& [first, a] : x)
    for (const auto& [second, b] : y) add_term(result, (first + second) % m_, a * b);
  return result;
}

void RootsOfUnity::add(RootSum& x, const RootSum& y) {
  for (const auto& [exponent, coefficient] : y) add_term(x, exponent, coefficient);
}

bool RootsOfUnity::vanishes(const RootSum& x) const { return algebraic::vanishes(x, m_, factors_); }

}  // namespace magicmass::algebraic
