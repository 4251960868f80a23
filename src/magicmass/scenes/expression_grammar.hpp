// SPDX-License-Identifier: MIT
// Reads an Expression with any arithmetic: sum of products of powers of atoms.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "magicmass/errors.hpp"

namespace magicmass {

/// What `Algebra` has: a type Number; number(digits), negated, added, subtracted, multiplied, divided,
/// raised(Number, digits) and root(digits), where digits is a text of decimal digits.
/// Nested at most 50 deep. Throws InvalidInput where the text is not well-formed, and whatever the algebra throws.
template <class Algebra>
class ExpressionReader {
public:
  using Number = typename Algebra::Number;

  ExpressionReader(std::string_view text, const Algebra& algebra)
      : rest_(text), algebra_(algebra) {}

  Number read() {
    Number value = sum(0);
    skip_blanks();
    if (!rest_.empty()) refuse();
    return value;
  }

private:
  std::string_view rest_;
  const Algebra& algebra_;

  [[noreturn]] void refuse() const {
    throw InvalidInput(rest_.empty() ? "the expression stops short"
                                     : "the expression makes no sense from \"" +
                                           std::string(rest_.substr(0, 20)) + "\" on");
  }

  void skip_blanks() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
  }

  bool take(std::string_view token) {
    skip_blanks();
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  std::string digits() {
    skip_blanks();
    const std::size_t end = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
    if (end == 0) refuse();
    std::string taken(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return taken;
  }

  Number sum(int depth) {
    if (depth > 50) throw InvalidInput("the expression is nested too deeply; allowed: 50 levels");
    Number value = product(depth);
    for (;;) {
      if (take("+"))
        value = algebra_.added(value, product(depth));
      else if (take("-"))
        value = algebra_.subtracted(value, product(depth));
      else
        return value;
    }
  }

  Number product(int depth) {
    Number value = signed_power(depth);
    for (;;) {
      if (take("*"))
        value = algebra_.multiplied(value, signed_power(depth));
      else if (take("/"))
        value = algebra_.divided(value, signed_power(depth));
      else
        return value;
    }
  }

  Number signed_power(int depth) {
    if (take("-")) return algebra_.negated(power(depth));
    return power(depth);
  }

  Number power(int depth) {
    Number base = atom(depth);
    return take("^") ? algebra_.raised(base, digits()) : base;
  }

  Number atom(int depth) {
    if (take("sqrt")) {
      if (!take("(")) refuse();
      const std::string radicand = digits();
      if (!take(")")) refuse();
      return algebra_.root(radicand);
    }
    if (take("(")) {
      Number inner = sum(depth + 1);
      if (!take(")")) refuse();
      return inner;
    }
    return algebra_.number(digits());
  }
};

}  // namespace magicmass
