// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/constant.hpp"

#include <algorithm>
#include <sstream>

#include <cln/integer_io.h>
#include <ginac/ginac.h>

#include "algebraic/decision.hpp"
#include "algebraic/translation.hpp"

namespace magicmass::algebraic {
namespace {

using cln::cl_I;

/// n / 10^digits
std::string decimal(const cl_I& n, long digits) {
  std::ostringstream stream;
  stream << cln::abs(n);
  std::string text = stream.str();
  const auto places = static_cast<std::size_t>(digits);
  if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
  if (places > 0) text.insert(text.size() - places, ".");
  return (cln::minusp(n) ? "-" : "") + text;
}

}  // namespace

Decision sign_of(const GiNaC::ex& constant, const Budget& budget) {
  const Work work(budget);
  Terms terms(budget);
  try {
    const Verdict verdict = decide(terms, translate(constant, terms, work), work);
    return {verdict.sign, verdict.method, 0};
  } catch (const Undecided& reason) {
    return {{}, std::string("beyond the budget: ") + reason.what(), reason.agreeing_digits};
  } catch (const BeyondBudget& reason) {
    return {{}, std::string("beyond the budget: ") + reason.what(), 0};
  }
}

Decimals decimals(const GiNaC::ex& constant, long digits, const Budget& budget) {
  const Work work(budget);
  Terms terms(budget);
  const std::size_t term = translate(constant, terms, work);
  const cl_I unit = cln::expt_pos(cl_I(10), cl_I(std::max(0L, digits)));
  const long least = 64 + static_cast<long>(cln::integer_length(unit));
  for (long precision = least; precision <= std::max(budget.bits, least); precision *= 2) {
    try {
      const Interval value = terms.enclosure(term, precision, work);
      const cl_I below = cln::floor1(value.low().rational() * unit);
      const cl_I above = cln::ceiling1(value.high().rational() * unit);
      if (above - below <= 2) return {decimal(below, digits), decimal(above, digits)};
    } catch (const Unbounded&) {  // a divisor is not yet seen to differ from 0
    }
  }
  throw BeyondBudget("more than " + std::to_string(budget.bits) + " bits");
}

}  // namespace magicmass::algebraic
