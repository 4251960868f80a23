// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "equality/angle.hpp"
#include "equality/constant.hpp"
#include "equality/evaluate.hpp"
#include "equality/point.hpp"

namespace magicmass::equality {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

constexpr long largest_multiple = 64;  // of an angle: (C + i S)^k is written out
constexpr int sign_digits = 300;

class AlgebraicForm {
public:
  explicit AlgebraicForm(const ex* symbol_for_pi) : symbol_for_pi_(symbol_for_pi) {}

  ex form(const Tree& tree) {
    switch (tree->kind) {
      case Kind::number:
        return numeric(tree->value);
      case Kind::pi:
        if (symbol_for_pi_ != nullptr) return *symbol_for_pi_;
        throw OutsideConstants("pi outside of cos and sin");
      case Kind::symbol:
        throw OutsideConstants("a symbol: " + tree->name);
      case Kind::sum: {
        ex total = 0;
        for (const Tree& part : tree->parts) total += form(part);
        return total;
      }
      case Kind::product: {
        ex total = 1;
        for (const Tree& part : tree->parts) total *= form(part);
        return total;
      }
      case Kind::quotient:
        return form(tree->parts[0]) / form(tree->parts[1]);
      case Kind::power:
        return power(tree);
      case Kind::root:
        return root(tree->parts[0], numeric(tree->value));
      case Kind::function:
        return function(tree);
    }
    throw OutsideConstants("an unknown kind of expression");
  }

private:
  struct Pair {
    ex cosine, sine;
  };

  // Never a guess: a sign that is not certain puts the constant outside.
  static int certain_sign(const Tree& tree) {
    try {
      if (const auto sign = equality::sign(evaluate_to(tree, sign_digits, exact_sign_or_nothing)))
        return *sign;
    } catch (const NotCertain&) {
    } catch (const NotDefined&) {
    }
    if (const auto sign = exact_sign_or_nothing(tree)) return *sign;
    throw OutsideConstants("the sign is not certain: " + to_text(tree));
  }

  ex root(const Tree& radicand, const numeric& order) {
    const ex inside = form(radicand);
    if (symbol_for_pi_ != nullptr && inside.has(*symbol_for_pi_))
      throw OutsideConstants("a root of pi");
    const int sign = certain_sign(radicand);
    if (sign == 0) return 0;
    if (sign < 0 && order.is_even()) throw OutsideConstants("the root of a negative number");
    return sign > 0 ? ex(GiNaC::pow(inside, 1 / order)) : ex(-GiNaC::pow(-inside, 1 / order));
  }

  ex power(const Tree& tree) {
    if (!is_number(tree->parts[1])) throw OutsideConstants("a power: " + to_text(tree));
    const numeric exponent(tree->parts[1]->value);
    const ex base =
        exponent.is_integer() ? form(tree->parts[0]) : root(tree->parts[0], exponent.denom());
    return GiNaC::pow(base, exponent.numer());
  }

  ex function(const Tree& tree) {
    const Tree& argument = tree->parts[0];
    if (tree->name == "abs")
      return certain_sign(argument) < 0 ? ex(-form(argument)) : form(argument);
    if (tree->name == "sin") return pair(argument).sine;
    if (tree->name == "cos") return pair(argument).cosine;
    if (tree->name == "tan") {
      const Pair value = pair(argument);
      return value.sine / value.cosine;
    }
    throw OutsideConstants("not algebraic in general: " + to_text(tree));
  }

  // cos and sin of a sum of rational multiples of pi and of inverse functions.
  Pair pair(const Tree& angle) {
    const LinearForm form_of_angle = linear_form(angle);
    if (!form_of_angle.rest.empty()) throw OutsideConstants("no multiple of pi: " + to_text(angle));
    const ex of_pi = numeric(form_of_angle.of_pi) * GiNaC::Pi;
    Pair total{GiNaC::cos(of_pi), GiNaC::sin(of_pi)};
    for (const auto& [factor, inverse] : form_of_angle.terms) {
      const Pair next = multiple(inverse, numeric(factor));
      total = {total.cosine * next.cosine - total.sine * next.sine,
               total.sine * next.cosine + total.cosine * next.sine};
    }
    return {total.cosine.expand(), total.sine.expand()};
  }

  Pair multiple(const Tree& inverse, const numeric& factor) {
    Pair base = of_inverse(inverse);
    bool up_to_pi = inverse->name == "acos";  // else within -pi/2 and pi/2
    for (numeric halves = factor.denom(); !halves.is_equal(1); halves = GiNaC::iquo(halves, 2)) {
      if (halves.is_odd()) throw OutsideConstants("an odd part of an angle");
      const ex cosine = sqrt((1 + base.cosine) / 2);
      base = {cosine, up_to_pi ? ex(sqrt((1 - base.cosine) / 2)) : base.sine / (2 * cosine)};
      up_to_pi = false;
    }
    if (GiNaC::abs(factor) * factor.denom() > largest_multiple)
      throw OutsideConstants("too large a multiple of an angle");
    const long k = factor.numer().to_long();
    Pair result{1, 0};
    for (long i = 0; i < std::labs(k); ++i)
      result = {(result.cosine * base.cosine - result.sine * base.sine).expand(),
                (result.sine * base.cosine + result.cosine * base.sine).expand()};
    if (k < 0) result.sine = -result.sine;
    return result;
  }

  Pair of_inverse(const Tree& inverse) {
    if (inverse->name == "log") throw OutsideConstants("a logarithm in an angle");
    const ex u = form(inverse->parts[0]);
    if (symbol_for_pi_ != nullptr && u.has(*symbol_for_pi_)) throw OutsideConstants("pi inside");
    if (inverse->name == "acos") return {u, sqrt(1 - u * u)};
    if (inverse->name == "asin") return {sqrt(1 - u * u), u};
    const ex cosine = 1 / sqrt(1 + u * u);
    return {cosine, u * cosine};
  }

  const ex* symbol_for_pi_;
};

}  // namespace

ex algebraic(const Tree& constant, const ex* symbol_for_pi) {
  try {
    return AlgebraicForm(symbol_for_pi).form(at({}, constant));
  } catch (const GiNaC::pole_error& error) {
    throw OutsideConstants(error.what());
  }
}

}  // namespace magicmass::equality
