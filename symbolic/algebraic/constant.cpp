// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/constant.hpp"

#include <algorithm>

#include <ginac/ginac.h>

#include "algebraic/decimal_text.hpp"
#include "algebraic/decision.hpp"
#include "algebraic/translation.hpp"

namespace magicmass::algebraic {
using cln::cl_I;

Decision sign_of(const GiNaC::ex& constant, const Budget& budget) {
  const Work work(budget);
  Terms terms(budget);
  try {
    const Verdict verdict = decide(terms, translate(constant, terms, work), work);
    return {verdict.sign, verdict.method, 0};
  } catch (const SignLeftOpen& reason) {
    return {{}, std::string("beyond the budget: ") + reason.what(), reason.agreeing_digits};
  } catch (const BeyondBudget& reason) {
    return {{}, std::string("beyond the budget: ") + reason.what(), 0};
  }
}

Decimals decimals(const GiNaC::ex& constant, long digits, const Budget& budget) {
  const Work work(budget);
  Terms terms(budget);
  const std::size_t term = translate(constant, terms, work);
  digits = std::max(0L, digits);
  const cl_I unit = digits == 0 ? cl_I(1) : cln::expt_pos(cl_I(10), cl_I(digits));
  const long least = 64 + static_cast<long>(cln::integer_length(unit));
  for (long precision = least; precision <= std::max(budget.bits, least); precision *= 2) {
    try {
      const Interval value = terms.enclosure(term, precision, work);
      const cl_I below = cln::floor1(value.low().rational() * unit);
      const cl_I above = cln::ceiling1(value.high().rational() * unit);
      if (above - below <= 2) return {decimal_text(below, digits), decimal_text(above, digits)};
    } catch (const Unbounded&) {  // a divisor is not yet seen to differ from 0
    }
  }
  throw BeyondBudget("more than " + std::to_string(budget.bits) + " bits");
}

}  // namespace magicmass::algebraic
