// SPDX-License-Identifier: GPL-2.0-or-later
// The one visitor of formulas: it decides structure, parentheses and signs; a Style writes them.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "kernel/expr.hpp"

namespace render {
using Strings = std::vector<std::string>;

/// Of a variable or function: c'_n has head c, a prime, index n.
struct Name {
  std::string head;
  bool is_primed;
  std::string index;  ///< or empty
};
/// Letters that are written as words, and themselves.
inline const std::map<std::string, std::string> greek{
    {"lambda", "λ"}, {"Lambda", "Λ"}, {"Gamma", "Γ"}, {"alpha", "α"},
    {"theta", "θ"},  {"kappa", "κ"},  {"delta", "δ"}, {"beta", "β"},
    {"psi", "ψ"},    {"pi", "π"},     {"rho", "ρ"}};

/// How one notation writes what the visitor has decided.
struct Style {
  virtual ~Style() = default;
  virtual std::string name(const Name& name) const = 0;
  virtual std::string number(const std::string& digits) const = 0;
  virtual std::string indexed(const std::string& base, const std::string& index) const = 0;
  virtual std::string call(const std::string& function, const std::string& arguments) const = 0;
  virtual std::string fraction(const std::string& over, const std::string& under) const = 0;
  virtual std::string power(const std::string& base, const std::string& exponent) const = 0;
  virtual std::string root(const std::string& radicand) const = 0;
  virtual std::string ceiling(const std::string& argument) const = 0;
  virtual std::string matrix(const std::vector<Strings>& rows) const = 0;
  virtual std::string parentheses(const std::string& inside) const = 0;
  virtual std::string product(const Strings& factors) const = 0;
  /// " + ", "-", ", ", " = ", " <= ", " and ", "not ", "for every integer ": what stands between
  /// terms and formulas.
  virtual std::string word(const std::string& word) const = 0;
};
/// A closed term, matrix or formula. Throws kernel::Refused for anything else.
std::string formula(kernel::Expr e, const Style& style);
}  // namespace render
