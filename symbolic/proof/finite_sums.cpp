// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/finite_sums.hpp"

#include <vector>

#include "proof/names.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

bool is_integer(const ex& e) { return is_a<numeric>(e) && ex_to<numeric>(e).is_integer(); }

bool is_reciprocal_factorial(const ex& e) {
  return is_a<GiNaC::power>(e) && e.op(1).is_equal(-1) && is_a<GiNaC::function>(e.op(0)) &&
         ex_to<GiNaC::function>(e.op(0)).get_name() == "factorial";
}

}  // namespace

std::optional<FiniteSum> finite_sum_of(const ex& sum) {
  if (!is_finite_sum(sum)) return std::nullopt;
  const ex &term = sum.op(0), &k = summation_index();
  FiniteSum shape;
  shape.front = 1;
  shape.x = 1;
  shape.y = 1;
  std::vector<ex> factorials;
  std::vector<std::pair<ex, ex>> powers;
  for (const ex& part : is_a<GiNaC::mul>(term) ? term : ex(GiNaC::lst{term})) {
    if (!part.has(k)) {
      shape.front *= part;
    } else if (is_reciprocal_factorial(part)) {
      factorials.push_back(part.op(0).op(0).expand());
    } else if (is_a<GiNaC::power>(part) && !part.op(0).has(k)) {
      if (part.op(0).is_equal(-1) && part.op(1).is_equal(k))
        shape.alternating = !shape.alternating;
      else
        powers.emplace_back(part.op(0), part.op(1).expand());
    } else {
      return std::nullopt;
    }
  }
  if (factorials.size() != 2) return std::nullopt;
  const auto slope = [&](const ex& e) { return e.coeff(k, 1); };
  for (const ex& argument : factorials)
    if (argument.degree(k) != 1 || !is_integer(slope(argument))) return std::nullopt;
  if (slope(factorials[0]).info(GiNaC::info_flags::negative))
    std::swap(factorials[0], factorials[1]);
  shape.p = factorials[0];
  shape.q = factorials[1];
  const ex a = slope(shape.p), b = shape.p.coeff(k, 0), c = shape.q.coeff(k, 0),
           d = -slope(shape.q);
  if (!a.info(GiNaC::info_flags::positive) || !d.info(GiNaC::info_flags::positive) ||
      !is_integer(b))
    return std::nullopt;
  if (!sum.op(1).is_equal(ceiling(-b / a)) || !sum.op(2).is_equal(floor(c / d)))
    return std::nullopt;
  for (const auto& [base, exponent] : powers) {
    if (exponent.is_equal(shape.p))
      shape.x *= base;
    else if (exponent.is_equal(shape.q))
      shape.y *= base;
    else
      return std::nullopt;
  }
  return shape;
}

}  // namespace magicmass::proof
