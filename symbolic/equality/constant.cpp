// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/constant.hpp"

#include <ginac/ginac.h>

#include "algebraic/constant.hpp"
#include "equality/angle.hpp"
#include "equality/evaluate.hpp"
#include "equality/point.hpp"

namespace magicmass::equality {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

const algebraic::Budget budget{.time = std::chrono::milliseconds(500)};  // a question
constexpr int digits_for_signs = 400;                     // of what is known not to vanish
constexpr int digits_for_multiples[] = {100, 400, 1600};  // of pi, 0 or not
constexpr long most_factors =
    100;  // of complex or real numbers multiplied for angles and logarithms

std::optional<int> sign_of_nonzero(const Tree& constant) {
  try {
    return sign(evaluate_to(constant, digits_for_signs, exact_sign_or_nothing));
  } catch (const NotCertain&) {
    return std::nullopt;
  }
}

ExactResult nonzero(const Tree& constant, const std::string& method) {
  return {sign_of_nonzero(constant), true, method};
}

std::optional<ExactResult> as_algebraic_number(const Tree& constant) {
  const algebraic::Decision decision = algebraic::sign_of(equality::algebraic(constant), budget);
  if (!decision.sign) return std::nullopt;
  return ExactResult{decision.sign, *decision.sign != 0, decision.method};
}

// pi is transcendental: a polynomial in it with algebraic coefficients vanishes only if they all do.
std::optional<ExactResult> as_polynomial_in_pi(const Tree& constant) {
  const ex pi_symbol = GiNaC::realsymbol("pi");
  const ex form = equality::algebraic(constant, &pi_symbol);
  if (!form.has(pi_symbol)) {  // it cancelled
    const algebraic::Decision decision = algebraic::sign_of(form, budget);
    if (!decision.sign) return std::nullopt;
    return ExactResult{decision.sign, *decision.sign != 0, decision.method};
  }
  const ex above = form.normal().numer().expand();
  const std::string method =
      "pi is transcendental, so the difference, a rational function of pi, is zero only if all its "
      "algebraic coefficients are";
  for (int power = above.ldegree(pi_symbol); power <= above.degree(pi_symbol); ++power) {
    const algebraic::Decision decision = algebraic::sign_of(above.coeff(pi_symbol, power), budget);
    if (!decision.sign) return std::nullopt;
    if (*decision.sign != 0) return nonzero(constant, method);
  }
  return ExactResult{0, false, method};
}

numeric common_denominator(const LinearForm& form) {
  numeric denominator = 1;
  for (const auto& [factor, function] : form.terms)
    denominator = GiNaC::lcm(denominator, numeric(factor).denom());
  return denominator;
}

bool are_all(const LinearForm& form, bool logarithms) {
  for (const auto& [factor, function] : form.terms)
    if (is_function(function, "log") != logarithms) return false;
  return !form.terms.empty();
}

// The sum of arguments of complex numbers is a multiple of pi exactly when their product is real; below pi in
// size it is then zero.
std::optional<ExactResult> as_sum_of_angles(const Tree& constant) {
  const LinearForm form = linear_form(at({}, constant));
  if (!are_all(form, false)) return std::nullopt;
  if (!form.rest.empty()) {
    ExactResult rest = exact_sign(sum(form.rest));
    if (!rest.is_nonzero) return std::nullopt;
    if (*rest.is_nonzero) {
      equality::algebraic(sum(form.rest));  // throws where something is not algebraic
      for (const auto& [factor, function] : form.terms) equality::algebraic(function->parts[0]);
      return nonzero(constant,
                     "an algebraic number other than 0 is no sum of inverse trigonometric "
                     "functions of algebraic numbers (Baker)");
    }
  }
  const numeric denominator = common_denominator(form);
  const numeric turns = numeric(form.of_pi) * denominator;
  ex real = cos(turns * GiNaC::Pi);
  ex imaginary = sin(turns * GiNaC::Pi);
  long factors = 0;
  for (const auto& [factor, function] : form.terms) {
    const ex u = equality::algebraic(function->parts[0]);
    const long count = (numeric(factor) * denominator).to_long();
    if ((factors += std::labs(count)) > most_factors) return std::nullopt;
    ex cosine = 1;
    ex sine = u;
    if (function->name == "asin") cosine = sqrt(1 - u * u);
    if (function->name == "acos") {
      cosine = u;
      sine = sqrt(1 - u * u);
    }
    if (count < 0) sine = -sine;
    for (long i = 0; i < std::labs(count); ++i) {
      const ex next = (real * cosine - imaginary * sine).expand();
      imaginary = (imaginary * cosine + real * sine).expand();
      real = next;
    }
  }
  const algebraic::Decision decision = algebraic::sign_of(imaginary, budget);
  if (!decision.sign) return std::nullopt;
  const std::string product =
      "the difference is a sum of angles of complex numbers with algebraic parts; their product "
      "is ";
  if (*decision.sign != 0) return nonzero(constant, product + "not real, so it is not zero");
  const Tree size =
      equality::product({number(cln::the<cln::cl_RA>(denominator.to_cl_N())), constant});
  for (const int digits : digits_for_multiples) {
    const Ball ball = evaluate_to(size, digits, exact_sign_or_nothing);
    if (cln::abs(ball.middle) + ball.radius < cln::cl_F(3.0))  // < pi
      return ExactResult{
          0, false,
          product + "real, so it is a multiple of pi" +
              (denominator.is_equal(1) ? std::string()
                                       : "/" + std::to_string(denominator.to_long())) +
              ", and its size is below that: it is 0"};
    if (sign(ball)) return nonzero(constant, "the difference is a multiple of pi");
  }
  return std::nullopt;
}

// log is one-to-one: a sum of whole multiples vanishes exactly when the product of powers is 1.
std::optional<ExactResult> as_sum_of_logarithms(const Tree& constant) {
  const LinearForm form = linear_form(at({}, constant));
  if (!are_all(form, true) || !form.rest.empty() || form.of_pi != 0) return std::nullopt;
  const numeric denominator = common_denominator(form);
  ex total = 1;
  for (const auto& [factor, function] : form.terms) {
    const numeric count = numeric(factor) * denominator;
    if (GiNaC::abs(count) > most_factors) return std::nullopt;
    total *= GiNaC::pow(equality::algebraic(function->parts[0]), count);
  }
  const algebraic::Decision decision = algebraic::sign_of(total - 1, budget);
  if (!decision.sign) return std::nullopt;
  const std::string method = "the difference is the logarithm of an algebraic number, which is ";
  if (*decision.sign == 0) return ExactResult{0, false, method + "1"};
  return ExactResult{decision.sign, true, method + "not 1"};
}

// atan(1/5) + 1 - atan(1/5): what cancels term by term.
std::optional<ExactResult> as_rest_of_cancelled_terms(const Tree& constant) {
  const LinearForm form = linear_form(at({}, constant));
  if (!form.terms.empty()) return std::nullopt;
  std::vector<Tree> left = form.rest;
  if (form.of_pi != 0) left.push_back(equality::product({number(form.of_pi), pi()}));
  const Tree rest = left.empty() ? number(0) : at({}, sum(left));
  if (rest->size >= constant->size) return std::nullopt;
  ExactResult result = exact_sign(rest);
  if (!result.is_nonzero) return std::nullopt;
  return result;
}

}  // namespace

ExactResult exact_sign(const Tree& constant) {
  if (is_number(constant)) {
    const int sign = constant->value == 0 ? 0 : constant->value < 0 ? -1 : 1;
    return {sign, sign != 0, "rational numbers, compared exactly"};
  }
  try {
    return as_algebraic_number(constant).value_or(ExactResult{});
  } catch (const OutsideConstants&) {
  } catch (const algebraic::NotAlgebraic&) {
  } catch (const GiNaC::pole_error&) {
    return {};
  }
  for (const auto method :
       {as_polynomial_in_pi, as_rest_of_cancelled_terms, as_sum_of_angles, as_sum_of_logarithms}) {
    try {
      if (const auto result = method(constant)) return *result;
    } catch (const OutsideConstants&) {
    } catch (const algebraic::NotAlgebraic&) {
    } catch (const NotCertain&) {
    } catch (const NotDefined&) {
    } catch (const GiNaC::pole_error&) {
    }
  }
  return {};
}

std::optional<int> exact_sign_or_nothing(const Tree& constant) { return exact_sign(constant).sign; }

}  // namespace magicmass::equality
