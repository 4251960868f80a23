// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/number_field.hpp"

#include <algorithm>
#include <utility>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::reference {

using cln::cl_I;
using cln::cl_RA;

NumberField::NumberField(std::vector<cl_I> minimal, Enclosure generator, std::string name)
    : minimal_(std::move(minimal)), generator_(std::move(generator)), name_(std::move(name)) {}

std::vector<Interval> NumberField::powers(long precision) const {
  const Interval y = generator_(precision);
  std::vector<Interval> powers{Interval(1)};
  while (powers.size() < degree()) powers.push_back(powers.back() * y);
  return powers;
}

FieldNumber::FieldNumber(int value) : coefficients_{cl_RA(value)} {}
FieldNumber::FieldNumber(const cl_RA& value) : coefficients_{value} {}
FieldNumber::FieldNumber(FieldPointer field, std::vector<cl_RA> coefficients)
    : field_(std::move(field)), coefficients_(std::move(coefficients)) {
  shorten();
}

void FieldNumber::shorten() {
  const bool rational = std::all_of(coefficients_.begin() + 1, coefficients_.end(),
                                    [](const cl_RA& c) { return cln::zerop(c); });
  if (!rational) return;
  coefficients_.resize(1);
  field_ = nullptr;
}

int FieldNumber::sign() const {
  const auto sign_of = [](const cl_RA& x) { return cln::plusp(x) ? 1 : cln::minusp(x) ? -1 : 0; };
  if (is_rational()) return sign_of(rational());
  for (long precision = 64 + bits() / 2;; precision *= 2) {  // it is not 0, so this ends
    const Sign sign = enclosed(precision).sign();
    if (sign == Sign::positive) return 1;
    if (sign == Sign::negative) return -1;
  }
}

Interval FieldNumber::enclosed(long precision) const {
  if (is_rational()) return {rational(), precision};
  const std::vector<Interval> powers = field_->powers(precision + bits());
  Interval sum(coefficients_[0], precision);
  for (std::size_t i = 1; i < coefficients_.size(); ++i)
    if (!cln::zerop(coefficients_[i]))
      sum = sum + Interval(coefficients_[i], precision + bits()) * powers[i];
  return sum;
}

long FieldNumber::bits() const {
  long longest = 0;
  for (const cl_RA& c : coefficients_)
    longest = std::max(longest, static_cast<long>(cln::integer_length(cln::numerator(c)) +
                                                  cln::integer_length(cln::denominator(c))));
  return longest;
}

namespace {

template <class Operation>
std::vector<cl_RA> by_coefficients(const std::vector<cl_RA>& x, const std::vector<cl_RA>& y,
                                   const Operation& operation) {
  const cl_RA zero = 0;
  std::vector<cl_RA> result(std::max(x.size(), y.size()));
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = operation(i < x.size() ? x[i] : zero, i < y.size() ? y[i] : zero);
  return result;
}

void require_one_field(const FieldPointer& x, const FieldPointer& y) {
  if (x && y && x != y)
    throw InvalidInput("numbers of " + x->name() + " and of " + y->name() + " do not mix");
}

/// x of degree d or more becomes its remainder modulo the minimal polynomial.
void reduce(std::vector<cl_RA>& x, const std::vector<cl_I>& minimal) {
  const std::size_t degree = minimal.size() - 1;
  while (x.size() > degree) {
    const cl_RA top = x.back();
    x.pop_back();
    if (cln::zerop(top)) continue;
    for (std::size_t i = 0; i < degree; ++i)
      if (!cln::zerop(minimal[i]))
        x[x.size() - degree + i] = x[x.size() - degree + i] - top * minimal[i];
  }
}

}  // namespace

FieldNumber operator+(const FieldNumber& x, const FieldNumber& y) {
  require_one_field(x.field_, y.field_);
  return {x.field_ ? x.field_ : y.field_,
          by_coefficients(x.coefficients_, y.coefficients_,
                          [](const cl_RA& a, const cl_RA& b) { return a + b; })};
}

FieldNumber operator-(const FieldNumber& x, const FieldNumber& y) {
  require_one_field(x.field_, y.field_);
  return {x.field_ ? x.field_ : y.field_,
          by_coefficients(x.coefficients_, y.coefficients_,
                          [](const cl_RA& a, const cl_RA& b) { return a - b; })};
}

FieldNumber operator*(const FieldNumber& x, const FieldNumber& y) {
  require_one_field(x.field_, y.field_);
  const std::vector<cl_RA>&a = x.coefficients_, &b = y.coefficients_;
  std::vector<cl_RA> product(a.size() + b.size() - 1, cl_RA(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!cln::zerop(a[i]))
      for (std::size_t j = 0; j < b.size(); ++j) product[i + j] = product[i + j] + a[i] * b[j];
  const FieldPointer& field = x.field_ ? x.field_ : y.field_;
  if (field) reduce(product, field->minimal());
  return {field, std::move(product)};
}

/// Solves x z = 1, linear equations for z's coefficients.
FieldNumber FieldNumber::inverse() const {
  if (is_rational()) return cln::recip(rational());
  const std::size_t d = field_->degree();
  std::vector<std::vector<cl_RA>> rows(d, std::vector<cl_RA>(d + 1, cl_RA(0)));
  std::vector<cl_RA> column = coefficients_;
  for (std::size_t j = 0; j < d; ++j) {
    column.resize(d, cl_RA(0));
    for (std::size_t i = 0; i < d; ++i) rows[i][j] = column[i];
    column.insert(column.begin(), cl_RA(0));  // times y
    reduce(column, field_->minimal());
  }
  rows[0][d] = 1;
  for (std::size_t pivot = 0; pivot < d; ++pivot) {
    std::size_t found = pivot;
    while (cln::zerop(rows[found][pivot])) ++found;  // the matrix is regular: x is not 0
    std::swap(rows[found], rows[pivot]);
    const cl_RA scale = cln::recip(rows[pivot][pivot]);
    for (std::size_t j = pivot; j <= d; ++j) rows[pivot][j] = rows[pivot][j] * scale;
    for (std::size_t i = 0; i < d; ++i) {
      const cl_RA factor = rows[i][pivot];
      if (i == pivot || cln::zerop(factor)) continue;
      for (std::size_t j = pivot; j <= d; ++j) rows[i][j] = rows[i][j] - factor * rows[pivot][j];
    }
  }
  std::vector<cl_RA> solution(d);
  for (std::size_t i = 0; i < d; ++i) solution[i] = rows[i][d];
  return {field_, std::move(solution)};
}

FieldNumber operator/(const FieldNumber& x, const FieldNumber& y) {
  if (y.is_rational() && cln::zerop(y.rational())) throw InvalidInput("division by zero");
  return x * y.inverse();
}

bool operator==(const FieldNumber& x, const FieldNumber& y) {
  require_one_field(x.field_, y.field_);
  return x.coefficients_ == y.coefficients_;
}

template <class Float>
Float nearest(const FieldNumber& x) {
  if (x.is_rational()) return nearest<Float>(x.rational());
  for (long precision = 128 + x.bits();; precision *= 2) {  // irrational, so no tie
    const Interval at = x.enclosed(precision);
    const auto low = nearest<Float>(at.low());
    if (low == nearest<Float>(at.high())) return low;
  }
}
template double nearest(const FieldNumber&);
template long double nearest(const FieldNumber&);

std::string to_text(const FieldNumber& x) {
  if (x.is_rational()) return to_text(x.rational());
  std::string text;
  for (std::size_t i = 0; i < x.coefficients().size(); ++i) {
    const cl_RA& c = x.coefficients()[i];
    if (cln::zerop(c)) continue;
    const bool minus = cln::minusp(c);
    const std::string size = to_text(cln::abs(c));
    text += text.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
    if (i == 0) {
      text += size;
      continue;
    }
    if (size != "1") text += size + "*";
    text += i == 1 ? "y" : "y^" + std::to_string(i);
  }
  return text;
}

}  // namespace magicmass::reference
