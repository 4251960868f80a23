// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/terms.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <cln/integer_io.h>

#include "algebraic/cosine.hpp"

namespace magicmass::algebraic {

using cln::cl_I;
using cln::cl_RA;

namespace {

/// Hexadecimal digits, as the decimal ones of a long number take long.
std::string key(const Term& term) {
  std::ostringstream text;
  text << static_cast<int>(term.kind) << ' ';
  cln::fprinthexadecimal(text, cln::numerator(term.value));
  text << '/';
  cln::fprinthexadecimal(text, cln::denominator(term.value));
  text << '^';
  cln::fprinthexadecimal(text, term.exponent);
  for (const std::size_t part : term.parts) text << ' ' << part;
  return text.str();
}

}  // namespace

std::size_t Terms::add(Term term) {
  const auto [entry, is_new] = known_.emplace(key(term), terms_.size());
  if (is_new) {
    if (static_cast<long>(terms_.size()) >= most_)
      throw BeyondBudget("more than " + std::to_string(most_) + " different subexpressions");
    try {
      term.near = made(
          term,
          [this](std::size_t part) -> const Interval& {
            if (!terms_[part].near) throw Unbounded{};
            return *terms_[part].near;
          },
          near_precision);
      if (!term.sign && term.near->sign() != 2) term.sign = term.near->sign();
    } catch (const Unbounded&) {  // decided later, at a higher precision
    }
    terms_.push_back(std::move(term));
  }
  return entry->second;
}

std::size_t Terms::rational(const cl_RA& value) {
  return add({Kind::rational, value, {}, 0, cln::minusp(value) ? -1 : cln::zerop(value) ? 0 : 1});
}

// Even and of period 1: one term for all turns of one cosine.
std::size_t Terms::cosine(const cl_RA& turn) {
  cl_RA t = turn - cln::floor1(turn);
  if (t > cl_RA(1) / 2) t = 1 - t;
  if (cln::denominator(12 * t) == 1 &&
      (cln::denominator(4 * t) == 1 || cln::denominator(6 * t) == 1)) {
    // 0, 1/6, 1/4, 1/3, 1/2: the rational cosines, by Niven's theorem all there are
    if (cln::zerop(t)) return rational(1);
    if (t == cl_RA(1) / 6) return rational(cl_RA(1) / 2);
    if (t == cl_RA(1) / 4) return rational(0);
    return rational(t == cl_RA(1) / 3 ? cl_RA(-1) / 2 : cl_RA(-1));
  }
  return add({Kind::cosine, t, {}, 0, t < cl_RA(1) / 4 ? 1 : -1});
}

std::size_t Terms::sum(const std::vector<std::size_t>& parts) {
  cl_RA constant = 0;
  std::vector<std::size_t> others;
  for (const std::size_t part : parts) {
    if (terms_[part].kind == Kind::rational)
      constant = constant + terms_[part].value;
    else if (terms_[part].sign != 0)
      others.push_back(part);
  }
  if (others.empty()) return rational(constant);
  std::sort(others.begin(), others.end());
  if (!cln::zerop(constant)) others.push_back(rational(constant));
  return others.size() == 1 ? others.front() : add({Kind::sum, 0, std::move(others), 0, {}});
}

std::size_t Terms::product(const std::vector<std::size_t>& parts) {
  cl_RA constant = 1;
  std::vector<std::size_t> others;
  for (const std::size_t part : parts) {
    if (terms_[part].kind == Kind::rational)
      constant = constant * terms_[part].value;
    else if (terms_[part].sign == 0)
      return rational(0);
    else
      others.push_back(part);
  }
  if (others.empty() || cln::zerop(constant)) return rational(constant);
  std::sort(others.begin(), others.end());
  if (constant != 1) others.push_back(rational(constant));
  return others.size() == 1 ? others.front() : add({Kind::product, 0, std::move(others), 0, {}});
}

std::size_t Terms::power(std::size_t base, const cl_I& exponent) {
  if (exponent == 0) return rational(1);
  if (exponent == 1) return base;
  if (terms_[base].sign == 0) return rational(0);
  if (terms_[base].kind == Kind::rational && terms_[base].value == 1) return rational(1);
  return add({Kind::power, 0, {base}, exponent, {}});
}

std::size_t Terms::root(std::size_t radicand, long index) {
  cl_RA root = 0;
  if (terms_[radicand].kind == Kind::rational &&
      cln::rootp(terms_[radicand].value, cl_I(index), &root))
    return rational(root);
  return add({Kind::root, 0, {radicand}, index, 1});
}

std::vector<std::size_t> Terms::below(std::size_t id) const {
  std::vector<bool> needed(id + 1);
  needed[id] = true;
  std::vector<std::size_t> order;
  for (std::size_t term = id + 1; term-- > 0;) {
    if (!needed[term]) continue;
    order.push_back(term);
    for (const std::size_t part : terms_[term].parts) needed[part] = true;
  }
  std::reverse(order.begin(), order.end());
  return order;
}

template <class Enclosures>
Interval Terms::made(const Term& term, const Enclosures& part, long precision) {
  const auto folded = [&](const auto& operation) {
    Interval result = part(term.parts[0]);
    for (std::size_t i = 1; i < term.parts.size(); ++i)
      result = operation(result, part(term.parts[i]), precision);
    return result;
  };
  switch (term.kind) {
    case Kind::rational:
      return {term.value, precision};
    case Kind::cosine:
      return cosine_of_turn(term.value, precision);
    case Kind::sum:
      return folded([](auto&... arguments) { return algebraic::sum(arguments...); });
    case Kind::product:
      return folded([](auto&... arguments) { return algebraic::product(arguments...); });
    case Kind::power: {
      const Interval result =
          integer_power(part(term.parts[0]), cln::abs(term.exponent), precision);
      return cln::plusp(term.exponent) ? result : quotient({1, precision}, result, precision);
    }
    case Kind::root:
      return real_root(part(term.parts[0]), cln::cl_I_to_long(term.exponent), precision);
  }
  throw std::logic_error("a kind of term that has no enclosure");
}

Interval Terms::enclosure(std::size_t id, long precision, const Work& work) const {
  std::vector<std::optional<Interval>> values(id + 1);
  for (const std::size_t term : below(id)) {
    work.check_time();
    values[term] = made(
        terms_[term], [&](std::size_t part) -> const Interval& { return *values[part]; },
        precision);
  }
  return *values[id];
}

}  // namespace magicmass::algebraic
