// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include <cln/rational.h>

namespace magicmass::equality {

/// An expression as it was written. Nothing is simplified but arithmetic of rational numbers, for x/x, 0 log x
/// and sqrt(x)^2 are defined where they are, not where their simplified forms would be.
struct Node;
using Tree = std::shared_ptr<const Node>;  ///< parts may be shared between trees

/// What a node is, and which members then mean something.
enum class Kind {
  number,    ///< value
  pi,        //
  symbol,    ///< name
  sum,       ///< parts
  product,   ///< parts
  quotient,  ///< parts[0]/parts[1]
  power,     ///< parts[0]^parts[1]
  root,  ///< the root of order value >= 2 of parts[0]; odd orders are defined for negative numbers too
  function,  ///< name: abs sin cos tan atan asin acos exp log
};

/// An expression's outermost operation.
struct Node {
  Kind kind;                     ///< which one
  cln::cl_RA value = 0;          ///< of a number; a root's order
  std::string name = {};         ///< of a symbol or a function
  std::vector<Tree> parts = {};  ///< what it operates on
  std::size_t size = 1;          ///< nodes
  bool is_constant = true;       ///< no symbols
};

Tree number(const cln::cl_RA& value);  ///< a rational number
/// 3.14159...
Tree pi();
/// A symbol.
Tree symbol(const std::string& name);
/// The sum of the parts.
Tree sum(const std::vector<Tree>& parts);
/// The product of the parts.
Tree product(const std::vector<Tree>& parts);
/// above/below
Tree quotient(const Tree& above, const Tree& below);
/// base^exponent
Tree power(const Tree& base, const Tree& exponent);
/// The root of an order >= 2.
Tree root(const Tree& radicand, long order);
/// A function of function_names().
Tree function(const std::string& name, const Tree& argument);
/// left - right
Tree difference(const Tree& left, const Tree& right);

/// A rational number as it stands.
bool is_number(const Tree& tree);
/// This number as it stands.
bool is_number(const Tree& tree, long value);
/// This function of something.
bool is_function(const Tree& tree, const char* name);
/// A whole number.
bool is_integer(const cln::cl_RA& value);

/// The same trees.
bool identical(const Tree& left, const Tree& right);

/// Adds the names of the tree's symbols.
void collect_symbols(const Tree& tree, std::set<std::string>& names);
/// The names of its symbols.
std::set<std::string> symbols_of(const Tree& tree);

/// Every symbol of that name replaced; shared parts are rewritten once each.
Tree substituted(const Tree& tree, const std::string& name, const Tree& value);

/// The tree with other parts.
Tree with_parts(const Tree& tree, std::vector<Tree> parts);

/// As one would type it; reads back as an equal expression.
std::string to_text(const Tree& tree);

}  // namespace magicmass::equality
