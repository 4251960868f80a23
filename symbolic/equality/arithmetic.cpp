// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/arithmetic.hpp"

#include <algorithm>
#include <cstdlib>

#include <cln/integer.h>

namespace magicmass::equality {
namespace {

long bits(const cln::cl_RA& x) {
  return static_cast<long>(
      std::max(cln::integer_length(cln::numerator(x)), cln::integer_length(cln::denominator(x))));
}

bool is_small_integer(const cln::cl_RA& x, long largest) {
  return is_integer(x) && cln::abs(x) <= largest;
}

Tree reciprocal(const Tree& tree) { return quotient(number(1), tree); }
Tree negative(const Tree& tree) {
  return is_number(tree) ? number(-tree->value) : product({number(-1), tree});
}

}  // namespace

Tree Arithmetic::checked(const cln::cl_RA& value, std::size_t column) const {
  if (bits(value) > limits_.bits)
    refuse_at(column, "a number of more than " + std::to_string(limits_.bits * 3 / 10) + " digits");
  return number(value);
}

Tree Arithmetic::checked(const Tree& tree, std::size_t column) const {
  if (tree->size > limits_.nodes)
    refuse_at(column, "more than " + std::to_string(limits_.nodes) + " operations");
  return tree;
}

Tree Arithmetic::sum(const std::vector<Tree>& terms, std::size_t column) const {
  cln::cl_RA rational = 0;
  std::vector<Tree> others;
  const auto add = [&](const Tree& term) {
    if (!is_number(term)) return others.push_back(term);
    rational = checked(rational + term->value, column)->value;
  };
  for (const Tree& term : terms) {
    if (term->kind == Kind::sum)
      for (const Tree& part : term->parts) add(part);
    else
      add(term);
  }
  if (others.empty()) return number(rational);
  if (rational != 0) others.push_back(number(rational));
  return others.size() == 1 ? others[0] : checked(equality::sum(others), column);
}

Tree Arithmetic::product(const std::vector<Tree>& above, const std::vector<Tree>& below,
                         std::size_t column) const {
  cln::cl_RA rational = 1;
  std::vector<Tree> over;
  std::vector<Tree> under;
  for (const Tree& factor : above) {
    if (is_number(factor))
      rational = checked(rational * factor->value, column)->value;
    else
      over.push_back(factor);
  }
  for (const Tree& factor : below) {
    if (is_number(factor, 0)) refuse_at(column, "division by zero");
    if (is_number(factor))
      rational = checked(rational / factor->value, column)->value;
    else
      under.push_back(factor);
  }
  if (rational != 1 || over.empty()) over.insert(over.begin(), number(rational));
  const Tree top = over.size() == 1 ? over[0] : equality::product(over);
  if (under.empty()) return checked(top, column);
  return checked(quotient(top, under.size() == 1 ? under[0] : equality::product(under)), column);
}

Tree Arithmetic::power(const Tree& base, const Tree& exponent, std::size_t column) const {
  if (!is_number(exponent)) return checked(equality::power(base, exponent), column);
  const cln::cl_RA n = exponent->value;
  if (is_number(base)) {
    const cln::cl_RA b = base->value;
    if (b == 0 && n == 0) refuse_at(column, "0^0 has no meaning");
    if (b == 0 && n < 0) refuse_at(column, "division by zero");
    if (b == 0 || b == 1) return base;
    if (b == -1 && is_integer(n)) return number(cln::oddp(cln::numerator(n)) ? -1 : 1);
    if (is_integer(n)) {
      // |b|^|n| has about |n| (bits - 1) bits or more
      if (!is_small_integer(n, limits_.bits) ||
          cln::abs(n) * (bits(b) > 1 ? bits(b) - 1 : 1) > limits_.bits)
        refuse_at(column,
                  "a power of more than " + std::to_string(limits_.bits * 3 / 10) + " digits");
      return checked(cln::expt(b, cln::numerator(n)), column);
    }
  }
  if (cln::abs(cln::numerator(n)) > limits_.exponent || cln::denominator(n) > limits_.exponent)
    refuse_at(column, "an exponent beyond " + std::to_string(limits_.exponent));
  return checked(equality::power(base, exponent), column);
}

Tree Arithmetic::call(const std::string& name, const std::vector<Tree>& arguments,
                      std::size_t column) const {
  if (arguments.size() != (name == "root" ? 2U : 1U))
    refuse_at(column, name == "root" ? "root takes two arguments: root(x, 5)"
                                     : name + " takes one argument");
  const Tree& x = arguments[0];
  const auto apply = [&](const char* function_name) { return function(function_name, x); };
  const auto result = [&]() -> Tree {
    if (name == "sqrt") return root(x, 2);
    if (name == "cbrt") return root(x, 3);
    if (name == "root") {
      const Tree& order = arguments[1];
      if (!is_number(order) || !is_small_integer(order->value, 100) || order->value < 2)
        refuse_at(column, "the order of a root is a whole number from 2 to 100");
      return root(x, cln::cl_I_to_long(cln::numerator(order->value)));
    }
    if (name == "sec") return reciprocal(apply("cos"));
    if (name == "csc" || name == "cosec") return reciprocal(apply("sin"));
    if (name == "cot") return quotient(apply("cos"), apply("sin"));
    if (name == "ln") return apply("log");
    if (name == "cosh" || name == "sinh" || name == "tanh") {
      const Tree up = apply("exp");
      const Tree down = function("exp", negative(x));
      const Tree plus = equality::sum({up, down});
      const Tree minus = difference(up, down);
      return name == "tanh" ? quotient(minus, plus)
                            : quotient(name == "cosh" ? plus : minus, number(2));
    }
    if (name.starts_with("arc")) return function("a" + name.substr(3), x);
    return function(name, x);
  };
  return checked(result(), column);
}

cln::cl_RA Arithmetic::read_number(const std::string& text, std::size_t column) const {
  const std::size_t mark = text.find('E');
  std::string digits = text.substr(0, mark);
  long scale = 0;
  if (mark != std::string::npos) {
    const std::string exponent = text.substr(mark + 1);
    if (exponent.size() > 7) refuse_at(column, "an exponent of more than 6 digits");
    scale = std::strtol(exponent.c_str(), nullptr, 10);
  }
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    scale -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  if (std::labs(scale) * 3 > limits_.bits)
    refuse_at(column, "a number of more than " + std::to_string(limits_.bits * 3 / 10) + " digits");
  const cln::cl_RA value = cln::cl_I(digits.c_str());
  return checked(value * cln::expt(cln::cl_RA(10), cln::cl_I(scale)), column)->value;
}

}  // namespace magicmass::equality
