// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/exact_value.hpp"

#include <numeric>
#include <string>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"
#include "magicmass/scenes/expression_grammar.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_RA;

constexpr unsigned long most_bits = 1UL << 16U;

/// Numbers a + b sqrt(d) with one d.
struct QuadraticAlgebra {
  using Number = ExactValue;

  static Number checked(Number x) {
    if (cln::zerop(x.root)) x.radicand = 0;
    for (const cl_RA& part : {x.rational, x.root})
      if (cln::integer_length(cln::numerator(part)) > most_bits ||
          cln::integer_length(cln::denominator(part)) > most_bits)
        throw InvalidInput("it has more than " + std::to_string(most_bits) + " bits");
    return x;
  }

  static cl_I common(const Number& x, const Number& y) {
    if (cln::zerop(x.radicand)) return y.radicand;
    if (!cln::zerop(y.radicand) && x.radicand != y.radicand)
      throw InvalidInput("it has two different square roots");
    return x.radicand;
  }

  static Number number(const std::string& digits) { return checked({parse_rational(digits)}); }
  static Number negated(const Number& x) { return {-x.rational, -x.root, x.radicand}; }
  static Number added(const Number& x, const Number& y) {
    return checked({x.rational + y.rational, x.root + y.root, common(x, y)});
  }
  static Number subtracted(const Number& x, const Number& y) { return added(x, negated(y)); }
  static Number multiplied(const Number& x, const Number& y) {
    const cl_I d = common(x, y);
    return checked({x.rational * y.rational + x.root * y.root * d,
                    x.rational * y.root + x.root * y.rational, d});
  }
  static Number divided(const Number& x, const Number& y) {
    const cl_RA norm = cln::square(y.rational) - cln::square(y.root) * y.radicand;
    if (cln::zerop(norm)) throw InvalidInput("it divides by zero");
    return multiplied(x, checked({y.rational / norm, -y.root / norm, y.radicand}));
  }
  static Number raised(const Number& x, const std::string& exponent) {
    if (exponent.size() > 6) throw InvalidInput("its exponent is above 999999");
    Number power{cl_RA(1)};
    Number square = x;
    for (unsigned long n = std::stoul(exponent); n > 0; n /= 2) {
      if (n % 2 == 1) power = multiplied(power, square);
      if (n > 1) square = multiplied(square, square);
    }
    return power;
  }
  static Number root(const std::string& digits) {
    if (digits.size() > 12) throw InvalidInput("a number under a root is above 999999999999");
    long radicand = std::stol(digits);
    long outside = 1;
    for (long p = 2; p * p <= radicand; ++p)
      while (radicand % (p * p) == 0) {
        radicand /= p * p;
        outside *= p;
      }
    if (radicand <= 1) return {cl_RA(outside * radicand)};
    return {cl_RA(0), cl_RA(outside), cl_I(radicand)};
  }
};

ExactValue secant(std::int64_t denominator) {
  ExactValue value;
  if (denominator == 3)
    value.rational = 1;
  else
    value.secant_of = denominator;
  return value;
}

/// 2 cos(pi j/denominator) in the field of y = 2 cos(pi/denominator).
FieldNumber cosine_multiple(const CommonField& common, std::int64_t j) {
  const FieldNumber y(common.field, [&] {
    std::vector<cl_RA> coefficients(common.field->degree(), cl_RA(0));
    coefficients[1] = 1;
    return coefficients;
  }());
  FieldNumber before(2), here = y;
  for (std::int64_t i = 1; i < j; ++i) {
    const FieldNumber next = y * here - before;
    before = here;
    here = next;
  }
  return here;
}

}  // namespace

ExactValue exact_value(const Value& value) {
  constexpr std::int64_t largest = std::int64_t{1} << 60U;
  if (const auto* number = std::get_if<double>(&value)) return {exact(*number)};
  if (const auto* magic = std::get_if<Magic>(&value)) {
    if (magic->k > largest) throw InvalidInput("k is above 2^60");
    return secant(2 * magic->k + 1);
  }
  if (const auto* deficient = std::get_if<Deficient>(&value)) {
    if (deficient->k > largest) throw InvalidInput("k is above 2^60");
    return secant(2 * (deficient->k + 1));
  }
  return ExpressionReader<QuadraticAlgebra>(std::get<Expression>(value).text, QuadraticAlgebra{})
      .read();
}

CommonField common_field(const std::vector<ExactValue>& values, std::int64_t most) {
  cl_I radicand = 0;
  std::int64_t denominator = 1;
  for (const ExactValue& value : values) {
    if (!cln::zerop(value.root)) {
      if (!cln::zerop(radicand) && radicand != value.radicand) return {};
      radicand = value.radicand;
    }
    if (value.secant_of == 0) continue;
    if (value.secant_of > 4 * most * most) return {};  // phi(n) >= sqrt(n/2)
    denominator = std::lcm(denominator, value.secant_of);
    if (denominator > 4 * most * most) return {};
  }
  if (denominator == 1)
    return {true, cln::zerop(radicand) ? nullptr : quadratic_field(radicand), 0};
  if (!cln::zerop(radicand) || cosine_degree(denominator) > most) return {};
  return {true, cosine_field(denominator), denominator};
}

FieldNumber in_field(const ExactValue& value, const CommonField& common) {
  if (value.secant_of > 0)
    return FieldNumber(2) / cosine_multiple(common, common.cosine_denominator / value.secant_of) -
           FieldNumber(1);
  if (cln::zerop(value.root)) return value.rational;
  return {common.field, {value.rational, value.root}};
}

Enclosure enclosure(const ExactValue& value) {
  if (value.secant_of > 0) {
    const bool odd = value.secant_of % 2 == 1;
    return enclosure(odd ? MassRatio(Magic{value.secant_of / 2})
                         : MassRatio(Deficient{value.secant_of / 2 - 1}));
  }
  const FieldNumber number = in_field(value, common_field({value}, 2));
  return [number](long precision) { return number.enclosed(precision); };
}

template <class Float>
Float nearest(const ExactValue& value) {
  if (value.secant_of > 0)
    return value.secant_of % 2 == 1 ? nearest_ratio<Float>(Magic{value.secant_of / 2})
                                    : nearest_ratio<Float>(Deficient{value.secant_of / 2 - 1});
  return nearest<Float>(in_field(value, common_field({value}, 2)));
}
template double nearest(const ExactValue&);
template long double nearest(const ExactValue&);

int sign(const ExactValue& value) {
  return value.secant_of > 0 ? 1 : in_field(value, common_field({value}, 2)).sign();
}

}  // namespace magicmass::reference
