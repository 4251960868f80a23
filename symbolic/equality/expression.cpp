// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/expression.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include <cln/integer.h>
#include <cln/integer_io.h>
#include <cln/rational_io.h>

namespace magicmass::equality {
namespace {

Tree make(Node node) {
  for (const Tree& part : node.parts) {
    node.size += part->size;
    node.is_constant = node.is_constant && part->is_constant;
  }
  return std::make_shared<const Node>(std::move(node));
}

enum Precedence { of_sum, of_product, of_power, of_primary };

std::string parenthesised(bool needed, const std::string& inside) {
  return needed ? "(" + inside + ")" : inside;
}

std::string print(const Tree& tree, Precedence outer);

std::string print_number(const cln::cl_RA& value, Precedence outer) {
  std::ostringstream out;
  out << value;
  return parenthesised(
      (cln::minusp(value) && outer > of_sum) || (!is_integer(value) && outer > of_product),
      out.str());
}

std::string print_product(const Tree& tree, Precedence outer) {
  if (tree->parts.size() == 2 && is_number(tree->parts[0], -1))
    return parenthesised(outer > of_sum, "-" + print(tree->parts[1], of_product));
  const std::vector<Tree>& parts = tree->parts;
  if (parts.size() == 2 && is_number(parts[0]) && cln::numerator(parts[0]->value) == 1 &&
      !is_integer(parts[0]->value) && !is_number(parts[1]))  // x/2
    return print(quotient(parts[1], number(cln::denominator(parts[0]->value))), outer);
  std::string shown;
  for (const Tree& part : parts)
    shown += (shown.empty() ? "" : "*") + print(part, shown.empty() ? of_product : of_power);
  return parenthesised(outer > of_product, shown);
}

std::string print_sum(const Tree& tree, Precedence outer) {
  std::string shown;
  const auto add = [&](const Tree& part) {
    const std::string term = print(part, of_sum);
    const bool minus = term.starts_with('-');
    if (shown.empty())
      shown = term;
    else
      shown += (minus ? " - " : " + ") + (minus ? term.substr(1) : term);
  };
  std::vector<Tree> terms = tree->parts;
  if (terms.size() > 1 && is_number(terms.back()) && terms.back()->value > 0 &&
      print(terms[0], of_sum).starts_with('-'))
    std::rotate(terms.begin(), terms.end() - 1, terms.end());  // 1 - e, not -e + 1
  for (const Tree& term : terms) add(term);
  return parenthesised(outer > of_sum, shown);
}

std::string print(const Tree& tree, Precedence outer) {
  switch (tree->kind) {
    case Kind::number:
      return print_number(tree->value, outer);
    case Kind::pi:
      return "pi";
    case Kind::symbol:
      return tree->name;
    case Kind::sum:
      return print_sum(tree, outer);
    case Kind::product:
      return print_product(tree, outer);
    case Kind::quotient:
      return parenthesised(outer > of_product, print(tree->parts[0], of_product) + "/" +
                                                   print(tree->parts[1], of_power));
    case Kind::power:
      return parenthesised(outer > of_power, print(tree->parts[0], of_primary) + "^" +
                                                 print(tree->parts[1], of_primary));
    case Kind::root: {
      const std::string inside = print(tree->parts[0], of_sum);
      if (tree->value == 2) return "sqrt(" + inside + ")";
      if (tree->value == 3) return "cbrt(" + inside + ")";
      return "root(" + inside + ", " + print_number(tree->value, of_sum) + ")";
    }
    case Kind::function:
      return tree->name + "(" + print(tree->parts[0], of_sum) + ")";
  }
  return {};
}

}  // namespace

Tree number(const cln::cl_RA& value) { return make({.kind = Kind::number, .value = value}); }
Tree pi() { return make({.kind = Kind::pi}); }
Tree symbol(const std::string& name) {
  return make({.kind = Kind::symbol, .name = name, .is_constant = false});
}
Tree sum(const std::vector<Tree>& parts) { return make({.kind = Kind::sum, .parts = parts}); }
Tree product(const std::vector<Tree>& parts) {
  return make({.kind = Kind::product, .parts = parts});
}
Tree quotient(const Tree& above, const Tree& below) {
  return make({.kind = Kind::quotient, .parts = {above, below}});
}
Tree power(const Tree& base, const Tree& exponent) {
  return make({.kind = Kind::power, .parts = {base, exponent}});
}
Tree root(const Tree& radicand, long order) {
  return make({.kind = Kind::root, .value = order, .parts = {radicand}});
}
Tree function(const std::string& name, const Tree& argument) {
  return make({.kind = Kind::function, .name = name, .parts = {argument}});
}
Tree difference(const Tree& left, const Tree& right) {
  return sum({left, product({number(-1), right})});
}

bool is_number(const Tree& tree) { return tree->kind == Kind::number; }
bool is_number(const Tree& tree, long value) { return is_number(tree) && tree->value == value; }
bool is_function(const Tree& tree, const char* name) {
  return tree->kind == Kind::function && tree->name == name;
}
bool is_integer(const cln::cl_RA& value) { return cln::denominator(value) == 1; }

bool identical(const Tree& left, const Tree& right) {
  if (left == right) return true;
  return left->kind == right->kind && left->size == right->size && left->value == right->value &&
         left->name == right->name &&
         std::equal(left->parts.begin(), left->parts.end(), right->parts.begin(),
                    right->parts.end(), identical);
}

void collect_symbols(const Tree& tree, std::set<std::string>& names) {
  if (tree->is_constant) return;
  if (tree->kind == Kind::symbol) names.insert(tree->name);
  for (const Tree& part : tree->parts) collect_symbols(part, names);
}

std::set<std::string> symbols_of(const Tree& tree) {
  std::set<std::string> names;
  collect_symbols(tree, names);
  return names;
}

Tree with_parts(const Tree& tree, std::vector<Tree> parts) {
  return make(
      {.kind = tree->kind, .value = tree->value, .name = tree->name, .parts = std::move(parts)});
}

Tree substituted(const Tree& tree, const std::string& name, const Tree& value) {
  if (tree->is_constant) return tree;
  if (tree->kind == Kind::symbol) return tree->name == name ? value : tree;
  std::vector<Tree> parts;
  parts.reserve(tree->parts.size());
  for (const Tree& part : tree->parts) parts.push_back(substituted(part, name, value));
  return with_parts(tree, std::move(parts));
}

std::string to_text(const Tree& tree) { return print(tree, of_sum); }

}  // namespace magicmass::equality
