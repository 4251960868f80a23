// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/cosine_field.hpp"

#include <algorithm>
#include <numeric>

#include "algebraic/cosine.hpp"
#include "algebraic/cosine_polynomial.hpp"

namespace magicmass::algebraic {

using cln::cl_RA;

CosineField::CosineField(long m) : m_(m), minimal_(cosine_polynomial(m)) {
  const auto d = static_cast<std::size_t>(minimal_.degree());
  powers_.push_back(number(1));
  while (powers_.size() < 2 * d) {
    const Element& last = powers_.back();
    Element next(d);
    for (std::size_t i = 0; i < d; ++i)  // y^d = -(the rest of the monic minimal polynomial)
      next[i] = (i > 0 ? last[i - 1] : cl_RA(0)) - last[d - 1] * minimal_.coefficients[i];
    powers_.push_back(next);
  }
  // V_j = y V_(j-1) - V_(j-2) as in cosine_polynomial()
  Element before = number(2);
  Element now = powers_[1 % powers_.size()];
  for (long j = 1; 2 * j < m; ++j) {
    if (std::gcd(j, m) == 1) {
      automorphisms_.push_back(j);
      images_.push_back(now);
    }
    before = combination(1, product(powers_[1], now), -1, before);
    before.swap(now);
  }
}

long CosineField::representative(long j) const { return std::min(j % m_, m_ - j % m_); }

CosineField::Element CosineField::number(const cl_RA& value) const {
  Element result(static_cast<std::size_t>(minimal_.degree()));
  result[0] = value;
  return result;
}

// P(y) = 0, so y (P(y) - P(0))/y = -P(0).
CosineField::Element CosineField::generator_inverse() const {
  Element result;
  for (std::size_t i = 1; i < minimal_.coefficients.size(); ++i)
    result.push_back(-cl_RA(minimal_.coefficients[i]) / minimal_.coefficients[0]);
  return result;
}

CosineField::Element CosineField::image(long automorphism, const Element& x) const {
  const auto at = std::find(automorphisms_.begin(), automorphisms_.end(), automorphism) -
                  automorphisms_.begin();
  const Element& y = images_[static_cast<std::size_t>(at)];
  Element result = number(0);
  for (std::size_t i = x.size(); i-- > 0;)
    result = combination(1, product(result, y), 1, number(x[i]));
  return result;
}

CosineField::Element CosineField::product(const Element& x, const Element& y) const {
  Element result = number(0);
  std::vector<cl_RA> wide(2 * x.size() - 1);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j) wide[i + j] = wide[i + j] + x[i] * y[j];
  for (std::size_t i = 0; i < wide.size(); ++i)
    if (!cln::zerop(wide[i])) result = combination(1, result, wide[i], powers_[i]);
  return result;
}

CosineField::Element CosineField::combination(const cl_RA& a, const Element& x, const cl_RA& b,
                                              const Element& y) {
  Element result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) result[i] = a * x[i] + b * y[i];
  return result;
}

int CosineField::sign(const Element& x) const {
  for (long precision = 64;; precision *= 2) {
    const Interval y =
        algebraic::product({2, precision}, cosine_of_turn(cl_RA(1) / m_, precision), precision);
    Interval result(0, precision);
    for (std::size_t i = x.size(); i-- > 0;)
      result = sum(algebraic::product(result, y, precision), {x[i], precision}, precision);
    if (result.sign() != 2) return result.sign();
  }
}

}  // namespace magicmass::algebraic
