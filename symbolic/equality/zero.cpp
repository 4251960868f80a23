// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "equality/constant.hpp"
#include "equality/from_ginac.hpp"
#include "equality/translation.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::equality {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

namespace {

constexpr std::size_t most_coefficients = 40;  // each is decided as an algebraic number

bool is_sine_or_cosine(const ex& e) {
  if (is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::posint))
    return is_sine_or_cosine(e.op(0));
  return is_a<GiNaC::function>(e) && (ex_to<GiNaC::function>(e).get_name() == "cos" ||
                                      ex_to<GiNaC::function>(e).get_name() == "sin");
}

// c + sum of c_i * (product of sines and cosines) >= c - sum of |c_i|.
bool is_bounded_below_by_zero(const ex& e) {
  GiNaC::numeric bound = 0;
  const auto add = [&](const ex& term) {
    GiNaC::numeric factor = 1;
    bool is_oscillating = false;
    const auto inspect = [&](const ex& part) {
      if (is_a<GiNaC::numeric>(part)) {
        factor = ex_to<GiNaC::numeric>(part);
        return factor.is_rational();
      }
      is_oscillating = true;
      return is_sine_or_cosine(part);
    };
    const bool known =
        is_a<GiNaC::mul>(term) ? std::all_of(term.begin(), term.end(), inspect) : inspect(term);
    bound += is_oscillating ? -GiNaC::abs(factor) : factor;
    return known;
  };
  const ex expanded = e.expand();
  const bool known = is_a<GiNaC::add>(expanded) ? std::all_of(expanded.begin(), expanded.end(), add)
                                                : add(expanded);
  return known && !bound.is_negative();
}

}  // namespace

bool Translation::is_constant(const ex& e) const {
  if (is_a<GiNaC::symbol>(e)) return named_.contains(ex_to<GiNaC::symbol>(e).get_name());
  return std::all_of(e.begin(), e.end(), [this](const ex& part) { return is_constant(part); });
}

bool Translation::is_zero(const ex& e) {
  if (form_->is_zero(e)) return true;
  // sum of coefficient * function: zero if all the coefficients are, whether or not the functions are independent
  const ex above = form_->simplified(e).numer().expand();
  std::map<std::string, ex> coefficients;
  const auto add = [&](const ex& term) {
    ex coefficient = 1;
    ex rest = 1;
    const auto inspect = [&](const ex& part) { (is_constant(part) ? coefficient : rest) *= part; };
    if (is_a<GiNaC::mul>(term))
      for (const ex& part : term) inspect(part);
    else
      inspect(term);
    coefficients.try_emplace(proof::to_text(rest), 0).first->second += coefficient;
  };
  if (is_a<GiNaC::add>(above))
    for (const ex& term : above) add(term);
  else
    add(above);
  if (coefficients.size() > most_coefficients) return false;
  return std::all_of(coefficients.begin(), coefficients.end(), [this](const auto& entry) {
    Tree constant = from_ginac(entry.second);
    for (const auto& [name, value] : named_) constant = substituted(constant, name, value);
    const auto sign = exact_sign_or_nothing(constant);
    return sign && *sign == 0;
  });
}

bool Translation::is_not_negative(const ex& e) {
  if (form_->is_positive(e) || is_bounded_below_by_zero(e)) return true;
  const ex fraction = form_->simplified(e).numer_denom();
  const ex factored = GiNaC::factor((fraction.op(0) * fraction.op(1)).expand());
  const auto is_square = [](const ex& part) {
    return is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::even);
  };
  if (is_square(factored)) return true;
  if (!is_a<GiNaC::mul>(factored)) return factored.is_zero();
  ex rest = 1;
  for (const ex& part : factored)
    if (!is_square(part)) rest *= part;
  return form_->is_positive(rest);
}

}  // namespace magicmass::equality
