// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "equality/parse.hpp"

namespace magicmass::equality {

// Trees as the parser builds them: flat sums and products, rational numbers computed. Each throws
// NotAnExpression, with the column, where that would divide by zero or make a number longer than the limit;
// how long it would be is estimated first.
class Arithmetic {
public:
  explicit Arithmetic(const Limits& limits) : limits_(limits) {}

  Tree sum(const std::vector<Tree>& terms, std::size_t column) const;
  Tree product(const std::vector<Tree>& above, const std::vector<Tree>& below,
               std::size_t column) const;
  Tree power(const Tree& base, const Tree& exponent, std::size_t column) const;
  // The functions of the language: sec, cot, arcsin, ln, ... in terms of those of a tree.
  Tree call(const std::string& name, const std::vector<Tree>& arguments, std::size_t column) const;
  cln::cl_RA read_number(const std::string& text, std::size_t column) const;

private:
  Tree checked(const cln::cl_RA& value, std::size_t column) const;
  Tree checked(const Tree& tree, std::size_t column) const;

  Limits limits_;
};

}  // namespace magicmass::equality
