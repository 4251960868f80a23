// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/evaluate.hpp"

#include <cln/exception.h>
#include <cln/integer.h>

namespace magicmass::equality {
namespace {

class Evaluation {
public:
  Evaluation(const BallArithmetic& arithmetic, const ExactSign& exact_sign)
      : arithmetic_(arithmetic), exact_sign_(exact_sign) {}

  Ball value(const Tree& tree) {
    switch (tree->kind) {
      case Kind::number:
        return arithmetic_.number(tree->value);
      case Kind::pi:
        return arithmetic_.pi();
      case Kind::symbol:
        throw NotCertain("a symbol without a value: " + tree->name);
      case Kind::sum: {
        Ball total = value(tree->parts[0]);
        for (std::size_t i = 1; i < tree->parts.size(); ++i)
          total = arithmetic_.sum(total, value(tree->parts[i]));
        return total;
      }
      case Kind::product: {
        Ball total = value(tree->parts[0]);
        for (std::size_t i = 1; i < tree->parts.size(); ++i)
          total = arithmetic_.product(total, value(tree->parts[i]));
        return total;
      }
      case Kind::quotient:
        return arithmetic_.product(value(tree->parts[0]), inverse(tree->parts[1]));
      case Kind::power:
        return power(tree);
      case Kind::root:
        return root(tree->parts[0], cln::cl_I_to_long(cln::numerator(tree->value)));
      case Kind::function:
        return function(tree);
    }
    throw NotCertain("an unknown kind of expression");
  }

private:
  static Ball certain(const std::optional<Ball>& ball) {
    if (!ball) throw NotCertain("not certain at this precision");
    return *ball;
  }

  int sign_of(const Tree& tree, const Ball& ball) {
    if (const auto sign = equality::sign(ball)) return *sign;
    if (const auto sign = exact_sign_ ? exact_sign_(tree) : std::nullopt) return *sign;
    throw NotCertain("the sign is not certain: " + to_text(tree));
  }

  Ball inverse(const Tree& tree) { return inverse(tree, value(tree)); }

  Ball inverse(const Tree& tree, const Ball& below) {
    if (sign_of(tree, below) == 0) throw NotDefined("division by zero: " + to_text(tree), true);
    return certain(arithmetic_.reciprocal(below));
  }

  Ball root(const Tree& radicand, long order) { return root(radicand, value(radicand), order); }

  Ball root(const Tree& radicand, const Ball& inside, long order) {
    const int sign = sign_of(radicand, inside);
    if (sign == 0) return arithmetic_.number(0);
    if (sign > 0) return certain(arithmetic_.root(inside, order));
    if (order % 2 == 0)
      throw NotDefined("the root of a negative number: " + to_text(radicand), false);
    return negative(certain(arithmetic_.root(negative(inside), order)));
  }

  static Ball negative(const Ball& ball) { return {-ball.middle, ball.radius}; }

  Ball whole_power(const Ball& base, cln::cl_I exponent) {
    Ball result = arithmetic_.number(1);
    Ball square = base;
    for (; exponent > 0; exponent = cln::ash(exponent, -1)) {
      if (cln::oddp(exponent)) result = arithmetic_.product(result, square);
      square = arithmetic_.product(square, square);
    }
    return result;
  }

  Ball power(const Tree& tree) {
    const Tree& base = tree->parts[0];
    const Tree& exponent = tree->parts[1];
    const Ball below = value(base);
    if (is_number(exponent)) {
      const cln::cl_RA n = exponent->value;
      const long order = cln::cl_I_to_long(cln::denominator(n));
      if (order > 1 && sign_of(base, below) < 0)
        throw NotDefined("a fractional power of a negative number: " + to_text(base), false);
      if (n <= 0 && sign_of(base, below) == 0)
        throw NotDefined("division by zero: " + to_text(tree), true);
      const Ball of_base = order > 1 ? root(base, below, order) : below;
      if (n >= 0) return whole_power(of_base, cln::numerator(n));
      return whole_power(certain(arithmetic_.reciprocal(of_base)), -cln::numerator(n));
    }
    const int sign = sign_of(base, below);
    if (sign == 0) throw NotCertain("a power of zero: " + to_text(tree));
    const Ball above = value(exponent);
    if (sign < 0) throw NotCertain("a power of a negative number: " + to_text(tree));
    return certain(
        arithmetic_.exponential(arithmetic_.product(above, certain(arithmetic_.logarithm(below)))));
  }

  // asin u = 2 atan(u/(1 + sqrt(1 - u^2))) for -1 <= u <= 1
  Ball arcsine(const Tree& argument) {
    const Ball u = value(argument);
    const Tree rest = difference(number(1), equality::power(argument, number(2)));
    const Ball inside = arithmetic_.sum(arithmetic_.number(1), negative(arithmetic_.product(u, u)));
    const int sign = sign_of(rest, inside);
    if (sign < 0) throw NotDefined("asin or acos beyond -1 and 1: " + to_text(argument), false);
    const Ball cosine = sign == 0 ? arithmetic_.number(0) : certain(arithmetic_.root(inside, 2));
    const Ball below =
        certain(arithmetic_.reciprocal(arithmetic_.sum(arithmetic_.number(1), cosine)));
    return arithmetic_.product(arithmetic_.number(2),
                               arithmetic_.arctangent(arithmetic_.product(u, below)));
  }

  Ball function(const Tree& tree) {
    const Tree& argument = tree->parts[0];
    if (tree->name == "asin") return arcsine(argument);
    if (tree->name == "acos")
      return arithmetic_.sum(
          arithmetic_.product(arithmetic_.pi(), arithmetic_.number(cln::cl_RA(1) / 2)),
          negative(arcsine(argument)));
    const Ball x = value(argument);
    if (tree->name == "sin") return certain(arithmetic_.sine(x));
    if (tree->name == "cos") return certain(arithmetic_.cosine(x));
    if (tree->name == "tan")
      return arithmetic_.product(
          certain(arithmetic_.sine(x)),
          inverse(equality::function("cos", argument), certain(arithmetic_.cosine(x))));
    if (tree->name == "atan") return arithmetic_.arctangent(x);
    if (tree->name == "abs") return arithmetic_.absolute(x);
    if (tree->name == "exp") return certain(arithmetic_.exponential(x));
    if (tree->name == "log") {
      const int sign = sign_of(argument, x);
      if (sign <= 0)
        throw NotDefined("the logarithm of a number that is not positive: " + to_text(argument),
                         sign == 0);
      return certain(arithmetic_.logarithm(x));
    }
    throw NotCertain("no value for " + tree->name);
  }

  const BallArithmetic& arithmetic_;
  const ExactSign& exact_sign_;
};

}  // namespace

Ball evaluate(const Tree& constant, const BallArithmetic& arithmetic, const ExactSign& exact_sign) {
  try {
    return Evaluation(arithmetic, exact_sign).value(constant);
  } catch (const cln::runtime_exception& error) {  // overflow and the like
    throw NotCertain(error.what());
  }
}

Ball evaluate_to(const Tree& constant, int digits, const ExactSign& exact_sign) {
  const BallArithmetic arithmetic(digits);
  if (!exact_sign) return evaluate(constant, arithmetic, {});
  try {
    return evaluate(constant, arithmetic, {});
  } catch (const NotCertain&) {
    return evaluate(constant, arithmetic, exact_sign);
  }
}

}  // namespace magicmass::equality
